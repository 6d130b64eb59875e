#include "incision/contact/settings.h"

#include <gtest/gtest.h>

#include "support/section.h"

namespace incision {
namespace {

TEST(ContactSettings, ArriveFromTheirSection) {
  const ContactSettings contact =
      parseContact(test::section("contact", "{ground: -0.5, obstacles: room.urdf, friction: 0.7, self: false}"));
  EXPECT_EQ(contact.ground, -0.5);
  EXPECT_EQ(contact.obstacles, "/folder/room.urdf");
  EXPECT_EQ(contact.friction, 0.7);
  EXPECT_FALSE(contact.self);
}

TEST(ContactSettings, BadValuesAreRefused) {
  test::expectRefused(parseContact, "contact",
                      {{"[0]", ": a list of 1"},
                       {"{ground: .inf}", ".ground"},
                       {"{ground: low}", ".ground"},
                       {"{friction: -0.1}", ".friction: '-0.1' (allowed: 0 to 10)"},
                       {"{friction: 11}", ".friction"},
                       {"{friction: .nan}", ".friction"},
                       {"{self: 1}", ".self"},
                       {"{obstacles: ''}", ".obstacles"},
                       {"{obstacles: 'http://a/b.urdf'}", ".obstacles"},
                       {"{grund: 0}", ".grund: unknown key, did you mean ground?"}});
}

}  // namespace
}  // namespace incision

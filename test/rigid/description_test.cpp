#include "incision/rigid/description.h"

#include <gtest/gtest.h>

#include "incision/base/input_error.h"

namespace incision {
namespace {

const std::string ROOM =
    "<robot name='r'>"
    "<link name='floor'><collision><geometry><mesh filename='a.stl'/></geometry></collision></link>"
    "<link name='post'><collision><geometry><box size='1 2 3'/></geometry></collision></link>"
    "<joint name='j' type='fixed'><origin xyz='0 0 2'/><parent link='floor'/><child link='post'/></joint></robot>";

TEST(Description, HoldsItsLinksByName) {
  const Description room = parseDescription(ROOM, "room.urdf");
  ASSERT_EQ(room.links.size(), 2u);
  EXPECT_EQ(room.link("post").pose.position, Vec3(0, 0, 2));
  EXPECT_EQ(room.link("post").solids.at(0).solid->drawing().size, Vec3(1, 2, 3));
  EXPECT_THROW(room.link("roof"), InputError);
}

TEST(Description, SolidsAreCheckedOnlyWhereTheyAreUsed) {
  const Description room = parseDescription(ROOM, "room.urdf");
  EXPECT_NO_THROW(checkSolid(room.link("post").solids.at(0), "here"));
  EXPECT_THROW(checkSolid(room.link("floor").solids.at(0), "here"), InputError);
}

}  // namespace
}  // namespace incision

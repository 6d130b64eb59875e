#include "incision/contact/obstacles.h"

#include <gtest/gtest.h>

#include "incision/base/input_error.h"

namespace incision {
namespace {

constexpr double ROUNDING = 1e-14;  // of coordinates below 10

std::string collision(const std::string& geometry, const std::string& origin = "") {
  return "<collision>" + origin + "<geometry>" + geometry + "</geometry></collision>";
}

std::string link(const std::string& name, const std::string& content) {
  return "<link name=\"" + name + "\">" + content + "</link>";
}

std::string joint(const std::string& parent, const std::string& child, const std::string& origin = "",
                  const std::string& type = "fixed") {
  static int count = 0;
  return "<joint name=\"" + std::to_string(count++) + "\" type=\"" + type + "\">" + origin + "<parent link=\"" +
         parent + "\"/><child link=\"" + child +
         "\"/><axis xyz=\"0 0 1\"/><limit effort=\"1\" velocity=\"1\"/></joint>";
}

std::string robot(const std::string& content) { return "<robot name=\"r\">" + content + "</robot>"; }

const std::string SPHERE = "<sphere radius=\"0.5\"/>";
// A quarter turn round z, which takes (x, y) to (−y, x).
const std::string QUARTER = "<origin xyz=\"1 0 0\" rpy=\"0 0 1.5707963267948966\"/>";

Obstacles load(const std::string& urdf) {
  ContactSettings settings;
  settings.obstacles = "room.urdf";
  return loadObstacles(settings, urdf, settings.obstacles);
}

// What is said of a description, and what urdfdom printed.
struct Said {
  std::string message, printed;
};
Said said(const std::string& urdf) {
  ::testing::internal::CaptureStderr();
  Said said;
  try {
    load(urdf);
  } catch (const InputError& error) {
    said.message = error.what();
  }
  said.printed = ::testing::internal::GetCapturedStderr();
  return said;
}

TEST(Obstacles, AreAllCollisionShapesOfAllLinks) {
  const Obstacles room =
      load(robot(link("floor", collision("<box size=\"1 2 3\"/>") + collision(SPHERE)) +
                 link("post", collision("<cylinder radius=\"0.1\" length=\"4\"/>")) + joint("floor", "post")));
  ASSERT_EQ(room.links.size(), 2u);
  EXPECT_EQ(room.links[0].name, "floor");
  EXPECT_EQ(room.links[1].name, "post");
  ASSERT_EQ(room.shapes.size(), 3u);
  const auto is = [&](int shape, Drawing::Primitive primitive, const Vec3& size, int link) {
    const Drawing drawing = room.shapes[shape].solid->drawing();
    return drawing.primitive == primitive && drawing.size == size && room.shapes[shape].link == link;
  };
  EXPECT_TRUE(is(0, Drawing::Primitive::BOX, Vec3(1, 2, 3), 0));
  EXPECT_TRUE(is(1, Drawing::Primitive::SPHERE, Vec3(1, 1, 1), 0));
  EXPECT_TRUE(is(2, Drawing::Primitive::CYLINDER, Vec3(0.2, 0.2, 4), 1));
}

TEST(Obstacles, StandWhereTheJointsPutThem) {
  const Obstacles room =
      load(robot(link("base", "") + link("arm", "") + link("hand", collision(SPHERE, "<origin xyz=\"0 0 2\"/>")) +
                 joint("base", "arm", QUARTER, "continuous") + joint("arm", "hand", QUARTER)));
  ASSERT_EQ(room.links.size(), 1u);
  EXPECT_EQ(room.links[0].name, "hand");
  EXPECT_LT((room.links[0].pose.position - Vec3(1, 1, 0)).norm(), ROUNDING);
  EXPECT_LT((room.links[0].pose.orientation * Vec3::UnitX() + Vec3::UnitX()).norm(), ROUNDING);
  ASSERT_EQ(room.shapes.size(), 1u);
  EXPECT_EQ(room.shapes[0].pose.position, Vec3(0, 0, 2));
}

TEST(Obstacles, GroundIsAHalfSpaceThatBelongsToNoLink) {
  ContactSettings settings;
  settings.ground = -0.25;
  const Obstacles obstacles = loadObstacles(settings, "", "");
  EXPECT_TRUE(obstacles.links.empty());
  ASSERT_EQ(obstacles.shapes.size(), 1u);
  EXPECT_EQ(obstacles.shapes[0].solid->drawing().primitive, Drawing::Primitive::HALF_SPACE);
  EXPECT_EQ(obstacles.shapes[0].pose.position, Vec3(0, 0, -0.25));
  EXPECT_EQ(obstacles.shapes[0].link, GROUND_LINK);
}

TEST(Obstacles, NoneAreNeeded) { EXPECT_TRUE(loadObstacles({}, "", "").shapes.empty()); }

struct BadDescription {
  std::string urdf, message;
};

// Prints the description where a test fails.
std::ostream& operator<<(std::ostream& out, const BadDescription& bad) { return out << bad.urdf.substr(0, 1000); }

BadDescription inCollision(const std::string& geometry, const std::string& message, const std::string& origin = "") {
  return {robot(link("post", collision(geometry, origin))), "room.urdf: link 'post'" + message};
}

class RefusedObstacles : public ::testing::TestWithParam<BadDescription> {};

TEST_P(RefusedObstacles, AreNamedInOneLineAndNothingElseIsPrinted) {
  const Said said = incision::said(GetParam().urdf);
  EXPECT_EQ(said.message.find(GetParam().message), 0u) << said.message;
  EXPECT_EQ(said.message.find('\n'), std::string::npos) << said.message;
  EXPECT_EQ(said.printed, "");
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, RefusedObstacles,
    ::testing::Values(
        inCollision(
            "<mesh filename=\"a.stl\"/>",
            ": mesh 'a.stl' is relative, and the description comes from no file (allowed: package://NAME/FILE or "
            "an absolute path)"),
        inCollision("<mesh filename=\"model://a.stl\"/>",
                    ": mesh 'model://a.stl' (allowed: package://NAME/FILE or a path)"),
        inCollision("<mesh filename=\"package://no_such_package/a.stl\"/>", ": mesh package no_such_package not found"),
        inCollision("<mesh filename=\"/no/such/a.stl\"/>", ": mesh /no/such/a.stl: cannot be opened: No such file"),
        inCollision("<mesh filename=\"file:///tmp\"/>", ": mesh /tmp: a folder (allowed: a file)"),
        inCollision("<mesh filename=\"/etc/passwd\"/>",
                    ": mesh /etc/passwd is of no format that is read (allowed: .stl, .obj or .dae)"),
        inCollision("<mesh filename=\"/etc/passwd\" scale=\"1 0 1\"/>",
                    ": mesh /etc/passwd has the scale 0 (allowed: 1e-09 to 1e+09, or minus that)"),
        inCollision("<mesh/>", ": a collision shape cannot be read"),
        inCollision("<sphere radius=\"-1\"/>", ": the sphere's radius -1 (allowed: 1e-06 to 1e+06 m)"),
        inCollision("<sphere radius=\"0\"/>", ": the sphere's radius 0 (allowed"),
        inCollision("<sphere radius=\"1e7\"/>", ": the sphere's radius 1e+07 (allowed"),
        inCollision("<sphere radius=\"nan\"/>", ": a collision shape cannot be read: radius [nan]"),
        inCollision("<sphere radius=\"inf\"/>", ": a collision shape cannot be read: radius [inf]"),
        inCollision("<sphere radius=\"1e999\"/>", ": a collision shape cannot be read: radius [1e999]"),
        inCollision("<sphere/>", ": a collision shape cannot be read: Sphere shape must have a radius"),
        inCollision("<cone radius=\"1\"/>", ": a collision shape cannot be read: Unknown geometry type 'cone'"),
        inCollision("<capsule radius=\"1\"/>", ": a collision shape cannot be read: Cylinder shape must have both"),
        inCollision("<capsule radius=\"0\" length=\"1\"/>", ": the capsule's radius 0 (allowed"),
        inCollision("<sphere radius=\"%n%n\"/>", ": a collision shape cannot be read"),
        inCollision("<box size=\"1 0 1\"/>", ": the box's size 0 (allowed"),
        inCollision("<box size=\"1 1\"/>", ": a collision shape cannot be read: Parser found 2 elements but 3"),
        inCollision("<cylinder radius=\"0\" length=\"1\"/>", ": the cylinder's radius 0 (allowed"),
        inCollision("<cylinder radius=\"1\" length=\"-1\"/>", ": the cylinder's length -1 (allowed"),
        inCollision(SPHERE, ": the collision stands at 2e+06 (allowed: -1e+06 to 1e+06 m)",
                    "<origin xyz=\"0 2e6 0\"/>"),
        inCollision(SPHERE, ": a collision shape cannot be read: Unable to parse", "<origin xyz=\"nan 0 0\"/>"),
        inCollision(SPHERE, ": a collision shape cannot be read: Unable to parse", "<origin rpy=\"inf 0 0\"/>"),
        BadDescription{
            robot(link("a", "") + link("b", collision(SPHERE)) + joint("a", "b", "<origin xyz=\"-1e300 0 0\"/>")),
            "room.urdf: link 'b' stands at -1e+300 (allowed"}));

INSTANTIATE_TEST_SUITE_P(
    Texts, RefusedObstacles,
    ::testing::Values(
        BadDescription{"", "room.urdf: not a robot description"},
        BadDescription{"no xml at all", "room.urdf: not a robot description"},
        BadDescription{"<robot name=\"r\"><link \xf1", "room.urdf: not a robot description"},
        BadDescription{robot(link("a", "")), "room.urdf: 0 collision shapes (allowed: 1 to 1000)"},
        BadDescription{std::string((std::size_t{1} << 20) + 1, ' '), "room.urdf: the description is too large"},
        BadDescription{robot(link("a", "") + link("b", "") + joint("a", "b", "<origin xyz=\"nan 0 0\"/>")),
                       "room.urdf: not a robot description: Unable to parse component [nan]"},
        BadDescription{
            robot(link("a", "") + link("b", "") + link("c", "") + joint("a", "b") + joint("a", "c") + joint("b", "c")),
            "room.urdf: link 'c': two parents"},
        BadDescription{robot(link("a", "") + link("b", "") + link("c", "") + joint("b", "c") + joint("c", "b")),
                       "room.urdf: link 'b': joints that go in a circle"}));

TEST(Obstacles, DeepNestingDoesNotExhaustTheStack) {
  std::string nested;
  for (int i = 0; i < 300'000; ++i) nested += "<a>";
  EXPECT_NE(said("<robot name=\"r\">" + nested).message.find("elements (allowed: up to 10000)"), std::string::npos);
}

TEST(Obstacles, MoreThanTheLimitAreRefused) {
  std::string collisions;
  for (std::size_t i = 0; i < MAX_OBSTACLES; ++i) collisions += collision(SPHERE);
  EXPECT_EQ(load(robot(link("a", collisions))).shapes.size(), MAX_OBSTACLES);
  EXPECT_NE(said(robot(link("a", collisions + collision(SPHERE)))).message.find("1001 collision shapes"),
            std::string::npos);
}

}  // namespace
}  // namespace incision

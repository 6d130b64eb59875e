#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <memory>

#include "support/contacts.h"
#include "support/mesh_folder.h"
#include "support/solid_meshes.h"

namespace incision::test {
namespace {

/// A block of 0.15 by 0.15 by 0.1 m, its lower face at z = 0, that lies on a shape and has come to rest there.
std::unique_ptr<DeformableBody> atRestOn(const std::string& shape, const std::string& xyz,
                                         const std::string& rpy = "0 0 0") {
  Scene scene = blockAbove(0, {3, 3, 2}, Vec3(-0.075, -0.075, 0));
  scene.contact->ground.reset();
  scene.solver.time_step = 0.01;
  std::unique_ptr<DeformableBody> body(new DeformableBody(bodyAmong(scene, urdfOf(shape, xyz, rpy))));
  for (int k = 0; k < 150; ++k) body->step();
  return body;
}

double farthestApart(const DeformableBody& a, const DeformableBody& b) {
  double farthest = 0;
  for (std::size_t c = 0; c < a.positions().size(); ++c)
    farthest = std::max(farthest, (a.positions()[c] - b.positions()[c]).norm());
  return farthest;
}

void expectTheSameRest(const std::string& shape, const std::string& mesh, const std::string& xyz,
                       const std::string& rpy = "0 0 0") {
  const auto on_shape = atRestOn(shape, xyz, rpy), on_mesh = atRestOn(mesh, xyz, rpy);
  EXPECT_EQ(on_mesh->step().contact.count, on_shape->step().contact.count);
  EXPECT_LT(farthestApart(*on_shape, *on_mesh), 0.01 * ELEMENT) << shape;
}

TEST(MeshObstacles, LetABlockRestAsOnTheSolidsTheyAreLike) {
  const MeshFolder meshes("rest");
  expectTheSameRest("<box size='0.2 0.3 0.4'/>", meshes.shape("box.stl", asBinaryStl(boxMesh(Vec3(0.2, 0.3, 0.4)))),
                    "0.05 0 -0.2");
  expectTheSameRest("<sphere radius='0.5'/>", meshes.shape("sphere.obj", asObj(sphereMesh(0.5, 60))), "0 0 -0.5");
  expectTheSameRest("<cylinder radius='0.5' length='0.6'/>",
                    meshes.shape("cylinder.dae", asCollada(cylinderMesh(500, 600, 120), 0.001)), "0 0 -0.5",
                    "1.5707963267948966 0 0");
}

TEST(MeshObstacles, LetABlockRestOnACapsuleAsOnItsCylinder) {
  const auto on_cylinder = atRestOn("<cylinder radius='0.5' length='0.6'/>", "0 0 -0.5", "1.570796327 0 0"),
             on_capsule = atRestOn("<capsule radius='0.5' length='0.6'/>", "0 0 -0.5", "1.570796327 0 0");
  EXPECT_LT(farthestApart(*on_cylinder, *on_capsule), 1e-9);
}

/// A ditch along y, this wide inside and as deep, whose floor is at z = 0 [m].
TriangleMesh ditchMesh(double width, double depth, double wall) {
  const double a = width / 2, b = a + wall;
  TriangleMesh mesh =
      prismMesh({{-b, -wall}, {b, -wall}, {b, depth}, {a, depth}, {a, 0}, {-a, 0}, {-a, depth}, {-b, depth}},
                {{0, 1, 4}, {0, 4, 5}, {1, 2, 3}, {1, 3, 4}, {0, 5, 6}, {0, 6, 7}}, -0.3, 0.3);
  for (Vec3& vertex : mesh.vertices) vertex = Vec3(vertex.x(), -vertex.z(), vertex.y());
  return mesh;
}

TEST(MeshObstacles, AreEnteredWhereTheyAreHollow) {
  const MeshFolder meshes("ditch");
  const auto body = atRestOn(meshes.shape("ditch.stl", asBinaryStl(ditchMesh(0.16, 0.3, 0.05))), "0 0 0");
  const auto on_floor = atRestOn("<box size='1 1 0.1'/>", "0 0 -0.05");
  EXPECT_LT(farthestApart(*body, *on_floor), 0.01 * ELEMENT);
}

// Both walls of a ditch come to a point of the body in turn, nearer to one another than what counts as a touch reaches:
// the point must not be taken to have gone through the wall it touched before.
TEST(MeshObstacles, WallsThatFaceEachOtherPushAPointBetweenThemToAndFro) {
  const MeshFolder meshes("walls");
  Scene scene = blockAbove(0, {1, 1, 1}, Vec3::Zero());
  scene.contact->ground.reset();
  scene.gravity.setZero();
  scene.boundary = {{{Vec3(-1, -1, 0.039), Vec3(1, 1, 1)}, Vec3::Zero()}};
  scene.contact->obstacles = "walls.urdf";
  TetMesh point;  // down, between walls 6 mm apart
  point.nodes = {{0, 0, 0}, {0.02, 0, 0.04}, {-0.02, 0.02, 0.04}, {-0.02, -0.02, 0.04}};
  point.elements = {{0, 1, 2, 3}};
  if (elementVolume(point, 0) < 0) std::swap(point.elements[0][1], point.elements[0][2]);
  const std::string walls = meshes.shape("walls.stl", asBinaryStl(ditchMesh(0.006, 0.02, 0.1)));
  DeformableBody body(scene, point, {{}, urdfOf(walls, "0 0 -0.01")});
  double deepest = 0, left = 0, right = 0;
  for (int k = 0; k < 400; ++k) {
    Pose pose;
    pose.position.x() = 0.006 * std::sin(2 * M_PI * k / 100);
    body.moveObstacle(0, pose);
    deepest = std::max(deepest, body.step().contact.deepest);
    left = std::min(left, body.positions()[0].x());
    right = std::max(right, body.positions()[0].x());
  }
  EXPECT_LT(deepest, 1e-4);
  EXPECT_NEAR(left, -0.003, 2e-4);
  EXPECT_NEAR(right, 0.003, 2e-4);
}

// A table, and on it an arm of several formats, joints, paths and units.
TEST(MeshObstacles, ARobotOfMeshesLoadsAndTouches) {
  const MeshFolder folder("robot");
  folder.shape("arm_robot/meshes/base.dae", asCollada(cylinderMesh(80, 100, 32), 0.001));
  folder.shape("arm_robot/meshes/link.STL", asTextStl(boxMesh(Vec3(60, 60, 200), Vec3(0, 0, 100))));
  folder.shape("arm_robot/meshes/hand.obj", asObj(angleMesh()));
  folder.shape("arm_robot/table.stl", asBinaryStl(boxMesh(Vec3(1, 1, 0.04))));
  std::ofstream(folder.at("arm_robot/package.xml")) << "<package><name>arm_robot</name></package>";
  const auto link = [](const std::string& name, const std::string& shape, const std::string& origin = "0 0 0") {
    return "<link name='" + name + "'><visual><geometry><mesh filename='package://gone/x.dae'/></geometry></visual>" +
           "<collision><origin xyz='" + origin + "'/><geometry>" + shape + "</geometry></collision></link>";
  };
  const auto joint = [](const std::string& parent, const std::string& child, const std::string& origin) {
    return "<joint name='" + child + "_joint' type='revolute'><origin " + origin + "/><parent link='" + parent +
           "'/><child link='" + child +
           "'/><axis xyz='0 1 0'/><limit lower='-3' upper='3' effort='1' velocity='1'/></joint>";
  };
  const std::string urdf =
      "<robot name='arm'>" + link("table", "<mesh filename='table.stl'/>", "0 0 -0.02") +
      link("base", "<mesh filename='package://arm_robot/meshes/base.dae'/>", "0 0 0.05") +
      link("upper", "<mesh filename='package://arm_robot/meshes/link.STL' scale='0.001 0.001 0.001'/>") +
      link("lower", "<mesh filename='package://arm_robot/meshes/link.STL' scale='0.001 -0.001 0.001'/>") +
      link("hand", "<mesh filename='meshes/hand.obj' scale='0.1 0.1 0.1'/>") +
      link("finger", "<capsule radius='0.01' length='0.05'/>") + joint("table", "base", "xyz='-0.3 0 0'") +
      joint("base", "upper", "xyz='0 0 0.1'") + joint("upper", "lower", "xyz='0 0 0.2' rpy='0 1.5707963267948966 0'") +
      joint("lower", "hand", "xyz='0 0 0.2' rpy='0 1.5707963267948966 0'") + joint("hand", "finger", "xyz='0.05 0 0'") +
      "</robot>";
  const std::string file = folder.at("arm_robot/arm.urdf");
  std::ofstream(file) << urdf;
  setenv("ROS_PACKAGE_PATH", folder.at("").c_str(), 1);
  // On the table, under the hand, which lies 0.26 m above it.
  Scene scene = blockAbove(0, {2, 2, 4}, Vec3(-0.15, -0.05, 0.01));
  scene.contact->ground.reset();
  scene.contact->obstacles = file;
  DeformableBody body(scene, loadMesh(scene), {{}, urdf});
  unsetenv("ROS_PACKAGE_PATH");
  ASSERT_EQ(body.obstacles().links.size(), 6u);
  for (int k = 0; k < 300; ++k) body.step();
  EXPECT_EQ(body.step().contact.count, 9);
  double lowest = 1;
  for (const Vec3& x : body.positions()) lowest = std::min(lowest, x.z());
  EXPECT_NEAR(lowest, 0, 0.01 * ELEMENT);
  // The hand comes down on it.
  const Pose hand = body.obstacles().links[4].pose;
  EXPECT_EQ(body.obstacles().links[4].name, "hand");
  for (int k = 1; k <= 50; ++k) {
    Pose lower = hand;
    lower.position.z() -= 0.002 * k;
    body.moveObstacle(4, lower);
    body.step();
  }
  EXPECT_GT(body.step().contact.count, 9);
}

}  // namespace
}  // namespace incision::test

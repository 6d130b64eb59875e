#include "incision/rigid/description.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "incision/base/input_error.h"
#include "support/solid_meshes.h"

namespace incision::test {
namespace {

const std::string ROOM =
    "<robot name='r'>"
    "<link name='floor'><collision><geometry><mesh filename='a.stl'/></geometry></collision></link>"
    "<link name='post'><collision><geometry><box size='1 2 3'/></geometry></collision></link>"
    "<joint name='j' type='fixed'><origin xyz='0 0 2'/><parent link='floor'/><child link='post'/></joint></robot>";

std::string linkOf(const std::string& name, const std::string& shape) {
  return "<link name='" + name + "'><collision><geometry>" + shape + "</geometry></collision></link>";
}

std::string oneLink(const std::string& shapes) { return "<robot name='r'>" + shapes + "</robot>"; }

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

std::string refusal(const std::string& urdf) {
  try {
    parseDescription(urdf, "tool.urdf");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

constexpr const char* LINKS =
    "<link name='palm'/><link name='left'/><link name='right'/><link name='tip'/><link name='shaft'/>";

const std::string FORCEPS =
    std::string("<robot name='f'>") + LINKS +
    "<joint name='jaw' type='revolute'><origin xyz='0 0 1'/><parent link='palm'/><child link='left'/><axis xyz='0 2 "
    "0'/>"
    "<limit lower='-0.1' upper='1' effort='1' velocity='1'/></joint>"
    "<joint name='other' type='continuous'><parent link='palm'/><child link='right'/><axis xyz='0 1 0'/>"
    "<mimic joint='jaw' multiplier='-1' offset='0.25'/></joint>"
    "<joint name='glue' type='fixed'><parent link='left'/><child link='tip'/></joint>"
    "<joint name='slide' type='prismatic'><parent link='shaft'/><child link='palm'/><axis xyz='0 0 1'/>"
    "<limit lower='0' upper='0.2' effort='1' velocity='1'/></joint></robot>";

TEST(Description, HoldsTheJointsBetweenItsLinks) {
  const Description forceps = parseDescription(FORCEPS, "tool.urdf");
  ASSERT_EQ(forceps.joints.size(), 4u);
  for (const DescribedJoint& joint : forceps.joints) EXPECT_LT(joint.parent, joint.child);
  const DescribedJoint& jaw = forceps.joints[forceps.jointIndex("jaw")];
  EXPECT_EQ(jaw.kind, JointKind::REVOLUTE);
  EXPECT_EQ(forceps.links[jaw.parent].name, "palm");
  EXPECT_EQ(forceps.links[jaw.child].name, "left");
  EXPECT_EQ(jaw.origin.position, Vec3(0, 0, 1));
  EXPECT_EQ(jaw.axis.normalized(), Vec3::UnitY());
  EXPECT_FALSE(jaw.mimic);
  ASSERT_TRUE(jaw.limits);
  EXPECT_EQ((*jaw.limits)[0], -0.1);
  const DescribedJoint& other = forceps.joints[forceps.jointIndex("other")];
  EXPECT_EQ(other.kind, JointKind::REVOLUTE);
  EXPECT_FALSE(other.limits);
  ASSERT_TRUE(other.mimic);
  EXPECT_EQ(other.mimic->joint, "jaw");
  EXPECT_EQ(other.mimic->multiplier, -1);
  EXPECT_EQ(other.mimic->offset, 0.25);
  EXPECT_EQ(forceps.joints[forceps.jointIndex("slide")].kind, JointKind::PRISMATIC);
}

TEST(Description, SaysWhichLinksAndJointsThereAreWhereOneIsNot) {
  const Description forceps = parseDescription(FORCEPS, "tool.urdf");
  const auto refusalOf = [&](const auto& ask) -> std::string {
    try {
      ask();
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusalOf([&] { forceps.link("palms"); }),
            "tool.urdf: link 'palms' does not exist, did you mean palm? (allowed: shaft, palm, left, right, tip)");
  EXPECT_EQ(refusalOf([&] { forceps.jointIndex("grip"); }),
            "tool.urdf: joint 'grip' does not exist (allowed: slide, jaw, other)");
  EXPECT_EQ(refusalOf([&] { parseDescription(ROOM, "room.urdf").jointIndex("jaw"); }),
            "room.urdf: joint 'jaw' does not exist (allowed: none, no joint of it moves)");
}

TEST(Description, OfXacroIsRefusedAndOneMadeByItIsNot) {
  const std::string declared = "<robot name='f' xmlns:xacro='http://www.ros.org/wiki/xacro'>";
  const std::string link = "<link name='a'/>",
                    refused =
                        "tool.urdf: a xacro file (allowed: a URDF; this makes one of it: xacro in.xacro > out.urdf)";
  EXPECT_EQ(refusal(declared + "<!-- <xacro:include/> -->" + link + "</robot>"), "");
  EXPECT_EQ(refusal(declared + "<xacro:property name='l' value='1'/>" + link + "</robot>"), refused);
  EXPECT_EQ(refusal("<robot name='f'>" + link +
                    "<link name='b'><visual><geometry><sphere radius='${r}'/></geometry>"
                    "</visual></link></robot>"),
            refused);
}

TEST(Description, HasCapsulesBesideOtherShapes) {
  const Description room = parseDescription(
      "<robot name='r &lt;1&gt;'><link name='arm &amp; hand'><collision><geometry><cylinder radius='1' length='2'/>"
      "</geometry></collision><collision><origin xyz='0 0 3'/><geometry><capsule radius='0.5' length='2'/></geometry>"
      "</collision><collision><geometry><drake:capsule radius='0.25' "
      "length='1'/></geometry></collision></link></robot>",
      "room.urdf");
  const auto& solids = room.link("arm & hand").solids;
  ASSERT_EQ(solids.size(), 3u);
  EXPECT_EQ(solids[0].solid->drawing().primitive, Drawing::Primitive::CYLINDER);
  EXPECT_EQ(solids[1].solid->drawing().primitive, Drawing::Primitive::CAPSULE);
  EXPECT_EQ(solids[1].solid->drawing().size, Vec3(1, 1, 3));
  EXPECT_EQ(solids[1].pose.position, Vec3(0, 0, 3));
  EXPECT_EQ(solids[2].solid->drawing().size, Vec3(0.5, 0.5, 1.5));
}

/// A folder with a description and a mesh, a box of 2 by 4 by 6, in a package.
class MeshesInDescriptions : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(::testing::TempDir()) / ("meshes_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_ / "box_robot/meshes");
    std::ofstream(folder_ / "box_robot/package.xml") << "<package><name>box_robot</name></package>";
    std::ofstream(folder_ / "box_robot/meshes/box.stl", std::ios::binary) << asBinaryStl(boxMesh(Vec3(2, 4, 6)));
    setenv("ROS_PACKAGE_PATH", folder_.c_str(), 1);
  }
  void TearDown() override {
    unsetenv("ROS_PACKAGE_PATH");
    std::filesystem::remove_all(folder_);
  }

  Description describe(const std::string& content) const {
    const std::string file = (folder_ / "box_robot/robot.urdf").string(), text = oneLink(content);
    std::ofstream(file) << text;
    return parseDescription(text, file);
  }
  SolidPtr mesh(const std::string& attributes) const {
    const DescribedSolid solid = describe(linkOf("box", "<mesh " + attributes + "/>")).link("box").solids.at(0);
    checkSolid(solid, "here");
    return solid.solid;
  }

  std::filesystem::path folder_;
};

TEST_F(MeshesInDescriptions, LieWhereThePathSays) {
  for (const std::string& path :
       {std::string("meshes/box.stl"), std::string("package://box_robot/meshes/box.stl"),
        (folder_ / "box_robot/meshes/box.stl").string(), "file://" + (folder_ / "box_robot/meshes/box.stl").string()})
    EXPECT_NEAR(mesh("filename='" + path + "'")->distanceTo(Vec3::Zero()).distance, -1, 1e-12) << path;
}

TEST_F(MeshesInDescriptions, AreDrawnFromTheirFile) {
  const Drawing of_package = mesh("filename='package://box_robot/meshes/box.stl' scale='1 2 3'")->drawing();
  EXPECT_EQ(of_package.primitive, Drawing::Primitive::MESH);
  EXPECT_EQ(of_package.file, "package://box_robot/meshes/box.stl");
  EXPECT_EQ(of_package.size, Vec3(1, 2, 3));
  EXPECT_EQ(mesh("filename='meshes/box.stl'")->drawing().file,
            "file://" + (folder_ / "box_robot/meshes/box.stl").string());
}

TEST_F(MeshesInDescriptions, AreScaledAndMirrored) {
  const SolidPtr box = mesh("filename='meshes/box.stl' scale='0.1 -0.2 0.05'");
  EXPECT_NEAR(box->reachAlong(Vec3::UnitX()), 0.1, 1e-9);
  EXPECT_NEAR(box->reachAlong(Vec3::UnitY()), 0.4, 1e-9);
  EXPECT_NEAR(box->reachAlong(Vec3::UnitZ()), 0.15, 1e-9);
  EXPECT_LT(box->distanceTo(Vec3::Zero()).distance, 0);
  EXPECT_GT(box->distanceTo(Vec3(0.2, 0, 0)).distance, 0);
}

TEST_F(MeshesInDescriptions, AreOneForAllThatHaveTheSameFileAndScale) {
  const std::string one = "<mesh filename='meshes/box.stl'/>",
                    other = "<mesh filename='meshes/box.stl' scale='1 1 2'/>";
  const Description robot = describe(linkOf("a", one) + linkOf("b", one) + linkOf("c", other) +
                                     "<joint name='j' type='fixed'><parent link='a'/><child link='b'/></joint>"
                                     "<joint name='k' type='fixed'><parent link='a'/><child link='c'/></joint>");
  const auto solid = [&](const std::string& link) { return robot.link(link).solids.at(0).solid; };
  EXPECT_EQ(solid("a"), solid("b"));
  EXPECT_NE(solid("a"), solid("c"));
}

TEST_F(MeshesInDescriptions, ThatAreMendedSaySo) {
  TriangleMesh open = boxMesh(Vec3(1, 1, 1));
  open.triangles.pop_back();
  std::ofstream(folder_ / "box_robot/meshes/open.obj") << asObj(open);
  EXPECT_EQ(mesh("filename='meshes/open.obj'")->remark(), "mesh meshes/open.obj: 1 hole closed, the widest 1.41421 m");
  EXPECT_EQ(mesh("filename='meshes/box.stl'")->remark(), "");
}

TEST_F(MeshesInDescriptions, AreReadAtTheFirstQuestionAndFaultsNameTheLink) {
  const DescribedSolid solid = describe(linkOf("box", "<mesh filename='gone.stl'/>")).link("box").solids.at(0);
  try {
    solid.solid->thickness();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("robot.urdf: link 'box': mesh "), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("gone.stl: cannot be opened"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace incision::test

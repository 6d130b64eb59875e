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

}  // namespace
}  // namespace incision

#include "incision/rigid/jaw_links.h"

#include <gtest/gtest.h>

#include "incision/base/input_error.h"
#include "incision/base/read_text.h"

namespace incision {
namespace {

std::string link(const std::string& name, bool has_shape = true) {
  return "<link name='" + name + "'>" +
         (has_shape ? "<collision><origin xyz='0.1 0 0'/><geometry><box size='0.2 0.1 0.1'/></geometry></collision>"
                    : "") +
         "</link>";
}

std::string joint(const std::string& name, const std::string& type, const std::string& parent, const std::string& child,
                  const std::string& more) {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" + child + "'/>" +
         more + "<limit lower='-1' upper='2' effort='1' velocity='1'/></joint>";
}

/// An arm that carries a palm with a finger fixed to it, and two jaws with a nail on the first.
Description gripper(const std::string& more = "") {
  const std::string text =
      "<robot name='r'>" + link("arm") + link("palm") + link("finger") + link("first") + link("nail") + link("second") +
      joint("wrist", "revolute", "arm", "palm", "<origin xyz='5 5 5'/><axis xyz='0 0 1'/>") +
      joint("glue", "fixed", "palm", "finger", "<origin xyz='0 1 0'/>") +
      joint("jaw", "revolute", "palm", "first",
            "<origin xyz='0 0 1' rpy='1.5707963267948966 0 0'/><axis xyz='0 0 3'/>") +
      joint("idle", "prismatic", "first", "nail", "<origin xyz='0.3 0 0'/><axis xyz='1 0 0'/>") +
      joint("other", "prismatic", "palm", "second",
            "<origin xyz='0 0 -1'/><axis xyz='0 0 1'/><mimic joint='jaw' multiplier='-0.5' offset='0.1'/>") +
      more + "</robot>";
  return parseDescription(text, "r.urdf");
}

TEST(JawLinks, MoveTogetherAsTheirJointsSay) {
  const JawLinks jaws(gripper(), "palm", "jaw");
  ASSERT_EQ(jaws.groups(), 3);
  EXPECT_EQ(jaws.solids(0).size(), 2u);  // the finger is fixed to the palm
  EXPECT_EQ(jaws.solids(1).size(), 2u);  // the nail stays where it is on the first jaw
  EXPECT_EQ(jaws.solids(2).size(), 1u);
  EXPECT_EQ(jaws.name(1), "first");
  EXPECT_LT((jaws.solids(0)[1].pose.position - Vec3(0.1, 1, 0)).norm(), 1e-15);
  EXPECT_LT((jaws.solids(1)[1].pose.position - Vec3(0.4, 0, 0)).norm(), 1e-15);
  EXPECT_EQ(jaws.pose(0, 0.7).position, Vec3::Zero());
  // The joint's axis z is −y of the palm, as the joint is turned by a right angle about x.
  const double q = 0.7;
  const Pose first = jaws.pose(1, q), second = jaws.pose(2, q);
  EXPECT_LT((first.position - Vec3(0, 0, 1)).norm(), 1e-15);
  EXPECT_LT((first.orientation * Vec3::UnitX() - Vec3(std::cos(q), 0, std::sin(q))).norm(), 1e-14);
  EXPECT_LT((second.position - Vec3(0, 0, -1 - 0.5 * q + 0.1)).norm(), 1e-15);
  EXPECT_EQ((*jaws.limits())[1], 2);
}

// The power of any wrench on a group is its effort times the rate of the angle.
TEST(JawLinks, EffortIsWhatAWrenchWouldDoWhileTheAngleGrows) {
  const JawLinks jaws(gripper(), "palm", "jaw");
  const Wrench wrench{Vec3(1, 2, 3), Vec3(-2, 0.5, 4)};
  const double q = 0.3, dq = 1e-5;
  for (int g = 0; g < 3; ++g) {
    const Pose before = jaws.pose(g, q - dq), after = jaws.pose(g, q + dq);
    const Eigen::AngleAxisd turn(after.orientation * before.orientation.conjugate());
    const Vec3 omega = turn.angle() * turn.axis();
    // Of the point of the group that is at the origin of the tool's link.
    const Vec3 moved = after.position - before.position + (-before.position).cross(-omega);
    EXPECT_NEAR(jaws.effort(g, wrench), (wrench.force.dot(moved) + wrench.torque.dot(omega)) / (2 * dq), 1e-8) << g;
  }
}

TEST(JawLinks, VelocityIsThatOfThePose) {
  const JawLinks jaws(gripper(), "palm", "jaw");
  const double h = 1e-5, q = 0.3;
  const Vec3 own(0.4, -0.2, 0.7);
  for (int group = 0; group < jaws.groups(); ++group) {
    const Vec3 moved = placed(own, jaws.pose(group, q + h)) - placed(own, jaws.pose(group, q - h));
    EXPECT_LT((jaws.velocity(group, placed(own, jaws.pose(group, q))) - moved / (2 * h)).norm(), 1e-9) << group;
  }
}

TEST(JawLinks, ClosingGoesRoundTheFirstJawsAxis) {
  const JawLinks jaws(gripper(), "palm", "jaw");
  EXPECT_LT((jaws.closing(Vec3(0.5, 0.2, 1)).normalized() - Vec3::UnitZ()).norm(), 1e-14);
}

TEST(JawLinks, OfTheForcepsAreAMillimetreApartAtZeroAndOpenBothWays) {
  const std::string path = std::string(INCISION_SOURCE_DIR) + "/config/forceps.urdf";
  const JawLinks jaws(parseDescription(readText(path, 1 << 20), "forceps.urdf"), "palm", "jaw");
  ASSERT_EQ(jaws.groups(), 3);
  const auto tip = [&](int group, double z, double q) -> Vec3 {
    const Pose pose = jaws.pose(group, q);
    return placed(Vec3(0.02, 0, z), pose);
  };
  EXPECT_NEAR(tip(1, 0.0005, 0).z() - tip(2, -0.0005, 0).z(), 0.001, 1e-15);
  EXPECT_NEAR(tip(1, 0.0005, 0.2).z(), -tip(2, -0.0005, 0.2).z(), 1e-15);
  EXPECT_GT(tip(1, 0.0005, 0.2).z(), 0.004);
}

std::string refusal(const Description& description, const std::string& link, const std::string& joint) {
  try {
    JawLinks(description, link, joint);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(JawLinks, AreRefusedWhereTheyAreNoJaws) {
  EXPECT_EQ(refusal(gripper(), "palms", "jaw").find("r.urdf: link 'palms' does not exist"), 0u);
  EXPECT_EQ(refusal(gripper(), "palm", "jaws").find("r.urdf: joint 'jaws' does not exist, did you mean jaw?"), 0u);
  EXPECT_EQ(refusal(gripper(), "finger", "jaw"), "r.urdf: joint 'jaw' is not below link 'finger'");
  EXPECT_EQ(refusal(gripper(), "palm", "wrist"), "r.urdf: joint 'wrist' is not below link 'palm'");
  EXPECT_EQ(refusal(gripper(), "palm", "glue"),
            "r.urdf: joint 'glue' neither turns nor slides (allowed: a revolute, continuous or prismatic joint)");
  EXPECT_EQ(refusal(gripper(), "palm", "other"),
            "r.urdf: joint 'other' goes with joint 'jaw' (allowed: a joint that goes by itself)");
  const std::string third =
      link("third") + joint("more", "revolute", "palm", "third", "<axis xyz='1 0 0'/><mimic joint='other'/>");
  EXPECT_EQ(refusal(gripper(third), "palm", "jaw"),
            "r.urdf: joint 'jaw' moves 3 links with collision shapes (allowed: 1 to 2)");
  const std::string nested =
      link("tip") + joint("knuckle", "revolute", "second", "tip", "<axis xyz='1 0 0'/><mimic joint='jaw'/>");
  EXPECT_EQ(refusal(gripper(nested), "palm", "jaw"),
            "r.urdf: joint 'knuckle' hangs on another joint that moves (allowed: one on the tool's link)");
  const auto withJaw = [](const std::string& more, bool has_shape = true) {
    return parseDescription("<robot name='r'>" + link("palm") + link("a", has_shape) +
                                joint("jaw", "revolute", "palm", "a", more) + "</robot>",
                            "r.urdf");
  };
  EXPECT_EQ(refusal(withJaw("<axis xyz='0 0 0'/>"), "palm", "jaw"),
            "r.urdf: joint 'jaw': an axis of length 0.000000 (allowed: 1e-06 and more)");
  EXPECT_EQ(refusal(withJaw("<axis xyz='0 0 1'/>", false), "palm", "jaw"),
            "r.urdf: joint 'jaw' moves 0 links with collision shapes (allowed: 1 to 2)");
  EXPECT_EQ(refusal(withJaw("<axis xyz='0 0 1'/>"), "palm", "jaw"), "");
}

// Joints that mimic each other in a circle follow nothing.
TEST(JawLinks, ACircleOfMimicsStandsStill) {
  const std::string circle = link("x") + link("y") +
                             joint("jx", "revolute", "palm", "x", "<axis xyz='1 0 0'/><mimic joint='jy'/>") +
                             joint("jy", "revolute", "palm", "y", "<axis xyz='1 0 0'/><mimic joint='jx'/>");
  EXPECT_EQ(JawLinks(gripper(circle), "palm", "jaw").groups(), 3);
  const std::string lost =
      link("x") + joint("jx", "revolute", "palm", "x", "<axis xyz='1 0 0'/><mimic joint='nobody'/>");
  EXPECT_EQ(refusal(gripper(lost), "palm", "jaw").find("r.urdf: joint 'nobody' does not exist"), 0u);
}

}  // namespace
}  // namespace incision

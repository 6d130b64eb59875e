#include "incision/rigid/jaw_links.h"

#include <cmath>
#include <utility>

#include "incision/base/input_error.h"
#include "incision/base/printable.h"

namespace incision {
namespace {

/// What an axis must be long at least: a direction is read from it.
constexpr double SHORTEST_AXIS = 1e-6;

/// How a joint goes with the one that drives a jaw.
struct Course {
  double multiplier = 1, offset = 0;
};

}  // namespace

/// Goes down the tree from the tool's link and gathers what moves together.
class JawLinks::Builder {
 public:
  Builder(const Description& description, int link, int driver)
      : description_(description), driver_(driver), place_(description.links.size()) {
    groups_.push_back({description.links[link].name});
    place_[link] = Place{0, Pose()};
    addSolids(link);
    for (std::size_t j = 0; j < description.joints.size(); ++j) follow(static_cast<int>(j));
    if (!place_[description.joints[driver].parent]) fail(driver, " is not below link '" + groups_[0].link + "'");
  }

  /// Group 0 and the jaws that have shapes.
  std::vector<Group> groups() {
    std::vector<Group> kept;
    for (Group& group : groups_)
      if (kept.empty() || !group.solids.empty()) kept.push_back(std::move(group));
    const int jaws = static_cast<int>(kept.size()) - 1;
    if (jaws < 1 || jaws > MOST_JAWS)
      fail(driver_, " moves " + std::to_string(jaws) + " links with collision shapes (allowed: 1 to " +
                        std::to_string(MOST_JAWS) + ")");
    return kept;
  }

 private:
  /// Where a link is: in which group, and where in its frame.
  struct Place {
    int group;
    Pose pose;
  };

  [[noreturn]] void fail(int joint, const std::string& reason) const {
    throw InputError(jointInMessage(description_.name, description_.joints[joint].name) + reason);
  }

  /// The child of a joint goes with its parent, or begins a group. Parents come before their children.
  void follow(int index) {
    const DescribedJoint& joint = description_.joints[index];
    if (!place_[joint.parent]) return;
    const Place parent = *place_[joint.parent];
    checkPose(joint.origin, jointInMessage(description_.name, joint.name));
    const Pose origin = composed(parent.pose, joint.origin);
    const std::optional<Course> course = courseOf(index);
    if (!course) {
      place_[joint.child] = Place{parent.group, origin};
    } else {
      if (parent.group != 0) fail(index, " hangs on another joint that moves (allowed: one on the tool's link)");
      place_[joint.child] = Place{static_cast<int>(groups_.size()), Pose()};
      const Vec3 axis = origin.orientation * axisOf(index);
      groups_.push_back(
          {description_.links[joint.child].name, {}, joint.kind, course->multiplier, course->offset, origin, axis});
    }
    addSolids(joint.child);
  }

  Vec3 axisOf(int index) const {
    const Vec3& axis = description_.joints[index].axis;
    const double length = axis.norm();
    if (!(length >= SHORTEST_AXIS) || !std::isfinite(length))
      fail(index, ": an axis of length " + std::to_string(length) + " (allowed: 1e-06 and more)");
    return axis / length;
  }

  /// How a joint goes with the driver; none where it does not.
  std::optional<Course> courseOf(int index) const {
    const std::vector<DescribedJoint>& joints = description_.joints;
    Course course;
    int at = index;
    // A chain of joints that mimic each other is no longer than there are joints, or goes in a circle.
    for (std::size_t k = 0; k <= joints.size() && at != driver_; ++k) {
      if (!joints[at].mimic) return std::nullopt;
      const DescribedJoint::Mimic& mimic = *joints[at].mimic;
      course.offset += course.multiplier * mimic.offset;
      course.multiplier *= mimic.multiplier;
      at = description_.jointIndex(mimic.joint);
    }
    if (at != driver_) return std::nullopt;
    if (joints[index].kind != JointKind::REVOLUTE && joints[index].kind != JointKind::PRISMATIC)
      fail(index, " neither turns nor slides (allowed: a revolute, continuous or prismatic joint)");
    if (!(std::abs(course.multiplier) > 0) || !std::isfinite(course.multiplier) || !std::isfinite(course.offset))
      fail(index, ": mimics with multiplier " + std::to_string(course.multiplier) + " and offset " +
                      std::to_string(course.offset) + " (allowed: finite numbers, a multiplier that is not 0)");
    return course;
  }

  void addSolids(int link) {
    const DescribedLink& described = description_.links[link];
    const std::string where = linkInMessage(description_.name, described.name);
    if (!described.fault.empty()) throw InputError(where + ": " + described.fault);
    for (const DescribedSolid& solid : described.solids) {
      checkSolid(solid, where);
      groups_[place_[link]->group].solids.push_back({solid.solid, composed(place_[link]->pose, solid.pose)});
    }
  }

  const Description& description_;
  int driver_;
  std::vector<std::optional<Place>> place_;  // of each link; none: it is not below the tool's link
  std::vector<Group> groups_;
};

JawLinks::JawLinks(const Description& description, const std::string& link, const std::string& joint) {
  const int tool = description.linkIndex(link), driver = description.jointIndex(joint);
  const DescribedJoint& described = description.joints[driver];
  if (described.mimic)
    throw InputError(jointInMessage(description.name, joint) + " goes with joint '" +
                     printable(described.mimic->joint) + "' (allowed: a joint that goes by itself)");
  groups_ = Builder(description, tool, driver).groups();
  limits_ = described.limits;
}

Pose JawLinks::pose(int group, double angle) const {
  const Group& g = groups_[group];
  const double q = g.multiplier * angle + g.offset;
  if (g.kind == JointKind::PRISMATIC) return {g.origin.position + q * g.axis, g.origin.orientation};
  if (g.kind != JointKind::REVOLUTE) return g.origin;
  return {g.origin.position, (Eigen::AngleAxisd(q, g.axis) * g.origin.orientation).normalized()};
}

Vec3 JawLinks::velocity(int group, const Vec3& point) const {
  return groups_[group].multiplier * groups_[group].course(point);
}

Vec3 JawLinks::closing(const Vec3& point) const { return groups_[1].course(point); }

double JawLinks::effort(int group, const Wrench& wrench) const {
  const Group& g = groups_[group];
  if (g.kind == JointKind::FIXED) return 0;
  const Vec3& acts = g.kind == JointKind::PRISMATIC ? wrench.force : about(g.origin.position, wrench).torque;
  return g.multiplier * g.axis.dot(acts);
}

}  // namespace incision

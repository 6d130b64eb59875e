#pragma once

#include <limits>
#include <vector>

#include "incision/base/range.h"
#include "incision/contact/obstacles.h"

namespace incision {

/// What a tool is made of, for those who draw it or lead it. What moves together is a group: the tool's link is the
/// first, jaws are the others.
struct ToolForm {
  /// A cutting edge in the frame of the group that it belongs to.
  struct GroupEdge {
    int group;
    Edge edge;
  };
  int groups = 1;
  Obstacles shapes;  ///< the link of each is its group
  std::vector<GroupEdge> edges;
  Edge extent = {Vec3::Zero(), Vec3::Zero()};  ///< two points of its link: hardly anything of it moves farther
  Range jaw;                                   ///< where its joint can go, if it has one [rad]
};

}  // namespace incision

#pragma once

#include <vector>

#include "incision/contact/candidate.h"
#include "incision/contact/contact_surface.h"
#include "incision/contact/obstacles.h"

namespace incision {

/// Where the links of the obstacles stand when a step starts and when it ends; between, they move evenly.
struct LinkMotion {
  std::vector<Pose> from, to;
  bool has_tool = false;  ///< the tool has a pose; without, its shapes are not there
  bool cuts = true;       ///< the tool's edge does, and so its shapes give way near it
};

/// Candidates of the surface's vertices against each obstacle, for a step of `time_step` [s] from positions `x` [m] and
/// velocities `v` [m/s] of the vertices, appended in the order of the obstacles and then of the vertices. The plane of
/// a candidate is the obstacle's at the point of it that is nearest when the step starts, carried along with it: a body
/// that starts on one side stays there, however fast it is and however thin the obstacle: `touches`, the contacts of
/// the last step, tell on which side points are that have been pressed in.
///
/// A vertex that comes to lie in the tool's body goes to the side of its own material, as the two faces of a slit do in
/// which a blade stands. Where a shape of the tool is nearer to the cutting edge than it is thick, the edge cuts
/// instead of pushing, and there is no candidate.
void findObstacleContacts(const ContactSurface& surface, const std::vector<Vec3>& x, const std::vector<Vec3>& v,
                          double time_step, double stiffness, const Obstacles& obstacles, const LinkMotion& motion,
                          const std::vector<Touch>& touches, std::vector<Candidate>* candidates);

}  // namespace incision

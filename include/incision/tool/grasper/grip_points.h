#pragma once

#include <vector>

#include "incision/rigid/pose.h"
#include "incision/tool/grasper/mouth.h"
#include "incision/tool/material_point.h"

namespace incision {

/// A place in the mouth of jaws where they hold what is there.
struct GripPoint {
  Vec3 anchor = Vec3::Zero();  ///< in the frame of the tool's link [m]
  MaterialPoint held;          ///< what is tied to it,
  Vec3 end = Vec3::Zero();  ///< by a spring that ends here, which is beside the anchor where it had to lose force [m]
  double stiffness = 0;     ///< of the spring in the last step [N/m]; 0: there was none
};

template <class Archive>
void serialize(Archive& archive, GripPoint& grip) {
  auto& [anchor, held, end, stiffness] = grip;
  archive(anchor, held, end, stiffness);
}

/// What lies in the mouth of jaws whose tool stands at `link`, the copies being at `x` [m], each point held where it
/// is: at most `most`, spread evenly over what of the mouth is filled. Pieces so small that they lie between the
/// mouth's points are held at the middles of their parts, with up to half of all points.
std::vector<GripPoint> gripPoints(const Mouth& mouth, const Pose& link, const std::vector<Vec3>& x, const CutMesh& mesh,
                                  std::size_t most);

}  // namespace incision

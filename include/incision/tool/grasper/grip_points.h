#pragma once

#include <vector>

#include "incision/cut/cut_mesh.h"
#include "incision/rigid/pose.h"
#include "incision/tool/grasper/mouth.h"

namespace incision {

/// A point of the material that jaws hold.
struct GripPoint {
  int element = 0;
  Barycentric point = Barycentric::Zero();  ///< in the element
  int part = 0;                             ///< of the element, which has the point
  Vec3 anchor = Vec3::Zero();               ///< where the jaws hold it, in the frame of the tool's link [m]
  double stiffness = 0;                     ///< of its spring in the last step [N/m]; 0: it had none
};

template <class Archive>
void serialize(Archive& archive, GripPoint& grip) {
  auto& [element, point, part, anchor, stiffness] = grip;
  archive(element, point, part, anchor, stiffness);
}

/// Points of the material in the mouth of jaws whose tool stands at `link`, the copies being at `x` [m], each held
/// where it is: at most `most`, spread evenly over what of the mouth is filled. A piece so small that it lies between
/// the mouth's points counts by the middles of its parts.
std::vector<GripPoint> gripPoints(const Mouth& mouth, const Pose& link, const std::vector<Vec3>& x, const CutMesh& mesh,
                                  std::size_t most);

/// Finds the part that has the point, as cuts may have split the one that had it. Returns false where rounding has left
/// none.
bool findPart(const CutMesh& mesh, GripPoint* grip);

}  // namespace incision

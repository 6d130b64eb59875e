#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "incision/cut/cut_mesh.h"

namespace incision {

/// Finds parts that may be near a place without going over all of them. Elements lie in the order in which they are
/// near each other, so boxes are kept round runs of them, as they were at some time. They hold as long as no copy has
/// moved farther from there than is added to them; beyond that they are made anew.
class NearParts {
 public:
  /// The mesh must outlive this. `size` is that of an element, the mean [m].
  NearParts(const CutMesh& mesh, double size) : mesh_(mesh), size_(size) {}

  /// Another mesh has taken the place of the one there was. Of what an insertion adds this need not be told: new copies
  /// start where their parents are.
  void forget() { was_.clear(); }

  /// Numbers, ascending, of parts among which are all whose copies, standing at `x` [m], have a box that meets `reach`
  /// when it is made larger by `room` times its sizes to all sides. They hold until the next call.
  const std::vector<int>& find(const Eigen::AlignedBox3d& reach, double room, const std::vector<Vec3>& x);

  /// Numbers, ascending, of parts among which are all whose copies have, where they stand at `x` and where they stood
  /// `before` [m] taken together, a box that meets `reach` when it is made larger by `room` times its sizes to all
  /// sides. They hold until the next call.
  const std::vector<int>& find(const Eigen::AlignedBox3d& reach, double room, const std::vector<Vec3>& x,
                               const std::vector<Vec3>& before);

 private:
  /// Of a run of elements, with all parts that cracks have made of them.
  struct Run {
    Eigen::AlignedBox3d box;
    Vec3 largest = Vec3::Zero();  // sizes of the boxes of its parts [m]
  };

  double follow(const std::vector<Vec3>& x);
  void measure(const std::vector<Vec3>& x);
  const std::vector<int>& within(const Eigen::AlignedBox3d& reach, double room, double moved);

  const CutMesh& mesh_;
  double size_;
  std::vector<Vec3> was_;  // the copies when the boxes were made [m]; none: there are no boxes
  std::vector<Run> runs_;
  std::vector<int> found_;
};

}  // namespace incision

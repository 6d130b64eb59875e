#pragma once

#include <array>
#include <utility>
#include <vector>

#include "incision/surface/exposed.h"

namespace incision {

/// Corners whose weights differ by less are the same point of the material. Far above the rounding of a corner, far
/// below what can be seen.
inline constexpr double SAME_POINT = 1e-9;

/// A point of the material: on a node, an edge, a face, or inside an element.
struct MeshPoint {
  std::array<int, 4> nodes;  ///< of the mesh, those with weight, ascending; −1 beyond the last
  Barycentric weights;       ///< of these nodes
};

/// The distinct points at which polygons have corners. All elements round an edge or a face know the same points on
/// it, with the same weights, whichever of them a corner came from; points inside an element belong to one part.
///
/// Points are numbered: first the mesh's nodes, then the others.
class MeshPoints {
 public:
  MeshPoints(const CutMesh& mesh, const ExposedPolygons& exposed);

  int count() const { return num_nodes_ + static_cast<int>(points_.size()); }
  int atCorner(int corner) const { return of_corner_[corner]; }
  bool isNode(int point) const { return point < num_nodes_; }
  MeshPoint place(int point) const;

  /// Appends to `loop` the points that lie on the segment between two others, in order, without its ends.
  void appendBetween(int from, int to, std::vector<int>* loop);

 private:
  /// The points on one edge or face or inside one part: first … last − 1.
  struct Carrier {
    std::array<int, 4> nodes;
    int first, last;
  };
  struct Corner;
  std::vector<Corner> locate(const CutMesh& mesh, const ExposedPolygons& exposed);
  void number(const std::vector<Corner>& corners);
  const Carrier* commonCarrier(int from, int to) const;

  int num_nodes_;
  std::vector<int> of_corner_;
  std::vector<MeshPoint> points_;
  std::vector<Carrier> carriers_;  ///< ascending by nodes
  std::vector<bool> carries_;      ///< of each node: some carrier ends there
  std::vector<std::pair<double, int>> between_;
};

}  // namespace incision

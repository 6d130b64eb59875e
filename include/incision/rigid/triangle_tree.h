#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <vector>

#include "incision/rigid/closed_mesh.h"

namespace incision {

/// Boxes round a closed mesh's triangles, for each shell a tree. It allocates nothing when it is asked.
class TriangleTree {
 public:
  /// What of a triangle a point of it lies on.
  struct Feature {
    enum Kind { FACE, EDGE, VERTEX };
    Kind kind = FACE;
    int corner = 0;  ///< the vertex, or where the edge begins
  };

  struct Nearest {
    int triangle = -1;  ///< none within the bound
    Feature feature;
    Vec3 point = Vec3::Zero();
    double squared_distance = std::numeric_limits<double>::infinity();
  };

  struct Exit {
    int triangle = -1;                                       ///< none
    double along = std::numeric_limits<double>::infinity();  ///< from the ray's start [m]
  };

  /// Puts the triangles within each shell of the mesh into the tree's order. The mesh must outlive the tree.
  explicit TriangleTree(ClosedMesh* mesh);

  const Eigen::AlignedBox3d& shellBox(int shell) const { return nodes_[shell].box; }

  /// The point of a shell that is nearest to `point`, and nearer than `most` [m].
  Nearest nearest(int shell, const Vec3& point, double most) const;

  /// Where the ray from `point` along the unit vector `d` first comes out through a face whose unit normal has a share
  /// above `least` along it. `normals` are the faces'.
  Exit firstExit(const Vec3& point, const Vec3& d, double least, const std::vector<Vec3>& normals) const;

  /// Largest n·q over all points q.
  double reachAlong(const Vec3& n) const;

 private:
  /// A box with the boxes of nodes first and first + 1 in it, or with the triangles first … first + count − 1.
  struct Node {
    Eigen::AlignedBox3d box;
    int first = 0, count = 0;
  };

  class Builder;

  const ClosedMesh* mesh_;
  std::vector<Node> nodes_;  // those of all of each shell first
};

}  // namespace incision

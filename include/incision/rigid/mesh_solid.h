#pragma once

#include <vector>

#include "incision/rigid/closed_mesh.h"
#include "incision/rigid/distance_grid.h"
#include "incision/rigid/solid.h"
#include "incision/rigid/triangle_tree.h"

namespace incision {

/// The solid that closed surfaces bound, convex or not; where it has several shells, all that lies in any of them.
///
/// The sign of a distance is that of the pseudonormal at the nearest point: a face's normal, the sum of an edge's two,
/// or a vertex's weighted by angles (Bærentzen and Aanæs, "Signed distance computation using the angle weighted
/// pseudonormal", 2005). Where a point lies in several shells, the deepest counts.
class MeshSolid : public Solid {
 public:
  explicit MeshSolid(ClosedMesh mesh);

  SolidDistance distanceTo(const Vec3& point) const override;
  /// Of a convex mesh the planes of its faces count, as those of a box, and those that nearly agree are one. Of another
  /// the face counts at which the ray from the point against `n` first comes out: what lies behind that are other
  /// places of the solid.
  SolidDistance distanceAgainst(const Vec3& point, const Vec3& n) const override;
  double thickness() const override { return thickness_; }
  double reachAlong(const Vec3& n) const override { return tree_.reachAlong(n); }
  double reach() const override { return reach_; }
  bool isConvex() const override { return is_convex_; }
  bool isClearOf(const Vec3& point, double room) const override { return grid_.isClearOf(point, room); }
  void check(const std::string& where) const override;
  /// The mesh itself.
  Drawing drawing() const override;

 private:
  /// A plane that holds the solid: n·q is `offset` [m] at most.
  struct Plane {
    Vec3 normal;
    double offset;
  };

  SolidDistance distanceToShell(int shell, const Vec3& point, double most) const;
  Vec3 pseudonormal(int triangle, const TriangleTree::Feature& feature) const;
  void findNormals();
  void findPlanes();
  bool findConvex() const;

  ClosedMesh mesh_;
  TriangleTree tree_;
  Eigen::AlignedBox3d box_;
  double extent_ = 0, reach_ = 0, thickness_ = 0;  // [m]
  std::vector<Vec3> face_normals_;                 // unit, or zero where a triangle has no area
  std::vector<Vec3> vertex_normals_;               // weighted by angles
  bool is_convex_ = false;
  std::vector<Plane> planes_;
  DistanceGrid grid_;
};

}  // namespace incision

#pragma once

#include <array>
#include <vector>

#include "incision/cut/cut_mesh.h"
#include "incision/rigid/pose.h"
#include "incision/tool/near_parts.h"
#include "incision/tool/part_frame.h"

namespace incision {

/// A blade this near to an earlier cut, in elements, and turned from it by less than this cosine, runs in that cut: it
/// neither cuts there nor is resisted. Tissue that has moved a little must not be sliced again each time a blade goes
/// back.
inline constexpr double SLIT_REACH = 0.2, SLIT_COSINE = 0.8;

/// A triangle that an edge has swept, in an element's coordinates.
using SweptTriangle = std::array<Barycentric, 3>;

/// Whether a line through `point` along `direction` meets a triangle, all in an element's affine coordinates. Triangles
/// that share an edge leave no gap between them, at whatever distance and angle they pass the point.
bool isBehind(const SweptTriangle& triangle, const Barycentric& point, const Vec3& direction);

/// Whether some of a triangle lies in the element, or outside by no more than `margin` in its own coordinates.
bool reaches(const SweptTriangle& triangle, double margin);

/// Whether some of a triangle lies in a part of the element.
bool reaches(const SweptTriangle& triangle, const Polytope& polytope);

/// Gradient of a linear function given at the four nodes, in affine coordinates.
Vec3 gradient(const Eigen::Vector4d& phi);

/// Points spread evenly over a flat polygon, none in line with others: an edge that sweeps it passes them one by one.
std::vector<Barycentric> spread(const std::vector<Barycentric>& polygon);

/// The point of the line through an edge that is nearest to `point`.
Vec3 nearest(const Edge& edge, const Vec3& point);

/// What of a vector is at right angles to a direction, which is a unit.
inline Vec3 rejected(const Vec3& vector, const Vec3& direction) { return vector - vector.dot(direction) * direction; }

/// Shortest rest edge [m] at a node of a part's element.
double shortestEdge(const Part& part, const CutMesh& mesh);

/// Whether an edge passes through an element the body now has, its parts taken whole.
bool touches(const Edge& edge, const std::vector<Vec3>& x, const CutMesh& mesh, NearParts* near);

}  // namespace incision

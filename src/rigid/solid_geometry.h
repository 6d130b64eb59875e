#pragma once

#include <cmath>
#include <initializer_list>
#include <utility>

#include "incision/rigid/solid.h"

namespace incision {

template <int N>
using Vec = Eigen::Matrix<double, N, 1>;

/// The unit vector along `v`, also where its square would vanish; `otherwise` where `v` is zero.
template <int N>
Vec<N> directionOf(const Vec<N>& v, const Vec<N>& otherwise) {
  const double scale = v.cwiseAbs().maxCoeff();
  return scale > 0 ? (v / scale).normalized() : otherwise;
}

/// Signed distance and outward normal of the box, or rectangle, that reaches from −half to half.
template <int N>
std::pair<double, Vec<N>> distanceToBox(const Vec<N>& half, const Vec<N>& point) {
  const Vec<N> beyond = point.cwiseAbs() - half;  // of each pair of faces; negative between them
  int nearest = 0;
  const double depth = beyond.maxCoeff(&nearest);
  const Vec<N> normal =
      directionOf<N>(beyond.cwiseMax(0), Vec<N>::Unit(nearest));  // of the mirror image in x, y, z > 0
  const Vec<N> side = point.unaryExpr([](double x) { return std::copysign(1.0, x); });
  return {depth > 0 ? beyond.cwiseMax(0).stableNorm() : depth, side.cwiseProduct(normal)};
}

/// Solid::distanceAgainst for a convex solid. `shares` is what of `n` lies along the normals of each of its faces; a
/// round face turns its normal to `n`.
SolidDistance distanceAgainstFaces(const Solid& solid, const Vec3& point, const Vec3& n,
                                   std::initializer_list<Vec3> shares);

}  // namespace incision

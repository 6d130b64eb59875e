#pragma once

#include <cstddef>
#include <string>

#include "incision/base/vec.h"

namespace incision {

/// Longest label of a cut, in bytes of UTF-8: labels go into reports and logs, where a line must stay a line.
inline constexpr std::size_t MAX_LABEL = 64;

/// A plane or rectangle given from outside, in the deformed configuration.
struct PlaneCut {
  std::string label;
  Vec3 point = Vec3::Zero();    ///< on the plane; the rectangle's centre [m]
  Vec3 normal = Vec3::UnitX();  ///< towards the positive side; any length but zero
  Vec3 tangent = Vec3::Zero();  ///< direction of `length`; what is parallel to the normal is taken off
  double length = 0;            ///< along the tangent [m]; 0: unbounded
  double width = 0;             ///< along normal × tangent [m]; 0: unbounded

  bool bounded() const { return length > 0 || width > 0; }

  /// The tangent, made of length 1, less its component along the normal: shorter than 1 where the two are oblique.
  Vec3 tangentInPlane() const;
};

/// Why this plane cannot be a cut, in words for the one who sent it; empty when it can.
std::string whyInvalid(const PlaneCut& plane);

}  // namespace incision

#pragma once

#include <nlohmann/json.hpp>

#include "report/benchmark/round_crack.h"

namespace incision::report {

/// The jump of displacement across a crack, after a step.
class Jumps {
 public:
  /// `done` is what inserting the crack did.
  Jumps(const Rig& rig, const Insertion& done, const RoundCrack& crack);

  /// At a place of the crack's plan [m]; zero where no part has been split.
  Vec3 at(const Vec2& plan) const;
  /// ∫ [u] ⊗ n dA [m³].
  const Mat3& moment() const { return moment_; }

 private:
  struct Facet {
    std::vector<Vec2> corners;
    std::vector<Vec3> jumps;
    Vec2 low, high;
  };
  std::vector<Facet> facets_;
  Mat3 moment_ = Mat3::Zero();
};

/// Rays run inwards from the front at so many evenly spaced angles ω, and have so many places at evenly spaced
/// distances r up to this share of the radius, the first one half of a spacing behind the front.
inline constexpr int RAYS = 24, RAY_PLACES = 60;
inline constexpr double RAY_LENGTH = 0.6;

/// Jumps [m] along the rays, ahead, across and along the front: a list of places for each ray.
nlohmann::json alongRays(const Jumps& jumps, const RoundCrack& crack);

}  // namespace incision::report

#pragma once

#include "ensemble.h"
#include "incision/scene/scene.h"

namespace incision::report {

/// What the runs of an ensemble differ in, but for the seed.
struct Touching {
  double young_modulus, time_step, friction;
  bool self = true;  ///< fragments touch each other, and not the ground alone
};

/// A run of a body that falls to pieces at its start, whose pieces meet on the ground at z = 0.
struct GroundRun {
  Scene scene;
  int steps;
  double speed = 0;  ///< at which it comes down on the ground as the steps begin [m/s]
  bool measures_overlap = true;
};

/// What is seen of it.
Ensemble runOf(const GroundRun& run);

/// A block of 0.15 m of 3 × 3 × 3 cells, undamped, which four random planes part `height` above the ground.
Scene fallingBlock(const Touching& touching, double height, unsigned seed);

/// A column of 0.1 × 0.1 × 0.3 m that two planes part, a little out of level, on ground that is a little out of level.
Scene leaningStack(const Touching& touching, unsigned seed);

/// The block on the ground, which three random planes part, and then the edge of a blade that is drawn through at
/// 0.5 m/s. The edge has no body and meets no resistance, so it does no work.
Scene bladeThroughPieces(const Touching& touching, unsigned seed);

/// The block without ground or weight, which four random planes part: the piece near its middle spins [rad/s] among the
/// others, which are at rest.
Ensemble spinningPiece(const Touching& touching, double spin, int steps, unsigned seed);

}  // namespace incision::report

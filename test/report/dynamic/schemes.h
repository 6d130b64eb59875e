#pragma once

#include <functional>
#include <string>
#include <vector>

#include "incision/solver/implicit_step.h"

namespace incision::report {

/// Takes a body from `time` on by `time_step` [s]; false where that fails.
using TakeStep = std::function<bool(double time, double time_step, ImplicitStep* step, Motion* motion)>;

/// A way to step in time. `make` gives one for a run of its own.
struct Scheme {
  std::string name;
  std::function<TakeStep()> make;
};

/// What the package offers: implicit Euler and BDF2.
Scheme eulerScheme();
Scheme bdf2Scheme();

/// What it does not, because of what this report measures. They are made of the package's implicit Euler steps:
/// - Newton: the step is solved again with the rotations at its end, `iterations` times in all;
/// - implicit midpoint: a step of Δt/2, then as far again;
/// - SDIRK2 (Alexander 1977): a step of γ Δt, γ = 1 − 1/√2, and one more from the point that lies beyond it, so that
///   both together are of second order and damp what is stiff.
/// The last two are so for held bodies alone: a step of Euler moves free ones as rigid bodies, and half a step leads no
/// farther on the way of a whole one.
Scheme newtonScheme(int iterations);
Scheme midpointScheme();
Scheme sdirk2Scheme();

/// Velocity Verlet, of a free body on which nothing acts and in steps that no wave outruns. It has nothing of the
/// package's steps but the forces.
Scheme verletScheme();

/// Those that are compared.
std::vector<Scheme> schemesOf(bool held);

}  // namespace incision::report

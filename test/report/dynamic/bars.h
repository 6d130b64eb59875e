#pragma once

#include <functional>
#include <string>
#include <vector>

#include "report/dynamic/schemes.h"
#include "support/rig.h"

namespace incision::report {

/// A bar 1 × 0.25 × 0.25 m, ν = 0.45, ρ = 1000 kg/m³, undamped, that moves for a second.
struct Bar {
  std::string name;
  double young_modulus = 1e6;  ///< [Pa]
  bool clamped = true;         ///< at x = 0
  double gravity = 0;          ///< along −z [m/s²]
  std::function<Vec3(const Vec3& X)> velocity = [](const Vec3&) -> Vec3 { return Vec3::Zero(); };  ///< at first [m/s]
};

/// It hangs down from its clamp by gravity, which comes at once.
Bar swingingBar(double young_modulus);
/// It is twisted about its axis by an initial spin of 20 rad/s at its free end: a wave of large turns.
Bar twistingBar();
/// It tumbles freely, by 11 rad/s.
Bar spinningBar(double young_modulus);

/// What is chosen for a run.
struct Choice {
  int cells = 3;  ///< across; four times as many along
  double time_step = 0.01;
  Method method = Method::ITERATIVE;
  double tolerance = 1e-6;
  Mass mass = Mass::LUMPED;
  bool warping = true;
};

inline constexpr double DURATION = 1, SAMPLE = 0.1;  ///< [s]; positions are compared ten times

/// What a run gave.
struct Run {
  bool done = true;                        ///< every step could be taken, and nothing flew off
  std::vector<std::vector<Vec3>> samples;  ///< positions of all nodes at each sample
  std::vector<Vec3> rest;                  ///< and at rest
  double ms = 0;                           ///< wall time of all steps, so per simulated second
  double iterations = 0;                   ///< mean of a step
  double energy_growth = 0;                ///< largest energy after a step / the first, less one; without gravity
};

Run simulate(const Bar& bar, const Scheme& scheme, const Choice& choice);

/// Root mean square over the nodes of the distance from where the reference has them, at the worst sample, relative to
/// the reference's largest root mean square displacement. The nodes compared are those of a grid `cells` across, which
/// both meshes have. Infinite where a run was not done.
double errorAgainst(const Run& reference, int reference_cells, const Run& run, int run_cells, int cells);

}  // namespace incision::report

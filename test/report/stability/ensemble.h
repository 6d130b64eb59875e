#pragma once

#include <functional>
#include <string>
#include <vector>

#include "watched.h"

namespace incision::report {

/// What was seen of many runs of bodies that touch. Their motion is chaotic, so that one run tells nothing.
struct Ensemble {
  int runs = 0, steps = 0;
  int failed = 0;           ///< runs that ended as a step could not be taken
  int unsettled = 0;        ///< steps
  int rises = 0;            ///< settled steps in which the energy rose by more than RISE_BOUND
  int overlaps = 0;         ///< how many times the overlap was measured
  Worst rise;               ///< largest, of the energy in a settled step, over that of the run's start
  Worst above;              ///< largest energy less that of the start, over it
  Worst overlap;            ///< deepest, of a point of a fragment in another one, over an element
  Worst momentum;           ///< largest change of it by anything known, over mass × largest speed
  Worst spin;               ///< largest change of the angular momentum, over the first
  std::vector<int> solves;  ///< of each step in which there was something to solve

  void add(const Ensemble& other);
  double unsettledShare() const { return steps > 0 ? static_cast<double>(unsettled) / steps : 0; }
  /// So that this share of the steps takes no more.
  int solvesOf(double share) const;
};

inline constexpr double RISE_BOUND = 1e-6;

/// Follows a run's energy, which counts that of gravity and of the springs of contact.
class EnergyWatch {
 public:
  EnergyWatch(double energy, Ensemble* seen) : first_(energy), last_(energy), seen_(*seen) {}

  void step(double energy, bool settled, int solves);

 private:
  double first_, last_;
  Ensemble& seen_;
};

/// The runs of seeds 0 … count − 1 together, on two threads.
Ensemble ofSeeds(int count, const std::function<Ensemble(unsigned seed)>& run);

nlohmann::json toJson(const std::string& name, const Ensemble& ensemble);

}  // namespace incision::report

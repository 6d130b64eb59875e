#pragma once

#include <functional>
#include <limits>

#include "cases.h"
#include "support/rig.h"

namespace incision::report {

inline constexpr Method METHODS[] = {Method::DIRECT, Method::ITERATIVE};
inline const char* nameOf(Method method) { return method == Method::DIRECT ? "direct" : "iterative"; }

/// What was seen of a body in all its steps.
struct Watch {
  int steps = 0;
  bool finite = true;         ///< every step could be taken, and all its values are finite
  double growth = 0;          ///< largest energy less the first one, over the largest kinetic and elastic energy
  double kinetic_growth = 0;  ///< largest kinetic energy less the first one, over the first
  double drift = 0;           ///< largest change of momentum by anything but gravity, over mass × largest speed
  double iterations = 0;      ///< mean of the steps
  double residual = 0;        ///< largest, against the long double reference: StepResidual::relative
  double residual_share = 0;  ///< and StepResidual::share

  /// The share; infinite where a step failed.
  double residualIfFinite() const { return finite ? residual_share : std::numeric_limits<double>::infinity(); }
};

/// A body that is watched while it moves. Its energy counts that of gravity.
class Watched : public Rig {
 public:
  Watched(TetMesh mesh, const RigSettings& settings);

  /// The energy and momentum now are those that must not grow or drift.
  void startWatching();

  /// Takes steps, each after `each`, until one fails. Every `reference_every`-th is held against the reference; 0:
  /// none.
  void take(int steps, int reference_every = 10, const std::function<void()>& each = {});

  const Watch& seen() const { return watch_; }
  const RigSettings& settings() const { return settings_; }
  double totalEnergy() const;
  double largestEnergy() const { return largest_energy_; }  ///< kinetic and elastic, of those seen
  double elasticEnergy() const { return step.assembly().elasticEnergy(motion.x); }
  double mass() const;
  Vec3 angularMomentum() const;  ///< about the centre of mass

 private:
  void watchSums();
  void compare(const Motion& before);

  RigSettings settings_;
  Watch watch_;
  double first_energy_ = 0, first_kinetic_ = 0, first_time_ = 0, iterations_ = 0;
  double largest_energy_ = 0, largest_rise_ = 0, largest_kinetic_ = 0, largest_speed_ = 0, largest_drift_ = 0;
  Vec3 first_momentum_ = Vec3::Zero();
};

/// Whether all positions and velocities are finite.
bool allFinite(const Motion& motion);

/// A body of soft tissue, undamped, free in empty space, with steps of 0.01 s.
RigSettings freeBody(Method method);

/// Gives every copy a velocity of its own of up to `speed` [m/s] in each direction, and starts watching.
void throwApart(Watched* body, double speed = 1);

/// The largest of some figures; one that is not a number counts as infinite.
class Worst {
 public:
  void add(double figure) { figure_ = std::max(figure_, figure >= 0 ? figure : NEVER); }
  double figure() const { return figure_; }

 private:
  static constexpr double NEVER = std::numeric_limits<double>::infinity();
  double figure_ = 0;
};

/// What bodies in free flight must keep, each method by its own bounds.
class Flights {
 public:
  /// Throws a body's copies apart and takes steps, as Watched::take() does.
  void fly(Watched* body, int steps, int reference_every);
  /// Adds the cases "residual", "momentum" and "energy growth" of all flights so far, of each method that flew.
  void report(Matrix* matrix, const std::string& name) const;

 private:
  struct Kept {
    int flights = 0;
    Worst residual, drift, growth;
  };
  Kept direct_, iterative_;
};

inline constexpr double GROWTH_BOUND = 1e-6;
inline const char* const GROWTH_REASON = "implicit Euler only takes energy away";
inline void addGrowth(Matrix* matrix, const std::string& name, double figure) {
  matrix->add(name, figure, GROWTH_BOUND, GROWTH_REASON);
}
/// Of Watch::drift; whatever a solve leaves, a step balances it.
inline void addMomentum(Matrix* matrix, const std::string& name, double figure) {
  matrix->add(name, figure, 1e-11, "loads alone change it; rounding, over mass × speed");
}
/// Of StepResidual::share; the norms are reckoned in double on one side.
inline void addResidual(Matrix* matrix, const std::string& name, double figure) {
  matrix->add(name, figure, 1.01, "share of what tolerance and rounding leave, worst piece; 1 % for the norms");
}

}  // namespace incision::report

// The pull of what hangs turns with it in the same step.
#include <gtest/gtest.h>

#include <cmath>

#include "support/rig.h"

namespace incision {
namespace {

constexpr double LENGTH = 1, DENSITY = 1000, G = 9.81;

/// A bar that hangs from its upper end, struck at random.
class HangingBar : public Rig {
 public:
  HangingBar(double young_modulus, double dt, TensionScheme tension, Method method = Method::DIRECT)
      : Rig(block({2, 2, 8}, Vec3(0.25, 0.25, LENGTH)), settings(young_modulus, dt, tension, method)) {
    motion.v = randomVectors(motion.v.size(), 0.1, 1);
  }

  /// Kinetic, elastic and potential energy over that of the weight at the length.
  double share() const {
    double sum = energy(), mass = 0;
    for (std::size_t c = 0; c < motion.x.size(); ++c) {
      sum += step.assembly().masses()[c] * G * motion.x[c].z();
      mass += step.assembly().masses()[c];
    }
    return sum / (mass * G * LENGTH);
  }

  /// The most by which the energy has ever risen in so many steps, over that.
  double growth(int steps) {
    double least = share(), most = 0;
    for (int k = 0; k < steps; ++k) {
      if (!advance()) return INFINITY;
      most = std::max(most, share() - least);
      least = std::min(least, share());
    }
    return most;
  }

 private:
  static RigSettings settings(double young_modulus, double dt, TensionScheme tension, Method method) {
    RigSettings settings;
    settings.material = {young_modulus, 0.3, DENSITY, 0, 0};
    settings.conditions.gravity = Vec3(0, 0, -G);
    settings.conditions.clamps = {{slab(2, LENGTH), Vec3::Zero()}};
    settings.solver.time_step = dt;
    settings.solver.method = method;
    settings.solver.tension = tension;
    return settings;
  }
};

TEST(Tension, KeepsWhatHangsFromSwayingUpAtAnyTimeStep) {
  for (const Method method : {Method::DIRECT, Method::ITERATIVE})
    for (const double young_modulus : {3e3, 1e4}) {
      EXPECT_LT(HangingBar(young_modulus, 1, TensionScheme::AUTO, method).growth(200), 1e-6) << young_modulus;
      EXPECT_LT(HangingBar(young_modulus, 1, TensionScheme::IMPLICIT, method).growth(200), 1e-6) << young_modulus;
      EXPECT_GT(HangingBar(young_modulus, 1, TensionScheme::EXPLICIT, method).growth(200), 0.1) << young_modulus;
    }
}

TEST(Tension, ChangesNothingOfWhereABarEnds) {
  for (const double time_step : {0.05, 0.2}) {
    HangingBar with(1e5, time_step, TensionScheme::IMPLICIT), without(1e5, time_step, TensionScheme::EXPLICIT);
    for (double time = 0; time < 60; time += time_step) {
      ASSERT_TRUE(with.advance());
      ASSERT_TRUE(without.advance());
    }
    EXPECT_LT(largestDifference(with.motion.x, without.motion.x), 1e-6);
  }
}

}  // namespace
}  // namespace incision

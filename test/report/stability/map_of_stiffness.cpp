#include <cmath>

#include "stability.h"
#include "watched.h"

namespace incision::report {
namespace {

constexpr double CELL = 0.1, LENGTH = 1, DENSITY = 1000, G = 9.81;

/// The stress [Pa] of the bar's weight where it hangs down.
constexpr double TENSION = DENSITY * G * LENGTH;

/// Beyond this modulus [Pa] the last digit of a position is more than 1e-9 of what the bar gives way, TENSION × LENGTH
/// / E: what it is rounded by in each step does work that can be seen.
constexpr double DIGITS_END = 1.5e11;

/// A bar that is held at one end, slit beside it, and begins to fall at rest.
class SlitBar : public Watched {
 public:
  SlitBar(double young_modulus, double poisson_ratio, double dt, Method method)
      : Watched(block({10, 3, 3}, Vec3(LENGTH, 3 * CELL, 3 * CELL)),
                settingsOf(young_modulus, poisson_ratio, dt, method)) {
    cut(rectangle(Vec3(0.42, 0.1, 0.3), Vec3(1, 0.1, 0.2), Vec3::UnitZ(), 0.4, 0));
    startWatching();
  }

  /// How far the energy rises above that of now in so many steps, over the largest that there has been.
  double growthInSteps(int steps) {
    const double start = totalEnergy();
    double rise = 0;
    for (int k = 0; k < steps && seen().finite; ++k) {
      take(1);
      rise = std::max(rise, totalEnergy() - start);
    }
    return rise > 0 ? rise / largestEnergy() : 0;
  }

 private:
  static RigSettings settingsOf(double young_modulus, double poisson_ratio, double dt, Method method) {
    RigSettings settings;
    settings.material = {young_modulus, poisson_ratio, DENSITY, 0, 0};
    settings.conditions.gravity = Vec3(0, 0, -G);
    settings.conditions.clamps = {{slab(0, 0), Vec3::Zero()}};
    settings.solver = {dt, method, 1e-6, 1};
    return settings;
  }
};

/// Released, the bar turns down in the first steps: those of a long time step lead along the tangent, by more than its
/// length where it is soft, and leave it stretched.
constexpr int LEAP = 20;

/// Where a wave along the tension, of the speed √(σ/ρ), passes less than an element a step, or a tenth of one where the
/// bar is stretched so far that elements turn inside out, it does not leap; nor where the material resists a thousand
/// times as much.
bool energyMustNotGrow(double young_modulus, double time_step) {
  const double elements = std::sqrt(TENSION / DENSITY) * time_step / CELL;
  return young_modulus > 1000 * TENSION || elements < (young_modulus > TENSION ? 1 : 0.1);
}

}  // namespace

void mapOfStiffness(Matrix* matrix) {
  const int count = matrix->quick() ? 6 : 11, steps = matrix->quick() ? 40 : 200;
  nlohmann::json& map = matrix->data()["map"] = nlohmann::json::array();
  matrix->begin("E from 1e2 to 1e12 Pa × Δt from 1e-5 to 1 s, a slit bar that falls");
  for (const Method method : METHODS) {
    Worst residual, growth, growth_after, rounded, beyond;
    int failed = 0;
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < count; ++j) {
        const double E = std::pow(10, 2 + 10.0 * i / (count - 1)), dt = std::pow(10, -5 + 5.0 * j / (count - 1));
        SlitBar bar(E, 0.45, dt, method);
        bar.take(LEAP);
        const Watch& seen = bar.seen();
        const double leap = seen.growth, after = bar.growthInSteps(steps - LEAP);
        failed += !seen.finite;
        residual.add(seen.residual_share);
        (energyMustNotGrow(E, dt) ? growth : beyond).add(leap);
        (E > DIGITS_END ? rounded : E >= TENSION ? growth_after : beyond).add(after);
        map.push_back({{"method", nameOf(method)},
                       {"E", E},
                       {"dt", dt},
                       {"finite", seen.finite},
                       {"growth", std::max(leap, after)},
                       {"iterations", seen.iterations},
                       {"residual", seen.residual},
                       {"claimed", energyMustNotGrow(E, dt)}});
      }
    const std::string with = std::string(", ") + nameOf(method);
    matrix->add("combinations with a failed step" + with, failed, 0, "every step can be taken");
    addResidual(matrix, "residual" + with, residual.figure());
    addGrowth(matrix, "energy growth in the first 20 steps, √(σ/ρ)Δt/h < 1 (0.1 for E < σ), or E > 1000 σ" + with,
              growth.figure());
    addGrowth(matrix, "energy growth after them, σ ≤ E ≤ 1e11 Pa and any step" + with, growth_after.figure());
    matrix->addLimit(
        "energy growth after them, E = 1e12 Pa, where positions end at 1e-8 of what the bar gives way" + with,
        rounded.figure(), GROWTH_BOUND, GROWTH_REASON);
    matrix->addLimit("energy growth of others, that leap in the first 20 steps or have E < σ" + with, beyond.figure(),
                     GROWTH_BOUND, GROWTH_REASON);
  }

  nlohmann::json& poisson = matrix->data()["poisson"] = nlohmann::json::array();
  matrix->begin("ν from 0 to 0.4999, the same bar, E = 1e5 Pa, Δt = 0.01 s");
  for (const Method method : METHODS) {
    Worst residual, growth;
    for (const double nu : {0.0, 0.3, 0.45, 0.49, 0.499, 0.4999}) {
      SlitBar bar(1e5, nu, 0.01, method);
      bar.take(steps);
      residual.add(bar.seen().residualIfFinite());
      growth.add(bar.seen().growth);
      poisson.push_back({{"method", nameOf(method)}, {"nu", nu}, {"iterations", bar.seen().iterations}});
    }
    const std::string with = std::string(", ") + nameOf(method);
    addResidual(matrix, "residual" + with, residual.figure());
    addGrowth(matrix, "energy growth" + with, growth.figure());
  }
}

}  // namespace incision::report

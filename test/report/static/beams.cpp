// Beams clamped at x = 0 and loaded at their end, against Timoshenko's theory; a third of them cut along the middle.
#include <cmath>

#include "report/static/problem.h"

namespace incision::report {
namespace {

// With ν = 0 the clamp takes nothing from beam theory.
constexpr double E = 1e6, L = 1, H = 0.2, TRACTION = 1;
constexpr double P = TRACTION * H * H, A = H * H, I = H * H * H * H / 12;
constexpr double G = E / 2, KAPPA = 10.0 / 12;

/// δ = P a³/3EI + P a/κGA of a beam of length a with a share of the section's height, under that share of the load.
double deflection(double a, double share) {
  return share * P * a * a * a / (3 * E * I * std::pow(share, 3)) + share * P * a / (KAPPA * G * A * share);
}

/// Under a dead load the strain energy is half the load times its way.
double wayOf(double load, double energy) { return 2 * energy / load; }

RigSettings clampedUpTo(double x, const std::vector<Load>& loads) {
  RigSettings settings = statics(E, 0);
  settings.conditions.loads = loads;
  RestBox box = slab(0, 0);
  box.max.x() = x + 1e-9;
  settings.conditions.clamps = {{box, Vec3::Zero()}};
  return settings;
}

Problem bar(const std::string& name) {
  Problem problem;
  problem.name = name;
  problem.grid = [](int n, bool) { return block({5 * n, n, n}, Vec3(L, H, H)); };
  problem.geometry = "bar.geo";
  problem.fine = {Vec3::Zero(), Vec3(L, H, H)};
  // An odd number of cells has no faces in the mid-plane.
  problem.cells = [](const Way& way, bool quick) {
    const std::vector<int> even = {4, 6, 8, 12, 16};
    const int sizes = quick ? 4 - way.unstructured : 5;
    std::vector<int> cells(even.begin(), even.begin() + sizes);
    if (!way.faces)
      for (int& n : cells) ++n;
    return cells;
  };
  problem.ways = {{false, true}, {false, false}, {true, true}, {true, false}};
  problem.order = 2;
  return problem;
}

Insertion cutAlongTheMiddle(Rig* rig, double) { return rig->cut(plane(Vec3(0, 0, H / 2), Vec3::UnitZ())); }

/// The end is clamped up to the crack's front; the arms are pulled apart by their end faces.
Case openedBy(double crack) {
  RestBox upper = slab(0, L), lower = upper;
  upper.min.z() = H / 2 - 1e-9;
  lower.max.z() = H / 2 + 1e-9;
  const std::vector<Load> loads = {{upper, Vec3(0, 0, TRACTION), 0}, {lower, Vec3(0, 0, -TRACTION), 0}};
  const PlaneCut slit = rectangle(Vec3(L, H / 2, H / 2), Vec3::UnitZ(), Vec3::UnitX(), 2 * crack, 0);
  return {clampedUpTo(L - crack, loads), [=](Rig* rig, double) { return rig->cut(slit); }, P * P / 2};
}

}  // namespace

Problem cantilever() {
  Problem problem = bar("cantilever");
  problem.ways = {{false, true}, {true, true}};
  const Load load = {slab(0, L), Vec3(0, 0, TRACTION), 0};
  problem.cases = {{clampedUpTo(0, {load}), {}}};
  problem.quantities = {{"deflection", deflection(L, 1), {0}, [](const auto& U) { return wayOf(P, U[0]); }, true}};
  return problem;
}

Problem splitCantilever() {
  Problem problem = cantilever();
  problem.name = "split cantilever";
  problem.ways = bar("").ways;
  problem.cases[0].cut = cutAlongTheMiddle;
  problem.quantities[0].answer = deflection(L, 0.5);
  return problem;
}

Problem doubleCantileverBeam() {
  constexpr double LONG = 0.8 * L, SHORT = 0.6 * L;
  Problem problem = bar("double cantilever beam");
  problem.cases = {openedBy(LONG), openedBy(SHORT)};
  // The end faces' tractions are those of half of a section each.
  const auto opening = [](double U) { return wayOf(P, U); };
  const auto released = [](double energy_long, double energy_short) {
    return (energy_long - energy_short) / (H * (LONG - SHORT));
  };
  const auto exactEnergy = [](double a) { return P * deflection(a, 0.5) / 2; };
  problem.quantities = {
      {"opening of an arm", deflection(LONG, 0.5), {0}, [=](const auto& U) { return opening(U[0]); }, true},
      {"energy release rate",
       released(exactEnergy(LONG), exactEnergy(SHORT)),
       {0, 1},
       [=](const auto& U) { return released(U[0], U[1]); },
       true}};
  return problem;
}

}  // namespace incision::report

// Cracks that end in the body, under tension, against linear elastic fracture mechanics.
#include <cmath>

#include "report/static/problem.h"
#include "support/penny_crack.h"

namespace incision::report {
namespace {

constexpr double PI = 3.14159265358979323846;
constexpr double E = 1e6, TENSION = 1e3;

const std::vector<Way> ALL_WAYS = {{false, true}, {false, false}, {false, false, true},
                                   {true, true},  {true, false},  {true, false, true}};

/// A body pulled at z = ±half. The loads balance; so that it cannot drift, a patch of one end is held, which moves as
/// one as long as nothing but tension reaches it: ν = 0.
RigSettings pulled(double half, const RestBox& patch) {
  RigSettings settings = statics(E, 0);
  settings.conditions.loads = {{slab(2, half), Vec3(0, 0, TENSION), 0}, {slab(2, -half), Vec3(0, 0, -TENSION), 0}};
  settings.conditions.clamps = {{patch, Vec3::Zero()}};
  return settings;
}

// The plate: x in [0, WIDTH], y in [0, THICKNESS], z in [−HALF, HALF]. With ν = 0 it is plane at any thickness.
constexpr double WIDTH = 1, THICKNESS = 0.1, HALF = 1.5;
constexpr double LONG = 0.5, SHORT = 0.3;  // cracks [m]

/// Half of the cells along the plate are of one size, over a third of it; the others grow towards the ends.
TetMesh gradedPlate(int cells, int cells_along) {
  TetMesh mesh = block({cells, cells / 10, cells_along}, Vec3(WIDTH, THICKNESS, 2), Vec3(0, 0, -1));
  for (Vec3& X : mesh.nodes) {
    const double s = std::abs(X.z()), beyond = std::max(0.0, 2 * s - 1);
    X.z() = std::copysign(std::min(s, 0.5) + beyond / 2 + beyond * beyond / 2, X.z());
  }
  return mesh;
}

double stressIntensity(double a) {
  const double r = a / WIDTH;
  const double F = 1.12 - 0.231 * r + 10.55 * r * r - 21.72 * r * r * r + 30.39 * r * r * r * r;
  return F * TENSION * std::sqrt(PI * a);
}

/// ∫ B K_I²/E da, the energy [J] that cracks up to `a` release, by the midpoint rule.
double edgeCrackEnergy(double a) {
  constexpr int POINTS = 1000;
  double sum = 0;
  for (int k = 0; k < POINTS; ++k) sum += std::pow(stressIntensity(a * (k + 0.5) / POINTS), 2);
  return THICKNESS / E * sum * a / POINTS;
}

/// The crack that releases this much.
double edgeCrackOf(double energy) {
  double low = 0, high = WIDTH;
  for (int k = 0; k < 50; ++k) (edgeCrackEnergy((low + high) / 2) < energy ? low : high) = (low + high) / 2;
  return low;
}

Case pulledPlate(double crack) {
  RestBox end = slab(2, HALF);
  end.min.x() = 0.39 * WIDTH;
  return {pulled(HALF, end), [=](Rig* rig, double longer) {
            return rig->cut(rectangle(Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitX(), 2 * (crack + longer), 0));
          }};
}

/// The volume [m³] that tension opens between the faces of a disc in infinite space.
double pennyVolume(double radius) { return 16 * TENSION * std::pow(radius, 3) / (3 * E); }

/// The stress that the tension makes without the disc does no work but on its opening.
double openedVolume(double energy) {
  const double uncracked = TENSION * TENSION / (2 * E) * std::pow(2 * BLOCK_HALF, 3);
  return 2 * (energy - uncracked) / TENSION;
}

Case pulledBlock(double radius) {
  RestBox middle = slab(2, BLOCK_HALF);
  middle.min.head<2>().setConstant(-1.5);
  middle.max.head<2>().setConstant(1.5);
  return {pulled(BLOCK_HALF, middle),
          [=](Rig* rig, double longer) { return rig->cut(disc(radius + longer, rig->mesh, rig->motion.x)); }};
}

}  // namespace

// K_I² = E dU/da of the growing crack, as a mean over its growth.
Problem edgeCrack() {
  Problem problem;
  problem.name = "edge crack";
  problem.ways = ALL_WAYS;
  // An odd number of cells along has no faces in the crack; its front is on faces in either grid.
  problem.grid = [](int n, bool faces) { return gradedPlate(n, faces ? 2 * n : 2 * n + 1); };
  problem.geometry = "plate.geo";
  problem.fine = {Vec3(0, 0, -0.5), Vec3(WIDTH, THICKNESS, 0.5)};
  problem.cells = [](const Way&, bool quick) {
    return quick ? std::vector<int>{10, 20, 30} : std::vector<int>{10, 20, 30, 40};
  };
  problem.cases = {pulledPlate(LONG), pulledPlate(SHORT)};
  const auto intensity = [](double energy) { return std::sqrt(E * energy / (THICKNESS * (LONG - SHORT))); };
  const double uncracked = TENSION * TENSION / (2 * E) * WIDTH * THICKNESS * 2 * HALF;
  problem.quantities = {{"K_I",
                         intensity(edgeCrackEnergy(LONG) - edgeCrackEnergy(SHORT)),
                         {0, 1},
                         [=](const auto& U) { return intensity(U[0] - U[1]); },
                         false},
                        {"energy released",
                         edgeCrackEnergy(LONG),
                         {0},
                         [=](const auto& U) { return U[0] - uncracked; },
                         false,
                         [](double energy) { return LONG - edgeCrackOf(energy); }}};
  problem.order = 1;
  return problem;
}

// K_I² = E dU/dA of the growing disc, as a mean over its growth.
Problem pennyCrack() {
  constexpr double LARGE = 1.2, SMALL = 0.8;
  Problem problem;
  problem.name = "penny crack";
  problem.ways = ALL_WAYS;
  problem.grid = [](int n, bool) { return gradedBlock(n); };
  problem.geometry = "block.geo";
  problem.fine = {Vec3::Constant(-FINE_HALF), Vec3::Constant(FINE_HALF)};
  problem.cases = {pulledBlock(1), pulledBlock(LARGE), pulledBlock(SMALL)};
  const auto intensity = [](double volume) {
    const double released = TENSION * volume / 2 / (PI * (LARGE * LARGE - SMALL * SMALL));
    return std::sqrt(E * released);
  };
  problem.quantities = {{"opened volume",
                         pennyVolume(1),
                         {0},
                         [](const auto& U) { return openedVolume(U[0]); },
                         false,
                         [](double volume) { return 1 - std::cbrt(volume / pennyVolume(1)); }},
                        {"K_I",
                         intensity(pennyVolume(LARGE) - pennyVolume(SMALL)),
                         {1, 2},
                         [=](const auto& U) { return intensity(openedVolume(U[0]) - openedVolume(U[1])); },
                         false}};
  problem.order = 1;
  problem.cells = [](const Way& way, bool quick) {
    std::vector<int> cells = quick ? std::vector<int>{12, 18, 26} : std::vector<int>{12, 18, 26, 32, 38};
    if (!way.faces)
      for (int& n : cells) ++n;
    return cells;
  };
  return problem;
}

}  // namespace incision::report

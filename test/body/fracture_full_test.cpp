// Problems of fracture with known answers that take more than some seconds.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>

#include "support/breaking.h"
#include "support/rig.h"
#include "support/scenes.h"

namespace incision::test {
namespace {

constexpr double STRENGTH = 1e4;  // [Pa]

RestBox boxOf(const Vec3& min, const Vec3& max) { return {min - Vec3::Constant(1e-9), max + Vec3::Constant(1e-9)}; }

/// Force [N] at which a beam under three loads starts to break over 2bh²/3Lσ, the one of beam theory.
double bendingShare(int cells, double* where) {
  const double length = 6.5, span = 6, height = 1, width = 0.5, ramp = 100;
  const int nx = 13 * cells / 2, ny = std::max(2, cells / 4);
  Scene scene = quasiStatic(1e6, 0.2, 0.2);
  scene.body.warping = false;
  scene.body.grid = GridSettings{{nx, ny, cells}, Vec3(length, width, height), Vec3(-length / 2, 0, 0)};
  const double patch = 0.5;
  const double load = STRENGTH * 2 * width * height * height / (3 * (span - patch / 2));  // [N]
  const auto traction = [&](double x, double z, double share) {
    scene.loads.push_back({boxOf(Vec3(x - patch / 2, 0, z), Vec3(x + patch / 2, width, z)),
                           Vec3(0, 0, 2 * share * load / (patch * width)), ramp});
  };
  traction(0, height, -1);
  traction(-span / 2, 0, 0.5);
  traction(span / 2, 0, 0.5);
  scene.fracture = tensile(STRENGTH);
  DeformableBody body(scene, loadMesh(scene));
  Breaking run;
  while (run.events.empty() && body.steps() < 500) run = breakInto(&body, 2, 1);
  if (run.events.empty()) return 0;
  *where = run.events[0].where[0];
  return 2 * run.events[0].time / ramp;
}

TEST(FractureFull, ABeamUnderThreeLoadsStartsToBreakAtMidSpan) {
  std::vector<double> error;
  for (const int cells : {4, 8, 16}) {
    double where = 1e9;
    const double share = bendingShare(cells, &where);
    std::printf("%2d cells high: breaks at %.3f of the load of beam theory, %+.3f m from mid-span\n", cells, share,
                where);
    EXPECT_LT(std::abs(where), 0.5);  // below the load
    error.push_back(std::abs(share - 1));
  }
  EXPECT_LT(error[2], 0.1);
  EXPECT_GT(std::log2(error[0] / error[1]), 0.9);  // first order, as the stress is that of a layer of elements
  EXPECT_GT(std::log2(error[1] / error[2]), 0.9);
}

/// A round bar along x, of a square grid whose rings become circles.
TetMesh roundBar(int along, int across, double length, double radius) {
  TetMesh mesh = gridMesh({{along, across, across}, Vec3(length, 2, 2), Vec3(0, -1, -1)});
  for (Vec3& X : mesh.nodes) {
    const double ring = std::max(std::abs(X[1]), std::abs(X[2]));
    const double waist = 1 - 0.06 * std::exp(-std::pow((X[0] / length - 0.5) / 0.2, 2));
    if (ring > 0) X.tail<2>() *= waist * radius * ring / X.tail<2>().norm();
  }
  return mesh;
}

/// Where on a round bar along x, and in what direction, a crack went through so many elements.
struct HelixPoint {
  double along, round, angle, elements;  ///< [m], [rad] from −π to π, [°] of its normal from the axis, count
};

HelixPoint helixPoint(const CrackResult& event) {
  const Vec3 out = Vec3(0, event.where[1], event.where[2]).normalized(), around = Vec3::UnitX().cross(out);
  const Vec3 n = event.normal[0] < 0 ? Vec3(-event.normal) : event.normal;
  return {event.where[0], std::atan2(out[2], out[1]), std::atan2(n.dot(around), n[0]) * 180 / M_PI,
          static_cast<double>(event.elements.size())};
}

/// What the first crack of a twisted bar does near the skin on its first quarter of a turn.
std::vector<HelixPoint> twistedBarHelix(int across) {
  constexpr double LENGTH = 1, RADIUS = 0.125;
  const TetMesh mesh = roundBar(across * 5, across, LENGTH, RADIUS);
  Scene scene = quasiStatic(1e6, 0.2, 0.01);
  const auto left = [](const Vec3& X) { return X[0] < 1e-6; };
  const auto right = [](const Vec3& X) { return X[0] > LENGTH - 1e-6; };
  const auto twist = [](const Vec3& X) { return Vec3(0, -0.005 * X[2], 0.005 * X[1]); };
  scene.boundary = clampEach(mesh, left, mesh, atRest);
  for (const Clamp& clamp : clampEach(mesh, right, mesh, twist)) scene.boundary.push_back(clamp);
  scene.fracture = tensile(1e3);
  DeformableBody body(scene, mesh);
  std::vector<HelixPoint> points;
  double least = 0, most = 0;  // from the first
  while (most - least < M_PI / 2 && body.steps() < 1000)
    for (const CrackResult& event : body.step().cracks) {
      if (event.crack != 0 || event.where.tail<2>().norm() < 0.6 * RADIUS) continue;
      points.push_back(helixPoint(event));
      const double turn = std::remainder(points.back().round - points[0].round, 2 * M_PI);
      least = std::min(least, turn);
      most = std::max(most, turn);
    }
  EXPECT_GE(most - least, M_PI / 2);
  return points;
}

TEST(FractureFull, ATwistedRoundBarBreaksAlongAHelix) {
  for (const int across : {6, 8}) {
    double elements = 0, sum = 0, squares = 0;
    for (const HelixPoint& point : twistedBarHelix(across)) {
      elements += point.elements;
      sum += point.elements * point.angle;
      squares += point.elements * point.angle * point.angle;
    }
    const double mean = sum / elements, spread = std::sqrt(squares / elements - mean * mean);
    std::printf("%d cells across: the crack's normal lies %.1f degrees from the axis, spread %.1f\n", across, mean,
                spread);
    EXPECT_NEAR(mean, 45, 8);
    EXPECT_LT(spread, 10);
  }
}

/// The most that a plate with a notch bears [N], and the work that takes it apart [J].
struct PlateStrength {
  double peak = 0, work = 0;
};

PlateStrength strengthOfNotchedPlate(int cells, std::optional<double> fracture_energy) {
  constexpr double SPEED = 2e-3;  // [m/s] so slow that the crack's way through an element takes no part in it
  Scene scene = quasiStatic(1e6, 0.2, 0.01);
  scene.body.warping = false;
  scene.body.grid = GridSettings{{cells, cells, 1}, Vec3(1, 1, 0.1), Vec3(-0.5, -0.5, 0)};
  scene.boundary = {{slab(1, -0.5), Vec3::Zero()}, {slab(1, 0.5), Vec3(0, SPEED, 0)}};
  scene.cuts = {{0, rectangle(Vec3(-0.5, 0.01, 0.05), Vec3::UnitY(), Vec3::UnitX(), 0.5, 1)}};
  scene.fracture = tensile(STRENGTH);
  scene.fracture->fracture_energy = fracture_energy;
  DeformableBody body(scene, loadMesh(scene));
  PlateStrength result;
  double last = 0;
  for (int k = 0; k < 1000 && (k < 20 || last > 0.01 * result.peak); ++k) {
    body.step();
    const double pull = pullOf(body, Vec3::UnitY(), 1);
    result.work += (pull + last) / 2 * SPEED * scene.solver.time_step;
    result.peak = std::max(result.peak, pull);
    last = pull;
  }
  EXPECT_EQ(body.counts().pieces, 2);
  return result;
}

TEST(FractureFull, WithAFractureEnergyTheAnswerDependsMuchLessOnTheMesh) {
  constexpr double ENERGY = 20;  // [J/m²]: E G / σ_t² = 0.2 m, some elements
  std::array<std::vector<PlateStrength>, 2> results;
  for (const int cells : {8, 16, 32}) {
    results[0].push_back(strengthOfNotchedPlate(cells, std::nullopt));
    results[1].push_back(strengthOfNotchedPlate(cells, ENERGY));
    std::printf("%2d cells: without energy %.0f N, %.2f J; with %.0f J/m² %.0f N, %.2f J\n", cells,
                results[0].back().peak, results[0].back().work, ENERGY, results[1].back().peak, results[1].back().work);
  }
  const auto change = [](const std::vector<PlateStrength>& of, double PlateStrength::*what) {
    return std::abs(of[2].*what / (of[1].*what) - 1);
  };
  // Without it the plate gets weaker with every refinement, by the root of two for a sharp notch.
  EXPECT_GT(change(results[0], &PlateStrength::peak), 0.25);
  EXPECT_LT(change(results[1], &PlateStrength::peak), 0.05);
  EXPECT_GT(change(results[0], &PlateStrength::work), 0.25);
  EXPECT_LT(change(results[1], &PlateStrength::work), 0.15);
  // What the new faces take, 0.075 m² of them, is most of the work.
  EXPECT_GT(results[1][2].work, 0.075 * ENERGY);
  EXPECT_LT(results[1][2].work, 1.5 * 0.075 * ENERGY);
}

}  // namespace
}  // namespace incision::test

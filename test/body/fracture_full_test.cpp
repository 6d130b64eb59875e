// Problems of fracture with known answers that take more than some seconds.
#include <gtest/gtest.h>

#include <cmath>

#include "support/breaking.h"
#include "support/scenes.h"

namespace incision::test {
namespace {

constexpr double STRENGTH = 1e4;  // [Pa]

Box boxOf(const Vec3& min, const Vec3& max) { return {min - Vec3::Constant(1e-9), max + Vec3::Constant(1e-9)}; }

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
  scene.fracture = FractureSettings{STRENGTH};
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

TEST(FractureFull, ATwistedRoundBarBreaksAlongAHelix) {
  constexpr double LENGTH = 1, RADIUS = 0.125;
  for (const int across : {6, 8}) {
    const TetMesh mesh = roundBar(across * 5, across, LENGTH, RADIUS);
    Scene scene = quasiStatic(1e6, 0.2, 0.01);
    const auto left = [](const Vec3& X) { return X[0] < 1e-6; };
    const auto right = [](const Vec3& X) { return X[0] > LENGTH - 1e-6; };
    const auto twist = [](const Vec3& X) { return Vec3(0, -0.005 * X[2], 0.005 * X[1]); };
    scene.boundary = holdEach(mesh, left, mesh, atRest);
    for (const Hold& hold : holdEach(mesh, right, mesh, twist)) scene.boundary.push_back(hold);
    scene.fracture = FractureSettings{1e3};
    DeformableBody body(scene, mesh);
    // The crack runs round the bar; what it leaves is bent, and breaks otherwise.
    double weight = 0, sum = 0, squares = 0, least = 0, most = 0, axial = 0;
    while (most - least < M_PI / 2 && body.steps() < 1000)
      for (const CrackResult& event : body.step().cracks) {
        const Vec3 radial(0, event.where[1], event.where[2]), out = radial.normalized();
        if (event.crack != 0 || radial.norm() < 0.6 * RADIUS) continue;  // the rest is inside
        static Vec3 first;
        if (weight == 0) first = event.where;
        const double round = std::atan2(out.dot(Vec3::UnitX().cross(Vec3(0, first[1], first[2]).normalized())),
                                        out.dot(Vec3(0, first[1], first[2]).normalized()));
        const Vec3 n = event.normal[0] < 0 ? Vec3(-event.normal) : event.normal;
        const double angle = std::atan2(n.dot(Vec3::UnitX().cross(out)), n[0]) * 180 / M_PI;
        const double elements = static_cast<double>(event.elements.size());
        weight += elements;
        sum += elements * angle;
        squares += elements * angle * angle;
        if (round < least) axial = event.where[0] - first[0];
        least = std::min(least, round);
        most = std::max(most, round);
      }
    const double mean = sum / weight;
    std::printf("%d cells across: %.1f degrees from the axis, spread %.1f, over %.0f degrees round the bar\n", across,
                mean, std::sqrt(squares / weight - mean * mean), (most - least) * 180 / M_PI);
    EXPECT_GT(most - least, M_PI / 2);
    EXPECT_NEAR(mean, 45, 8);
    (void)axial;
  }
}

}  // namespace
}  // namespace incision::test

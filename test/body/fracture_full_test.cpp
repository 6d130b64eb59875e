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
  for (const int cells : {4, 8, 16}) {
    double where = 0;
    const double share = bendingShare(cells, &where);
    std::printf("%d cells: %.3f at %.3f\n", cells, share, where);
  }
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
  for (const int across : {6, 8}) {
    const double length = 1, radius = 0.125;
    const TetMesh mesh = roundBar(across * 5, across, length, radius);
    Scene scene = quasiStatic(1e6, 0.2, 0.01);
    scene.solver.threads = 2;
    const auto left = [](const Vec3& X) { return X[0] < 1e-6; };
    const auto right = [&](const Vec3& X) { return X[0] > length - 1e-6; };
    const auto twist = [](const Vec3& X) { return Vec3(0, -0.005 * X[2], 0.005 * X[1]); };
    scene.boundary = holdEach(mesh, left, mesh, atRest);
    for (const Hold& hold : holdEach(mesh, right, mesh, twist)) scene.boundary.push_back(hold);
    scene.fracture = FractureSettings{1e3};
    DeformableBody body(scene, mesh);
    const Breaking run = breakInto(&body, 2, 1000);
    Vec3 sum = Vec3::Zero();
    double w = 0;
    for (auto& e : run.events) {
      const Vec3 radial = Vec3(0, e.where[1], e.where[2]), around = Vec3::UnitX().cross(radial.normalized());
      Vec3 n = e.normal;
      if (n[0] < 0) n = -n;
      const double angle = std::atan2(n.dot(around), n[0]) * 180 / M_PI;
      if (e.elements.size() > 0) {
        sum += e.elements.size() * Vec3(angle, angle * angle, n.dot(radial.normalized()));
        w += e.elements.size();
      }
      std::printf("%.2f c%d el %zu x %.3f r %.3f th %.0f angle %.1f rad %.2f s %.3g\n", e.time, e.crack,
                  e.elements.size(), e.where[0], radial.norm(), std::atan2(e.where[2], e.where[1]) * 180 / M_PI, angle,
                  n.dot(radial.normalized()), e.stress);
    }
    std::printf("across %d: mean %.1f dev %.1f over %g events %zu pieces %d cracks %d\n", across, sum[0] / w,
                std::sqrt(sum[1] / w - std::pow(sum[0] / w, 2)), w, run.events.size(), body.counts().pieces,
                body.counts().cracks);
  }
}

}  // namespace
}  // namespace incision::test

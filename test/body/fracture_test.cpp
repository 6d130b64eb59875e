// What a body does that may break, against known answers.
#include <gtest/gtest.h>

#include <cmath>

#include "support/breaking.h"
#include "support/rig.h"
#include "support/scenes.h"

namespace incision::test {
namespace {

constexpr double STRENGTH = 1e4;  // [Pa]
constexpr double WAIST = 0.46;    // [m]

/// A bar 1 × 0.25 × 0.25 m whose width shrinks by 4 % towards x = WAIST, so that it breaks there, turned by R and
/// pulled apart at its ends.
struct PulledBar {
  explicit PulledBar(const Mat3& R, int threads = 1) : turn(R) {
    const GridSettings grid{{12, 4, 4}, Vec3(1, 0.25, 0.25), Vec3(0, -0.125, -0.125)};
    TetMesh straight = gridMesh(grid);
    for (Vec3& X : straight.nodes) X[1] *= 1 - 0.04 * std::exp(-std::pow((X[0] - WAIST) / 0.2, 2));
    area = 0.96 * 0.25 * 0.25;
    const TetMesh placed = turned(straight, R);
    scene = quasiStatic(1e6, 0, 0.01);
    scene.solver.threads = threads;
    scene.fracture = FractureSettings{STRENGTH};
    const auto left = [](const Vec3& X) { return X[0] < 1e-6; };
    const auto right = [](const Vec3& X) { return X[0] > 1 - 1e-6; };
    const auto pulled = [&](const Vec3&) -> Vec3 { return R * Vec3(0.002, 0, 0); };
    scene.boundary = holdEach(straight, left, placed, atRest);
    for (const Hold& hold : holdEach(straight, right, placed, pulled)) scene.boundary.push_back(hold);
    mesh = placed;
  }

  Breaking pull(DeformableBody* body) const {
    const Vec3 along = turn.col(0);
    return breakInto(body, 2, 800, [&] { return pullOf(*body, along, 1); });
  }

  Mat3 turn;
  double area;
  Scene scene;
  TetMesh mesh;
};

void expectBreaksAtItsStrength(const Mat3& R) {
  const PulledBar bar(R);
  DeformableBody body(bar.scene, bar.mesh);
  const Breaking run = bar.pull(&body);
  EXPECT_EQ(body.counts().pieces, 2);
  EXPECT_EQ(body.counts().cracks, 1);
  EXPECT_NEAR(run.largest_pull, STRENGTH * bar.area, 0.03 * STRENGTH * bar.area);
  std::printf("pull %.5g of %.5g N, %zu events\n", run.largest_pull, STRENGTH * bar.area, run.events.size());
  for (const CrackEvent& event : run.events) {
    std::printf("%.3f x %.3f n %.3f %.3f %.3f el %zu\n", event.time, (R.transpose() * event.where)[0],
                (R.transpose() * event.normal)[0], (R.transpose() * event.normal)[1], (R.transpose() * event.normal)[2],
                event.elements.size());
  }
}

TEST(Fracture, ABarBreaksAtItsStrengthInOnePlaceAcrossThePull) { expectBreaksAtItsStrength(Mat3::Identity()); }

TEST(Fracture, ATurnedBarBreaksAlike) {
  expectBreaksAtItsStrength(Eigen::AngleAxisd(37 * M_PI / 180, Vec3(1, 2, -1.5).normalized()).toRotationMatrix());
}

/// A plate 2 × 2 × 0.1 m, pulled along y at its edges.
Scene pulledPlate() {
  Scene scene = quasiStatic(1e6, 0.2, 0.01);
  scene.body.warping = false;
  scene.body.grid = GridSettings{{24, 24, 1}, Vec3(2, 2, 0.1), Vec3(-1, -1, 0)};
  scene.boundary = {{slab(1, -1), Vec3(0, -0.01, 0)}, {slab(1, 1), Vec3(0, 0.01, 0)}};
  scene.fracture = FractureSettings{STRENGTH};
  return scene;
}

/// A cut from beyond the edge at that side to x = tip, as high as y.
ScheduledCut notch(double side, double tip, double y) {
  const double middle = (1.5 * side + tip) / 2, length = std::abs(1.5 * side - tip);
  return {0, rectangle(Vec3(middle, y, 0.05), Vec3::UnitY(), Vec3::UnitX(), length, 1)};
}

TEST(Fracture, ANotchedPlateBreaksFromItsNotch) {
  Scene scene = pulledPlate();
  scene.cuts = {notch(-1, -0.5, 0.03)};
  DeformableBody body(scene, loadMesh(scene));
  const Breaking run = breakInto(&body, 2, 300);
  for (const CrackEvent& e : run.events) 
    std::printf("%.3f c %d ch %d x %.3f %.3f n %.3f %.3f %.3f el %zu\n", e.time, e.crack, (int)e.change, e.where[0], e.where[1], e.normal[0], e.normal[1], e.normal[2], e.elements.size());
  std::printf("%d pieces %d cracks\n", body.counts().pieces, body.counts().cracks);
}

TEST(Fracture, CracksFromTwoOffsetNotchesFuse) {
  for (double d : {0.0, 0.3}) {
  Scene scene = pulledPlate();
  scene.fracture->fuse_distance = d;
  scene.fracture->fuse_angle = 0.5;
  scene.cuts = {notch(-1, -0.4, -0.09), notch(1, 0.4, 0.12)};
  DeformableBody body(scene, loadMesh(scene));
  const Breaking run = breakInto(&body, 2, 300);
  for (const CrackEvent& e : run.events) 
    std::printf("%.3f c %d ch %d o %d x %.3f %.3f n %.3f %.3f %.3f el %zu\n", e.time, e.crack, (int)e.change, e.other, e.where[0], e.where[1], e.normal[0], e.normal[1], e.normal[2], e.elements.size());
  std::printf("%d pieces %d cracks\n", body.counts().pieces, body.counts().cracks);
  }
}

}  // namespace
}  // namespace incision::test

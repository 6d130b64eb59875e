// What a body does that may break, against known answers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/breaking.h"
#include "support/rig.h"
#include "support/sanitized.h"
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
    scene = quasiStatic(1e6, 0, 0.02);
    scene.solver.threads = threads;
    scene.fracture = tensile(STRENGTH);
    const auto left = [](const Vec3& X) { return X[0] < 1e-6; };
    const auto right = [](const Vec3& X) { return X[0] > 1 - 1e-6; };
    const auto pulled = [&](const Vec3&) -> Vec3 { return R * Vec3(0.002, 0, 0); };
    scene.boundary = clampEach(straight, left, placed, atRest);
    for (const Clamp& clamp : clampEach(straight, right, placed, pulled)) scene.boundary.push_back(clamp);
    mesh = placed;
  }

  Breaking pull(DeformableBody* body) const {
    const Vec3 along = turn.col(0);
    return breakInto(body, 2, 400, [&] { return pullOf(*body, along, 1); });
  }

  Mat3 turn;
  double area;
  Scene scene;
  TetMesh mesh;
};

TEST(Fracture, ABarBreaksAtItsStrengthInOnePlaceAcrossThePull) {
  const PulledBar bar(Mat3::Identity());
  DeformableBody body(bar.scene, bar.mesh);
  const Breaking run = bar.pull(&body);
  EXPECT_EQ(body.counts().pieces, 2);
  EXPECT_EQ(body.counts().cracks, 1);
  EXPECT_NEAR(run.largest_pull, STRENGTH * bar.area, 0.03 * STRENGTH * bar.area);
  for (const CrackResult& event : run.events) {
    EXPECT_NEAR(event.where[0], WAIST, 0.06);  // within an element of 0.083 m
    EXPECT_GT(std::abs(event.normal[0]), std::cos(0.2)) << event.normal.transpose();
  }
}

TEST(Fracture, ATurnedBarBreaksAlike) {
  const Mat3 R = Eigen::AngleAxisd(37 * M_PI / 180, Vec3(1, 2, -1.5).normalized()).toRotationMatrix();
  const PulledBar straight(Mat3::Identity()), turned(R);
  DeformableBody first(straight.scene, straight.mesh), second(turned.scene, turned.mesh);
  const Breaking a = straight.pull(&first), b = turned.pull(&second);
  EXPECT_NEAR(a.largest_pull, b.largest_pull, 1e-9 * a.largest_pull);
  ASSERT_EQ(a.events.size(), b.events.size());
  for (std::size_t i = 0; i < a.events.size(); ++i) {
    EXPECT_EQ(a.events[i].time, b.events[i].time);
    EXPECT_LT((R * a.events[i].where - b.events[i].where).norm(), 1e-6);
    EXPECT_GT(std::abs((R * a.events[i].normal).dot(b.events[i].normal)), 1 - 1e-9);
  }
}

TEST(Fracture, ResultsDoNotDependOnTheThreads) {
  std::vector<std::uint64_t> hashes;
  for (const int threads : SANITIZED ? std::vector<int>{1, 3} : std::vector<int>{1, 2, 3}) {
    const PulledBar bar(Mat3::Identity(), threads);
    DeformableBody body(bar.scene, bar.mesh);
    EXPECT_FALSE(bar.pull(&body).events.empty());
    hashes.push_back(body.stateHash());
  }
  for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes[0]);
}

TEST(Fracture, AResetForgetsTheCracks) {
  const PulledBar bar(Mat3::Identity());
  DeformableBody body(bar.scene, bar.mesh);
  const std::size_t events = bar.pull(&body).events.size();
  const std::uint64_t hash = body.stateHash();
  body.reset();
  EXPECT_EQ(body.counts().cracks, 0);
  EXPECT_EQ(bar.pull(&body).events.size(), events);
  EXPECT_EQ(body.stateHash(), hash);
}

TEST(Fracture, EventsTellWhatHappened) {
  const PulledBar bar(Mat3::Identity());
  DeformableBody body(bar.scene, bar.mesh);
  const Breaking run = bar.pull(&body);
  std::size_t elements = 0;
  double last = 0;
  for (const CrackResult& event : run.events) {
    elements += event.elements.size();
    EXPECT_TRUE(std::is_sorted(event.elements.begin(), event.elements.end()));
    EXPECT_GE(event.time, last);
    last = event.time;
    EXPECT_NEAR(event.normal.norm(), 1, 1e-12);
    EXPECT_EQ(event.kind, FailureKind::TENSION);
    EXPECT_LE(std::max(std::abs(event.where[1]), std::abs(event.where[2])), 0.125);
  }
  EXPECT_EQ(static_cast<int>(elements), body.counts().crack_elements);
  ASSERT_EQ(run.of(CrackChange::STARTED).size(), 1u);
  EXPECT_EQ(run.events[0].change, CrackChange::STARTED);
  EXPECT_NEAR(run.events[0].stress, STRENGTH, 0.004 * STRENGTH);  // what a step adds
}

/// A plate 2 × 2 × 0.1 m, pulled along y at its edges.
Scene pulledPlate() {
  Scene scene = quasiStatic(1e6, 0.2, 0.01);
  scene.body.warping = false;
  scene.body.grid = GridSettings{{24, 24, 1}, Vec3(2, 2, 0.1), Vec3(-1, -1, 0)};
  scene.boundary = {{slab(1, -1), Vec3(0, -0.01, 0)}, {slab(1, 1), Vec3(0, 0.01, 0)}};
  scene.fracture = tensile(STRENGTH);
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
  EXPECT_EQ(body.counts().pieces, 2);
  EXPECT_EQ(body.counts().cracks, 1);
  ASSERT_FALSE(run.events.empty());
  EXPECT_LT((run.events[0].where - Vec3(-0.5, 0.03, 0.05)).norm(), 0.1);  // an element is 0.083 m
  for (const CrackResult& event : run.events) {
    EXPECT_EQ(event.change, CrackChange::GREW);
    EXPECT_NEAR(event.where[1], 0.03, 0.1);
  }
}

TEST(Fracture, CracksFromTwoOffsetNotchesBecomeOne) {
  Scene scene = pulledPlate();
  scene.fracture->fuse_distance = 0.3;
  scene.fracture->fuse_angle = 0.5;
  scene.cuts = {notch(-1, -0.4, -0.09), notch(1, 0.4, 0.12)};
  DeformableBody body(scene, loadMesh(scene));
  const Breaking run = breakInto(&body, 2, 300);
  EXPECT_EQ(body.counts().pieces, 2);
  EXPECT_EQ(run.of(CrackChange::STARTED).size(), 0u);
  const std::vector<CrackResult> fused = run.of(CrackChange::FUSED);
  ASSERT_EQ(fused.size(), 1u);
  EXPECT_EQ(fused[0].crack, 0);
  EXPECT_EQ(fused[0].other, 1);
  EXPECT_LT(fused[0].where.head<2>().norm(), 0.2);
}

TEST(Fracture, ACrackRunsNoFasterThanItMay) {
  constexpr double SPEED = 0.4, ELEMENT = 0.15;  // [m/s]; longest edge of an element in the plate [m]
  Scene scene = pulledPlate();
  for (Clamp& clamp : scene.boundary) clamp.velocity *= 20;
  scene.cuts = {notch(-1, -0.5, 0.03)};
  std::vector<double> reach;
  for (const double speed : {SPEED, std::numeric_limits<double>::infinity()}) {
    scene.fracture->crack_speed = speed;
    DeformableBody body(scene, loadMesh(scene));
    const Breaking run = breakInto(&body, 2, 60);
    const CrackResult &first = run.events.front(), &last = run.events.back();
    double fastest = 0;
    for (const CrackResult& event : run.events)
      if (event.crack == 0) fastest = std::max(fastest, event.where[0] + 0.5 - speed * (event.time - first.time));
    EXPECT_LE(fastest, 2 * ELEMENT);  // nothing is faster than infinity
    reach.push_back((last.where[0] + 0.5) / (last.time - first.time));
  }
  EXPECT_GT(reach[1], 1.5 * SPEED);  // or the bound would not show
}

TEST(Fracture, AColumnSplitsAlongThePush) {
  Scene scene = quasiStatic(1e6, 0.2, 0.02);
  scene.body.grid = GridSettings{{5, 5, 10}, Vec3(0.5, 0.5, 1), Vec3::Zero()};
  scene.boundary = {{slab(2, 0), Vec3::Zero()}, {slab(2, 1), Vec3(0, 0, -0.02)}};
  scene.fracture.emplace();
  scene.fracture->compressive_strength = 2e4;
  DeformableBody body(scene, loadMesh(scene));
  const Breaking run = breakInto(&body, 2, 60);
  ASSERT_GT(run.events.size(), 3u);
  for (const CrackResult& event : run.events) {
    EXPECT_EQ(event.kind, FailureKind::COMPRESSION);
    EXPECT_LT(event.stress, 0);
    EXPECT_LT(std::abs(event.normal[2]), 0.4) << event.normal.transpose();  // the clamps turn the push a little
  }
  EXPECT_LE(run.events[0].stress, -2e4);
}

TEST(Fracture, ResultsWithFusingAndAFractureEnergyDoNotDependOnTheThreads) {
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 3}) {
    Scene scene = pulledPlate();
    scene.body.grid->cells = {12, 12, 1};
    scene.solver.threads = threads;
    scene.fracture->fuse_distance = 0.3;
    scene.fracture->fuse_angle = 0.5;
    scene.fracture->fracture_energy = 20;
    scene.cuts = {notch(-1, -0.4, -0.09), notch(1, 0.4, 0.12)};
    DeformableBody body(scene, loadMesh(scene));
    EXPECT_FALSE(breakInto(&body, 2, 150).events.empty());
    hashes.push_back(body.stateHash());
    if (SANITIZED) continue;
    body.reset();
    breakInto(&body, 2, 150);
    EXPECT_EQ(body.stateHash(), hashes.back());
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

}  // namespace
}  // namespace incision::test

#include "incision/tool/blade/ties.h"

#include <gtest/gtest.h>

#include <memory>

#include "support/blade.h"
#include "support/sanitized.h"
#include "support/tool.h"

namespace incision {
namespace {

/// A block of 0.2 × 0.1 × 0.1 m, held at its far end and pulled open across y, and a blade along z that comes along x.
Scene pulledBlock(int cells, bool progressive, Method method = Method::DIRECT) {
  Scene scene;
  scene.body.grid = GridSettings{{2 * cells, cells, cells}, Vec3(0.2, 0.1, 0.1), Vec3(0, -0.05, 0)};
  // So damped by mass that it follows each step's forces as a static body does.
  scene.body.material = {1e5, 0.3, 10, 20, 0};
  scene.gravity = Vec3::Zero();
  scene.boundary = {{{Vec3(0.2 - 1e-6, -1, -1), Vec3(1, 1, 1)}, Vec3::Zero()}};
  scene.loads = {{{Vec3(-1, 0.05 - 1e-6, -1), Vec3(1, 1, 1)}, Vec3(0, 200, 0), 0},
                 {{Vec3(-1, -1, -1), Vec3(1, -0.05 + 1e-6, 1)}, Vec3(0, -200, 0), 0}};
  scene.solver.method = method;
  scene.solver.tolerance = 1e-9;
  scene.tools = {bladeTool(Edge{Vec3(0, 0, -0.05), Vec3(0, 0, 0.15)})};
  bladeOf(&scene.tools[0]).cutting.progressive = progressive;
  return scene;
}

constexpr double OFF_NODES = 0.003;  // off the planes of nodes

/// How far the mouth of the slit is open: what the block's corners at x = 0 are apart, less at rest [m].
double opening(const DeformableBody& body) {
  const std::vector<Vec3> x = body.nodePositions();
  const std::vector<Vec3>& X = body.mesh().mesh().nodes;
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < X.size(); ++i)
    if (X[i].x() < 1e-9 && std::abs(X[i].y()) > 0.05 - 1e-9) {
      sum += std::copysign(1, X[i].y()) * (x[i].y() - X[i].y());
      ++count;
    }
  return 2 * sum / count;
}

struct Course {
  std::vector<double> opening, energy;
  static double largestJump(const std::vector<double>& values) {
    double most = 0;
    for (std::size_t k = 1; k < values.size(); ++k) most = std::max(most, std::abs(values[k] - values[k - 1]));
    return most / std::abs(values.back() - values.front());
  }
};

/// The blade goes from 0.01 m before the block to 0.11 m into it, by so many moves.
Course course(int cells, int moves, bool progressive) {
  const Scene scene = pulledBlock(cells, progressive);
  DeformableBody body(scene, loadMesh(scene));
  Course course;
  for (int k = 0; k < 20; ++k) body.step();
  for (int k = 0; k <= moves; ++k) {
    body.guideTool({poseAt(-0.01 + 0.12 * k / moves, OFF_NODES)});
    for (int rest = 0; rest < 6; ++rest) body.step();
    course.opening.push_back(opening(body));
    course.energy.push_back(body.motion().elastic_energy);
  }
  return course;
}

TEST(Ties, OpeningAndEnergyDoNotJumpWhereTheBladeEntersAnElement) {
  // As fine as a sweep is followed in such elements, and what is swept is reckoned in hundredths: the steepest course
  // there is, where the last that holds a row of elements gives way, still goes by steps.
  const Course smooth = course(3, 360, true);
  EXPECT_LT(Course::largestJump(smooth.opening), 0.12);
  EXPECT_LT(Course::largestJump(smooth.energy), 0.12);
  if (test::SANITIZED) return;
  const Course whole = course(3, 360, false);
  EXPECT_GT(Course::largestJump(whole.opening), 0.4);
}

/// The body after the blade has gone to x, at rest.
std::unique_ptr<DeformableBody> cutTo(const Scene& scene, double x) {
  auto body = std::make_unique<DeformableBody>(scene, loadMesh(scene));
  body->placeTool(poseAt(-0.01, OFF_NODES));
  for (int k = 1; k <= 40; ++k) {
    body->guideTool({poseAt(-0.01 + (x + 0.01) * k / 40, OFF_NODES)});
    body->step();
  }
  for (int k = 0; k < 60; ++k) body->step();
  return body;
}

TEST(Ties, WhatTheBladeHasHardlyEnteredBehavesAsUncut) {
  const Scene scene = pulledBlock(2, true);
  const auto uncut = cutTo(scene, -0.005), entered = cutTo(scene, 0.009);
  EXPECT_EQ(uncut->counts().cracks, 0);
  EXPECT_EQ(entered->counts().cracks, 1);
  // The blade is at a fifth of the first element: what it has freed is 0.9 % of the block's section.
  EXPECT_NEAR(opening(*entered), opening(*uncut), 0.1 * opening(*uncut));
}

TEST(Ties, IterativeAndDirectAgree) {
  const auto direct = cutTo(pulledBlock(3, true), 0.07);
  const auto iterative = cutTo(pulledBlock(3, true, Method::ITERATIVE), 0.07);
  EXPECT_EQ(direct->counts().parts, iterative->counts().parts);
  EXPECT_NEAR(opening(*direct), opening(*iterative), 1e-4 * opening(*direct));
}

TEST(Ties, TheBodyIsInPiecesOnlyWhereTheBladeHasLeftIt) {
  Scene scene = plateAndBlade();
  DeformableBody body(scene, loadMesh(scene));
  body.placeTool(poseAt(-0.1, 0.21));
  for (int k = 1; k <= 120; ++k) {
    const double x = -0.1 + 0.01 * k;
    body.guideTool({poseAt(x, 0.21)});
    body.step();
    if (x < 0.99) {
      EXPECT_EQ(body.counts().pieces, 1) << x;
    }
  }
  EXPECT_EQ(body.counts().pieces, 2);
}

TEST(Ties, ASecondCutMayCrossWhatIsTied) {
  Scene scene = plateAndBlade();
  DeformableBody body(scene, loadMesh(scene));
  draw(&body, along(30, [](double s) { return poseAt(-0.1 + 0.63 * s, 0.21); }));  // stops at x = 0.53
  PlaneCut plane;
  plane.point = Vec3(0.6, 0, 0);
  plane.normal = Vec3::UnitX();
  EXPECT_EQ(body.cut(plane).status, CutStatus::APPLIED);
  for (int k = 0; k < 20; ++k) body.step();
  EXPECT_EQ(body.counts().pieces, 2);
  draw(&body, along(30, [](double s) { return poseAt(0.53 + 0.6 * s, 0.21); }));
  EXPECT_EQ(body.counts().pieces, 4);
  double sum = 0;
  for (const double volume : body.pieceVolumes()) sum += volume;
  EXPECT_NEAR(sum, 0.125, 1e-12);
}

}  // namespace
}  // namespace incision

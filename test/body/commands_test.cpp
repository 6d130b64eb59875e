// What cuts do to a moving body, and that the same commands give the same state.
#include <gtest/gtest.h>

#include <limits>

#include "support/random.h"
#include "support/scenes.h"

namespace incision {
namespace {

using test::clampLeftEnd;
using test::makeBody;
using test::plane;
using test::rectangle;
using test::softBar;

Scene swinging(Method method, int threads, Mass mass = Mass::LUMPED) {
  Scene scene = softBar();
  scene.body.mass = mass;
  scene.gravity = Vec3(0, 1, -9.81);
  scene.boundary = {clampLeftEnd()};
  scene.solver.method = method;
  scene.solver.threads = threads;
  scene.cuts = test::crossingCuts(0.02);
  return scene;
}

TEST(StateHash, IsTheSameForEveryThreadCountAndAfterAReset) {
  for (Mass mass : {Mass::LUMPED, Mass::CONSISTENT})
    for (Method method : {Method::DIRECT, Method::ITERATIVE}) {
      std::vector<std::uint64_t> first;
      for (int threads : {1, 2, 4}) {
        DeformableBody body = makeBody(swinging(method, threads, mass));
        for (int run = 0; run < 2; ++run) {
          std::vector<std::uint64_t> hashes = {body.stateHash()};
          for (int k = 0; k < 20; ++k) {
            body.step();
            hashes.push_back(body.stateHash());
          }
          EXPECT_EQ(body.counts().cracks, 3);
          if (first.empty()) first = hashes;
          EXPECT_EQ(hashes, first) << threads << " threads, run " << run;
          body.reset();
        }
      }
      for (std::size_t k = 1; k < first.size(); ++k) EXPECT_NE(first[k], first[k - 1]);
    }
}

TEST(StateHash, TellsCommandsApart) {
  Scene scene = swinging(Method::DIRECT, 1);
  DeformableBody a = makeBody(scene);
  scene.cuts.pop_back();
  DeformableBody b = makeBody(scene);
  test::run(&a, 10);
  test::run(&b, 10);
  EXPECT_EQ(a.stateHash(), b.stateHash());
  test::run(&a, 1);
  test::run(&b, 1);
  EXPECT_NE(a.stateHash(), b.stateHash());
}

TEST(Reset, LeavesNoTraceOfEarlierCuts) {
  DeformableBody body = makeBody(swinging(Method::DIRECT, 1));
  const std::uint64_t start = body.stateHash();
  test::run(&body, 15);
  body.cut(plane(Vec3(0.8, 0, 0), Vec3::UnitX()));
  body.reset();
  EXPECT_EQ(body.stateHash(), start);
  EXPECT_EQ(body.counts().cracks, 0);
  EXPECT_EQ(body.counts().pieces, 1);
  EXPECT_EQ(body.steps(), 0);
}

TEST(Cut, IsAppliedBeforeTheFirstStepThatStartsAtItsTimeOrLater) {
  for (const auto& [time, step] : {std::pair(0.0, 0), {0.02, 2}, {0.02 + 5e-10, 2}, {0.021, 3}, {0.03 - 5e-10, 3}}) {
    Scene scene = softBar();
    scene.cuts = {{time, plane(Vec3(0.51, 0, 0), Vec3::UnitX())}};
    DeformableBody body = makeBody(scene);
    for (int k = 0; k < 5; ++k) EXPECT_EQ(body.step().cuts.size(), k == step ? 1u : 0u) << time << " s, step " << k;
  }
}

TEST(Cut, ReportsWhatItDid) {
  DeformableBody body = makeBody(softBar());
  const BodyCounts before = body.counts();
  PlaneCut cut = plane(Vec3(0.51, 0, 0), Vec3::UnitX());
  cut.label = "first";
  const CutResult result = body.cut(cut);
  const BodyCounts after = body.counts();
  EXPECT_EQ(result.label, "first");
  EXPECT_EQ(result.status, CutStatus::APPLIED);
  EXPECT_EQ(result.reason, "");
  EXPECT_EQ(result.cracks, 1);
  EXPECT_EQ(result.parts_split, after.parts - before.parts);
  EXPECT_EQ(result.copies_added, after.copies - before.copies);
  EXPECT_EQ(result.pieces, 2);
  EXPECT_EQ(after.dofs, 3 * after.copies);
  EXPECT_EQ(after.crack_elements, result.parts_split);
}

TEST(Cut, ThatMissesOrIsRefusedSaysWhyAndChangesNothing) {
  DeformableBody body = makeBody(swinging(Method::DIRECT, 1));
  test::run(&body, 12);
  const std::uint64_t before = body.stateHash();
  const std::uint64_t topology = body.topologyVersion();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<PlaneCut, CutStatus>> cuts = {
      {plane(Vec3(9, 0, 0), Vec3::UnitX()), CutStatus::MISSED},
      {rectangle(Vec3(0.2, 0.1, 0), Vec3::UnitX(), Vec3::UnitY(), 1e-4, 1e-4), CutStatus::MISSED},
      {rectangle(Vec3(0.2, 5, 0), Vec3::UnitX(), Vec3::UnitY(), 0.1, 0.1), CutStatus::MISSED},
      {plane(Vec3(0.2, 0, 0), Vec3::Zero()), CutStatus::REJECTED},
      {plane(Vec3(nan, 0, 0), Vec3::UnitX()), CutStatus::REJECTED},
      {rectangle(Vec3(0.2, 0, 0), Vec3::UnitX(), Vec3::UnitX(), 1, 1), CutStatus::REJECTED},
      {rectangle(Vec3(0.2, 0, 0), Vec3::UnitX(), Vec3::UnitY(), -1, 1), CutStatus::REJECTED}};
  for (const auto& [cut, status] : cuts) {
    const CutResult result = body.cut(cut);
    EXPECT_EQ(result.status, status);
    EXPECT_NE(result.reason, "");
    EXPECT_EQ(result.cracks, 0);
    EXPECT_EQ(result.parts_split, 0);
    EXPECT_EQ(result.copies_added, 0);
    EXPECT_EQ(result.pieces, body.counts().pieces);
  }
  EXPECT_EQ(body.stateHash(), before);
  EXPECT_EQ(body.topologyVersion(), topology);
}

TEST(Cut, MadeAgainAtRestOrAfterMotionWithinSnapDoesNothing) {
  Scene scene = softBar();
  scene.gravity = Vec3(0.3, 0.2, -0.5);
  scene.solver.time_step = 1e-3;
  DeformableBody body = makeBody(scene);
  const PlaneCut cut = plane(Vec3(0.537, 0.11, 0.13), Vec3(1, 0.21, 0.13));
  EXPECT_EQ(body.cut(cut).status, CutStatus::APPLIED);
  EXPECT_EQ(body.cut(cut).status, CutStatus::MISSED);
  test::run(&body, 3);  // falls by 4e-6 m, a third of snap
  ASSERT_LT(body.motion().max_displacement, SNAP * 0.125);
  ASSERT_GT(body.motion().max_displacement, 0.1 * SNAP * 0.125);
  const BodyCounts before = body.counts();
  EXPECT_EQ(body.cut(cut).status, CutStatus::MISSED);
  EXPECT_EQ(body.counts().parts, before.parts);
  EXPECT_EQ(body.counts().copies, before.copies);
}

TEST(Cut, ARectangleInsideTheBodyLeavesItInOnePiece) {
  DeformableBody body = makeBody(swinging(Method::DIRECT, 1));
  const CutResult result = body.cut(rectangle(Vec3(0.51, 0.125, 0.125), Vec3::UnitX(), Vec3::UnitY(), 0.2, 0.2));
  EXPECT_EQ(result.status, CutStatus::APPLIED);
  EXPECT_EQ(result.pieces, 1);
}

bool allFinite(const DeformableBody& body) {
  for (const auto* values : {&body.positions(), &body.velocities()})
    for (const Vec3& value : *values)
      if (!value.allFinite()) return false;
  return true;
}

// The right end is driven through the left one, so that elements collapse and turn inside out.
TEST(Extremes, ABodyDrivenThroughItselfStaysFiniteAndCanBeCut) {
  for (Method method : {Method::DIRECT, Method::ITERATIVE}) {
    Scene scene = softBar();
    scene.solver.method = method;
    scene.boundary = {clampLeftEnd(), {{Vec3(0.999, -1, -1), Vec3(2, 1, 1)}, Vec3(-20, 0, 0)}};
    scene.cuts = {{0, plane(Vec3(0.51, 0, 0), Vec3(1, 0.1, 0.2))},
                  {0.05, plane(Vec3(0, 0.12, 0.12), Vec3(0, 1, 0.3))},
                  {0.08, plane(Vec3(-0.2, 0, 0), Vec3(1, 0.1, 0))}};
    DeformableBody body = makeBody(scene);
    for (int k = 0; k < 20; ++k) {
      body.step();
      ASSERT_TRUE(allFinite(body)) << "step " << k;
    }
  }
}

TEST(Extremes, TwentyPlanesThroughASmallMovingBodyStayFinite) {
  for (Method method : {Method::DIRECT, Method::ITERATIVE}) {
    Scene scene = softBar();
    scene.body.grid->cells = {3, 2, 2};
    scene.gravity = Vec3(0, 0, -9.81);
    scene.boundary = {clampLeftEnd()};
    scene.solver.method = method;
    test::Random random(65);
    for (int k = 0; k < 20; ++k) scene.cuts.push_back({0.005 * k, random.plane(*scene.body.grid)});
    DeformableBody body = makeBody(scene);
    for (int k = 0; k < 20; ++k) {
      body.step();
      ASSERT_TRUE(allFinite(body)) << "step " << k;
    }
    EXPECT_NEAR(body.motion().mass, 62.5, 1e-12 * 62.5);
    double volume = 0;
    for (double v : body.pieceVolumes()) volume += v;
    EXPECT_NEAR(volume, 0.0625, 1e-12);
  }
}

}  // namespace
}  // namespace incision

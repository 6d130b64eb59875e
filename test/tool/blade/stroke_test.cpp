#include "incision/tool/blade/stroke.h"

#include <gtest/gtest.h>

#include <cmath>

#include "incision/body/deformable_body.h"
#include "support/tool.h"

namespace incision {
namespace {

// Moves the tool in a step; the stroke that ended in it, if one did.
std::optional<CutResult> moveTool(DeformableBody* body, const Pose& pose) {
  body->guideTool({pose});
  const std::vector<CutResult> cuts = body->step().cuts;
  return cuts.empty() ? std::nullopt : std::optional<CutResult>(cuts.back());
}

// A block of 1 × 0.5 × 0.5 m and a blade along z that reaches through all of its height.
class StrokeTest : public ::testing::Test {
 protected:
  static Scene scene() {
    Scene scene;
    scene.body.grid = GridSettings{{8, 4, 4}, Vec3(1, 0.5, 0.5), Vec3::Zero()};
    scene.gravity = Vec3::Zero();
    scene.solver.method = Method::DIRECT;
    scene.tools = {bladeTool(Edge{Vec3(0, 0, -0.4), Vec3(0, 0, 0.4)})};
    return scene;
  }

  explicit StrokeTest(const Scene& s = scene()) : body(s, loadMesh(s)) {}

  std::optional<CutResult> place(double x, double y, double z = 0.25) {
    return moveTool(&body, {Vec3(x, y, z), Eigen::Quaterniond::Identity()});
  }

  // Calls `move` with shares from 0 to 1 and returns the last result it gave.
  template <typename Move>
  static std::optional<CutResult> draw(int moves, const Move& move) {
    std::optional<CutResult> last;
    for (int k = 0; k <= moves; ++k)
      if (const std::optional<CutResult> result = move(k / static_cast<double>(moves))) last = result;
    return last;
  }

  // Draws the blade along x at height y in equal moves.
  std::optional<CutResult> drawAlongX(double from, double to, double y, int moves) {
    return draw(moves, [&](double s) { return place(from + (to - from) * s, y); });
  }

  void expectPieces(const std::vector<double>& volumes) {
    const std::vector<double> found = body.pieceVolumes();
    ASSERT_EQ(found.size(), volumes.size());
    for (std::size_t i = 0; i < volumes.size(); ++i) EXPECT_NEAR(found[i], volumes[i], 1e-12);
  }

  void expectUncut() {
    EXPECT_EQ(body.counts().cracks, 0);
    EXPECT_EQ(body.counts().pieces, 1);
    EXPECT_EQ(body.counts().parts, body.counts().elements);
    EXPECT_EQ(body.counts().copies, body.counts().nodes);
  }

  DeformableBody body;
};

constexpr double Y = 0.21;  // within the second row of elements
const std::vector<double> HALVES = {0.5 * Y, 0.5 * (0.5 - Y)};

TEST_F(StrokeTest, OpensASlitWhereItEndsInside) {
  EXPECT_FALSE(drawAlongX(-0.1, 0.6, Y, 7));
  const BodyCounts counts = body.counts();
  EXPECT_EQ(counts.pieces, 1);
  EXPECT_EQ(counts.cracks, 1);
  EXPECT_GT(counts.copies, counts.nodes);
  // It reaches about as far as the blade went: an element of 0.125 m more or less.
  for (int p = 0; p < counts.parts; ++p) {
    const Part& part = body.mesh().parts()[p];
    if (part.detail < 0) continue;
    double nearest = 1;
    for (int node : body.mesh().mesh().elements[part.element])
      nearest = std::min(nearest, body.mesh().mesh().nodes[node].x());
    EXPECT_LE(nearest, 0.6);
  }
}

TEST_F(StrokeTest, DrawnThroughSeparatesAsAPlaneDoes) {
  const std::optional<CutResult> result = drawAlongX(-0.1, 1.1, Y, 12);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->status, CutStatus::APPLIED);
  EXPECT_EQ(result->label, "tool");
  EXPECT_EQ(result->cracks, 1);
  EXPECT_EQ(result->pieces, 2);
  EXPECT_EQ(body.counts().cracks, 1);
  expectPieces(HALVES);

  DeformableBody cut(scene(), loadMesh(scene()));
  PlaneCut plane;
  plane.point = Vec3(0, Y, 0);
  plane.normal = Vec3::UnitY();
  const CutResult by_plane = cut.cut(plane);
  EXPECT_EQ(result->parts_split, by_plane.parts_split);
  EXPECT_EQ(result->copies_added, by_plane.copies_added);
}

TEST_F(StrokeTest, NumberOfPosesDoesNotMatter) {
  for (const int moves : {1, 2, 5, 30, 200}) {
    body.reset();
    ASSERT_TRUE(drawAlongX(-0.1, 1.1, Y, moves));
    EXPECT_EQ(body.counts().cracks, 1) << moves;
    expectPieces(HALVES);
  }
}

TEST_F(StrokeTest, AlongAnObliqueLineSeparatesToo) {
  for (const int moves : {1, 7, 60}) {
    body.reset();
    ASSERT_TRUE(draw(moves, [&](double s) { return place(0.3 + 0.35 * s, -0.1 + 0.7 * s); }));
    expectPieces({0.475 * 0.25, 0.525 * 0.25});
  }
}

TEST_F(StrokeTest, BackInTheSameSlitCutsNothing) {
  drawAlongX(-0.1, 0.6, Y, 7);
  const BodyCounts before = body.counts();
  for (int k = 6; k >= 0; --k) place(-0.1 + 0.1 * k, Y);
  for (int k = 1; k <= 7; ++k) place(-0.1 + 0.1 * k, Y);
  EXPECT_EQ(body.counts().parts, before.parts);
  EXPECT_EQ(body.counts().copies, before.copies);
  EXPECT_EQ(body.counts().cracks, 1);
}

TEST_F(StrokeTest, SecondStrokeInTheSameSlitCutsNothing) {
  drawAlongX(-0.1, 0.6, Y, 7);
  const std::optional<CutResult> first = body.liftTool();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->status, CutStatus::APPLIED);
  const BodyCounts before = body.counts();
  drawAlongX(-0.1, 0.5, Y, 9);
  EXPECT_FALSE(body.liftTool());
  EXPECT_EQ(body.counts().parts, before.parts);
  EXPECT_EQ(body.counts().copies, before.copies);
  EXPECT_EQ(body.counts().cracks, 1);
}

TEST_F(StrokeTest, ContinuedSlitSeparatesInTheEnd) {
  drawAlongX(-0.1, 0.6, Y, 7);
  body.liftTool();
  ASSERT_TRUE(drawAlongX(0.5, 1.1, Y, 6));
  expectPieces(HALVES);
}

// A soft block that sags by 4 cm while it is cut.
TEST(StrokeInMovingTissue, SeparatesLikeAtRest) {
  Scene scene;
  scene.body.grid = GridSettings{{10, 6, 4}, Vec3(0.2, 0.12, 0.08), Vec3::Zero()};
  scene.body.material = {1e5, 0.4, 1000, 1, 0};
  scene.boundary = {{{Vec3::Constant(-1), Vec3(1e-6, 1, 1)}, Vec3::Zero()}};
  scene.tools = {bladeTool(Edge{Vec3(0, 0, -0.3), Vec3(0, 0, 0.3)})};
  for (int k = 0; k <= 80; ++k)
    scene.tools[0].poses.push_back({0.01 * k, {Vec3(0.085, -0.02 + 0.002 * k, 0), Eigen::Quaterniond::Identity()}});
  DeformableBody body(scene, loadMesh(scene));
  std::vector<CutResult> strokes;  // after the first, what it has cut off may swing back into the blade
  for (int k = 0; k <= 80; ++k)
    for (const CutResult& cut : body.step().cuts) strokes.push_back(cut);
  ASSERT_FALSE(strokes.empty());
  EXPECT_EQ(strokes[0].pieces, 2);
  EXPECT_EQ(strokes[0].cracks, 1);
  EXPECT_EQ(body.counts().pieces, 2);
}

TEST_F(StrokeTest, AcrossAnotherMakesFourPieces) {
  ASSERT_TRUE(drawAlongX(-0.1, 1.1, Y, 12));
  body.liftTool();
  const std::optional<CutResult> result = draw(7, [&](double s) { return place(0.53, -0.1 + 0.7 * s); });
  ASSERT_TRUE(result);
  EXPECT_EQ(result->pieces, 4);
  EXPECT_EQ(body.counts().cracks, 2);
  double sum = 0;
  for (double volume : body.pieceVolumes()) sum += volume;
  EXPECT_NEAR(sum, 0.25, 1e-12);
}

TEST_F(StrokeTest, RoundACurveSeparatesNearIt) {
  // An arc of radius 0.6 round the origin.
  const double radius = 0.6, first = -0.15, last = std::asin(0.55 / radius);
  for (const int moves : {20, 80}) {
    body.reset();
    const std::optional<CutResult> result = draw(moves, [&](double s) {
      const double angle = first + (last - first) * s;
      return place(radius * std::cos(angle), radius * std::sin(angle));
    });
    ASSERT_TRUE(result) << moves;
    EXPECT_EQ(result->pieces, 2) << moves;
    EXPECT_EQ(body.counts().cracks, 1);
    const double inside = 0.5 * (0.25 * std::sqrt(0.36 - 0.25) + 0.18 * std::asin(0.5 / radius));
    // Within a tenth of the cells (0.125 m) that the arc's area of about 0.29 m² passes.
    for (double volume : body.pieceVolumes())
      EXPECT_LT(std::min(std::abs(volume - inside), std::abs(volume - (0.25 - inside))), 0.0125 * 0.29) << moves;
  }
}

TEST_F(StrokeTest, AtRestDoesNothing) {
  for (int k = 0; k < 5; ++k) place(0.4, Y);
  expectUncut();
}

TEST_F(StrokeTest, AlongItsOwnEdgeDoesNothing) {
  for (int k = 0; k < 5; ++k) place(0.4, Y, 0.25 + 0.02 * k);
  expectUncut();
}

TEST_F(StrokeTest, RoundItsOwnEdgeDoesNothing) {
  for (int k = 0; k < 5; ++k)
    moveTool(&body, {Vec3(0.4, Y, 0.25), Eigen::Quaterniond(Eigen::AngleAxisd(0.3 * k, Vec3::UnitZ()))});
  expectUncut();
}

TEST_F(StrokeTest, TremblingAtRestDoesNothing) {
  for (int k = 0; k < 50; ++k) place(0.4 + 1e-15 * std::sin(k), Y + 1e-15 * std::cos(3 * k), 0.25 + 1e-15 * (k % 3));
  expectUncut();
}

TEST_F(StrokeTest, CutsOnAfterItRested) {
  place(-0.1, Y);
  for (int x = 1; x <= 12; ++x)
    for (int k = 0; k < 3; ++k) place(-0.1 + 0.1 * x, Y, 0.25 + 0.01 * k);
  EXPECT_EQ(body.counts().cracks, 1);
  expectPieces(HALVES);
}

TEST_F(StrokeTest, BesideTheBodyDoesNothing) {
  drawAlongX(-0.1, 1.1, 0.7, 12);
  EXPECT_EQ(body.counts().cracks, 0);
  EXPECT_FALSE(body.liftTool());
}

TEST_F(StrokeTest, FirstPoseAfterLiftingOnlyPlaces) {
  place(-0.1, Y);
  body.liftTool();
  place(1.1, Y);
  EXPECT_EQ(body.counts().cracks, 0);
}

TEST_F(StrokeTest, LeavesPositionsAndMomentumAsTheyAre) {
  const std::vector<Vec3> before = body.nodePositions();
  drawAlongX(-0.1, 1.1, Y, 12);
  EXPECT_EQ(body.nodePositions(), before);
  EXPECT_EQ(body.motion().momentum, Vec3::Zero());
}

TEST_F(StrokeTest, InAFallingBodySeparatesIt) {
  Scene falling = scene();
  falling.gravity = Vec3(0, 0, -1);
  DeformableBody moving(falling, loadMesh(falling));
  ASSERT_TRUE(draw(24, [&](double s) {
    // It falls by 0.03 m in all, which the blade's length allows.
    return moveTool(&moving, {Vec3(-0.1 + 1.2 * s, Y, 0.25), Eigen::Quaterniond::Identity()});
  }));
  EXPECT_EQ(moving.counts().cracks, 1);
  const std::vector<double> volumes = moving.pieceVolumes();
  ASSERT_EQ(volumes.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(volumes[i], HALVES[i], 1e-12);
}

TEST_F(StrokeTest, InAStretchedBodyCutsWhereTheMaterialIs) {
  Scene stretched = scene();
  stretched.body.material = {1e6, 0, 1e-9, 0, 0};  // light: stretched evenly at once
  stretched.boundary = {{{Vec3(-1, -1, -1), Vec3(1e-6, 1, 1)}, Vec3::Zero()},
                        {{Vec3(1 - 1e-6, -1, -1), Vec3(2, 1, 1)}, Vec3(1, 0, 0)}};
  stretched.solver.time_step = 0.1;
  DeformableBody moving(stretched, loadMesh(stretched));
  for (int k = 0; k < 10; ++k) moving.step();
  std::vector<Pose> path;  // within one step, in which the body grows from 2 m to 2.1 m
  for (int k = 0; k <= 7; ++k)
    path.push_back({Vec3(0.52 * (2 + 0.1 * k / 7), -0.1 + 0.1 * k, 0.25), Eigen::Quaterniond::Identity()});
  moving.guideTool(path);
  ASSERT_EQ(moving.step().cuts.size(), 1u);
  const std::vector<double> volumes = moving.pieceVolumes();
  ASSERT_EQ(volumes.size(), 2u);
  // Distances of one element's nodes are measured while the body grows by up to 1.4 %: of an element, 0.1 % of the
  // body.
  EXPECT_NEAR(volumes[0], 0.48 * 0.25, 2e-5);
  EXPECT_NEAR(volumes[1], 0.52 * 0.25, 2e-5);
}

TEST_F(StrokeTest, TheScenesPosesAreFollowed) {
  Scene scripted = scene();
  scripted.tools[0].poses = {{0, {Vec3(-0.1, Y, 0.25), Eigen::Quaterniond::Identity()}},
                             {0.1, {Vec3(1.1, Y, 0.25), Eigen::Quaterniond::Identity()}}};
  DeformableBody moving(scripted, loadMesh(scripted));
  int ended = 0;
  for (int k = 0; k < 15; ++k)
    for (const CutResult& cut : moving.step().cuts) {
      ++ended;
      EXPECT_EQ(cut.status, CutStatus::APPLIED);
      EXPECT_EQ(cut.pieces, 2);
    }
  EXPECT_EQ(ended, 1);
  EXPECT_EQ(moving.counts().pieces, 2);
}

TEST_F(StrokeTest, ResetForgetsTheSlit) {
  drawAlongX(-0.1, 0.6, Y, 7);
  body.reset();
  EXPECT_EQ(body.counts().cracks, 0);
  EXPECT_EQ(body.counts().copies, body.counts().nodes);
  place(0.9, Y);  // only places
  EXPECT_EQ(body.counts().cracks, 0);
}

}  // namespace
}  // namespace incision

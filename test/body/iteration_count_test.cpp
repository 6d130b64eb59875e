// Guards the speed of the iteration without a clock: iterations of 60 steps on two threads. Each bound stands some 12 %
// above what was counted when it was last set, the larger count of the core's two builds; whoever makes the iteration
// better brings it down.
#include <gtest/gtest.h>

#include "incision/base/resolve_path.h"
#include "support/sanitized.h"
#include "support/scenes.h"

namespace incision::test {
namespace {

constexpr int STEPS = 60;

// A factorisation leaves a residual of rounding alone, an iteration a share of its tolerance.
constexpr double FACTORISED = 1e-8;

// When a cut is made, if one is [s]: before the 31st step of 0.01 s.
constexpr double MIDWAY = 0.3;

Scene cutMidway(Scene scene, const PlaneCut& cut) {
  scene.cuts = {{MIDWAY, cut}};
  return scene;
}

int totalIterations(const Scene& scene) {
  DeformableBody body(scene, loadMesh(scene), loadDescriptions(scene));
  int total = 0;
  for (int k = 0; k < STEPS; ++k) {
    const StepResult step = body.step();
    for (const CutResult& cut : step.cuts) EXPECT_EQ(cut.status, CutStatus::APPLIED);
    EXPECT_GT(step.residual, FACTORISED) << "at step " << k;
    total += step.iterations;
  }
  return total;
}

const std::array<int, 3> SMALL = {16, 4, 4}, LARGE = {32, 8, 8};

Scene organ() {
  return loadScene(resolvePath("package://incision/config/scenes/demo.yaml", ""),
                   {"solver.method=iterative", "solver.tolerance=1e-4"});
}

const PlaneCut ORGAN_CUT = plane(Vec3(0.1, 0, 0), Vec3(1, 0.1, 0.05));

class IterationCount : public ::testing::Test {
 protected:
  // The same number on every build, but for last digits: the sanitizers' slow one need not find it again.
  void SetUp() override {
    if (SANITIZED) GTEST_SKIP() << "takes too long under the sanitizers";
  }
};

TEST_F(IterationCount, OfASoftBarKeepsItsBounds) {
  EXPECT_LE(totalIterations(swingingBar(SMALL, 1e6)), 1430);  // counted: 1280
  EXPECT_LE(totalIterations(swingingBar(LARGE, 1e6)), 1690);  // counted: 1512
}

TEST_F(IterationCount, OfAStiffBarKeepsItsBounds) {
  EXPECT_LE(totalIterations(swingingBar(SMALL, 1e8)), 1960);  // counted: 1753
  EXPECT_LE(totalIterations(swingingBar(LARGE, 1e8)), 3040);  // counted: 2717
}

TEST_F(IterationCount, OfASoftBarThatIsCutKeepsItsBounds) {
  EXPECT_LE(totalIterations(cutMidway(swingingBar(SMALL, 1e6), slantedCut())), 1980);  // counted: 1765
  EXPECT_LE(totalIterations(cutMidway(swingingBar(LARGE, 1e6), slantedCut())), 2320);  // counted: 2074
}

TEST_F(IterationCount, OfAStiffBarThatIsCutKeepsItsBounds) {
  EXPECT_LE(totalIterations(cutMidway(swingingBar(SMALL, 1e8), slantedCut())), 2180);  // counted: 1950
  EXPECT_LE(totalIterations(cutMidway(swingingBar(LARGE, 1e8), slantedCut())), 3270);  // counted: 2920
}

TEST_F(IterationCount, OfTheOrganKeepsItsBounds) {
  EXPECT_LE(totalIterations(organ()), 1670);                        // counted: 1494
  EXPECT_LE(totalIterations(cutMidway(organ(), ORGAN_CUT)), 1870);  // counted: 1670
}

// Halves, a soft core, a soft layer under a stiff one, and a soft slice, each ten thousand times softer than the rest.
TEST_F(IterationCount, OfNeighboursThatDifferMuchIsAtMostTwiceThatOfTheStifferAlone) {
  const int alone = totalIterations(swingingBar(SMALL, 1e6));
  for (const auto& [min, max] : {std::pair{Vec3(0.5, -1, -1), Vec3(2, 2, 2)},
                                 {Vec3(0.3, 0.08, 0.08), Vec3(0.7, 0.17, 0.17)},
                                 {Vec3(-1, -1, 0.125), Vec3(2, 2, 2)},
                                 {Vec3(0.45, -1, -1), Vec3(0.55, 2, 2)}}) {
    Scene scene = swingingBar(SMALL, 1e6);
    scene.body.regions.resize(1);
    scene.body.regions[0].place = {min, max};
    scene.body.regions[0].young_modulus = 1e2;
    EXPECT_LE(totalIterations(scene), 2 * alone) << min.transpose();  // counted: 0.7 to 1.2 times
  }
}

}  // namespace
}  // namespace incision::test

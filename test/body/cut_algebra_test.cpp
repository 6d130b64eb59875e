#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <string>

#include "support/rig.h"

namespace incision {
namespace {

constexpr double EPSILON = std::numeric_limits<double>::epsilon();

// Rest volumes of the pieces, in the order of copyPieces.
std::vector<double> pieceVolumes(const Rig& rig) {
  int count = 0;
  const std::vector<int> piece = rig.mesh.copyPieces(&count);
  std::vector<double> volumes(count, 0);
  for (std::size_t p = 0; p < rig.mesh.parts().size(); ++p)
    volumes[piece[rig.mesh.parts()[p].copies[0]]] += rig.step.assembly().volume(static_cast<int>(p));
  return volumes;
}

// The bar of code_aster's SSNV173: 5 × 5 × 25 m of six tetrahedra, its base held, its top moved by 1e-6 m in a second.
class Separation : public ::testing::Test {
 protected:
  static constexpr double LENGTH = 25, MOVE = 1e-6;
  static constexpr double ROUNDING = 64 * EPSILON * LENGTH;  // of a sum of some tens of terms as large as X

  static RigSettings settings() {
    RigSettings settings = statics(205e9, 0.3);
    // Enough mass for a block that nothing holds to have a definite system, and too little to matter: inertia adds
    // ρ L²/(E Δt²) = 3e-8 of the move.
    settings.material.density = 10;
    settings.conditions.clamps = {{slab(2, 0), Vec3::Zero()}, {slab(2, LENGTH), Vec3(0, 0, MOVE)}};
    return settings;
  }

  Separation() : bar(block({1, 1, 1}, Vec3(5, 5, LENGTH)), settings()) {}

  // Largest difference of the displacement from `move` along z over the parts between two heights.
  double error(double bottom, double top, double move) const {
    double worst = 0;
    int found = 0;
    const std::vector<Vec3> u = bar.displacements();
    for (std::size_t p = 0; p < bar.mesh.parts().size(); ++p) {
      const Part& part = bar.mesh.parts()[p];
      const Barycentric N = bar.mesh.centroid(static_cast<int>(p));
      double z = 0;
      for (int I = 0; I < 4; ++I) z += N[I] * bar.mesh.mesh().nodes[bar.mesh.mesh().elements[part.element][I]].z();
      if (z < bottom || z > top) continue;
      ++found;
      for (int c : part.copies) worst = std::max(worst, (u[c] - Vec3(0, 0, move)).norm());
    }
    EXPECT_GE(found, 6);
    return worst;
  }

  Rig bar;
};

TEST_F(Separation, BelowTheCutNothingMovesAndAboveAllMovesAlike) {
  bar.cut(plane(Vec3(2.5, 2.5, LENGTH / 2), Vec3::UnitZ()));
  ASSERT_EQ(bar.pieces(), 2);
  for (double volume : pieceVolumes(bar)) EXPECT_NEAR(volume, 312.5, 1e-12 * 312.5);
  ASSERT_TRUE(bar.advance());
  EXPECT_LT(error(0, LENGTH / 2, 0), ROUNDING);
  EXPECT_LT(error(LENGTH / 2, LENGTH, MOVE), ROUNDING);
}

TEST_F(Separation, WithoutACutTheBarStretches) {
  ASSERT_TRUE(bar.advance());
  EXPECT_GT(bar.step.assembly().elasticEnergy(bar.motion.x), 0);
  // Strain 1e-6/25 with the cross-section clamped at both ends: the energy lies between those of the stresses E ε and
  // (λ + 2μ) ε.
  const Material& material = bar.step.assembly().materials().of(0);
  const double strain = MOVE / LENGTH, volume = 625;
  const double energy = bar.step.assembly().elasticEnergy(bar.motion.x);
  EXPECT_GT(energy, 0.5 * material.young_modulus * strain * strain * volume * (1 - 1e-6));
  EXPECT_LT(energy, 0.5 * (material.lambda() + 2 * material.mu()) * strain * strain * volume * (1 + 1e-6));
}

TEST_F(Separation, TwoCutsInTheSameElementsMakeThreeBlocks) {
  bar.cut(plane(Vec3(2.5, 2.5, LENGTH / 3), Vec3::UnitZ()));
  bar.cut(plane(Vec3(2.5, 2.5, 2 * LENGTH / 3), Vec3::UnitZ()));
  ASSERT_EQ(bar.pieces(), 3);
  for (double volume : pieceVolumes(bar)) EXPECT_NEAR(volume, 625.0 / 3, 1e-12 * 625);
  ASSERT_TRUE(bar.advance());
  EXPECT_LT(error(0, LENGTH / 3, 0), ROUNDING);
  EXPECT_LT(error(2 * LENGTH / 3, LENGTH, MOVE), ROUNDING);
  // Nothing pulls the block between.
  const double free_energy = bar.step.assembly().elasticEnergy(bar.motion.x);
  const double stretched = 0.5 * 205e9 * 625 * MOVE * MOVE / (LENGTH * LENGTH);
  EXPECT_LT(free_energy, 1e-9 * stretched);
}

// One tetrahedron with three right angles at the origin.
TetMesh oneElement() { return {{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, {{0, 1, 2, 3}}}; }

struct Crossing {
  const char* name;
  std::vector<PlaneCut> cuts;
  int zones;
};

std::string crossingName(const ::testing::TestParamInfo<Crossing>& test) { return test.param.name; }

class CrossingCuts : public ::testing::TestWithParam<Crossing> {};

TEST_P(CrossingCuts, MakeTheirZonesInOneElement) {
  Rig rig(oneElement(), {});
  for (const PlaneCut& cut : GetParam().cuts) EXPECT_TRUE(rig.cut(cut).changed());
  EXPECT_EQ(static_cast<int>(rig.mesh.parts().size()), GetParam().zones);
  EXPECT_EQ(rig.pieces(), GetParam().zones);
  EXPECT_EQ(rig.mesh.numCopies(), 4 * GetParam().zones);
  double volume = 0;
  for (double v : pieceVolumes(rig)) volume += v;
  EXPECT_NEAR(volume, 1.0 / 6, 1e-12 / 6);
}

TEST_P(CrossingCuts, LeaveSixRigidModesAZone) {
  Rig rig(oneElement(), {});
  for (const PlaneCut& cut : GetParam().cuts) rig.cut(cut);
  const Eigen::MatrixXd K = systemMatrix(rig.step.assembly(), {0, 1}, allCopies(rig.mesh));
  EXPECT_EQ(12 * GetParam().zones - Eigen::FullPivLU<Eigen::MatrixXd>(K).setThreshold(1e-11).rank(),
            6 * GetParam().zones);
}

const PlaneCut ACROSS = plane(Vec3(0.25, 0.25, 0.25), Vec3::UnitX());
// Ends that meet only what lies at x > 0.25: the sections there have their centroids at x > 0.4, the others at x < 0.2.
const Vec3 BESIDE(0.25 + 0.5, 0.25, 0.2);
const PlaneCut STRAIGHT_END = rectangle(BESIDE, Vec3::UnitY(), Vec3::UnitX(), 0.9, 0);
const PlaneCut OBLIQUE_END = rectangle(BESIDE - Vec3(0, 0.1, 0), Vec3(-0.3, 1, 0), Vec3(1, 0.3, 0), 0.9, 0);

INSTANTIATE_TEST_SUITE_P(CutAlgebra, CrossingCuts,
                         ::testing::Values(Crossing{"X", {ACROSS, plane(Vec3::Constant(0.25), Vec3::UnitY())}, 4},
                                           Crossing{"T", {ACROSS, STRAIGHT_END}, 3},
                                           Crossing{"Y", {ACROSS, OBLIQUE_END}, 3}),
                         crossingName);

// A block under tension σ along x at both ends, cut along x. The exact answer is u = (σ/E)(x, −νy, −νz).
class PatchTest : public ::testing::TestWithParam<std::vector<PlaneCut>> {
 protected:
  static constexpr double E = 2e5, POISSON = 0.3, TENSION = 0.01 * E;
  static constexpr double TOLERANCE = 1e-10;

  static Vec3 exact(const Vec3& X) { return TENSION / E * Vec3(X.x(), -POISSON * X.y(), -POISSON * X.z()); }

  static RigSettings settings(bool warping, double time_step) {
    RigSettings settings;
    settings.material = {E, POISSON, 1000, 0, 0};
    settings.warping = warping;
    settings.solver.time_step = time_step;
    settings.conditions.loads = {{slab(0, 0), Vec3(-TENSION, 0, 0), 0}, {slab(0, 1), Vec3(TENSION, 0, 0), 0}};
    return settings;
  }

  struct Block : Rig {
    Block(bool warping, double dt) : Rig(block({4, 3, 3}, Vec3(1, 0.75, 0.6)), settings(warping, dt)) {
      for (const PlaneCut& plane : GetParam()) EXPECT_TRUE(cut(plane).changed());
    }
  };

  static std::vector<Vec3> exactDisplacements(const CutMesh& mesh) {
    std::vector<Vec3> u = restPositions(mesh);
    for (Vec3& X : u) X = exact(X);
    return u;
  }

  // Largest |u − exact| after each piece has been moved back rigidly, as best it may.
  static double errorOfShape(const Rig& rig) {
    int pieces = 0;
    const std::vector<int> piece = rig.mesh.copyPieces(&pieces);
    const std::vector<Vec3> X = restPositions(rig.mesh), u = rig.displacements(), answer = exactDisplacements(rig.mesh);
    double worst = 0;
    for (int s = 0; s < pieces; ++s) {
      const auto size = std::count(piece.begin(), piece.end(), s);
      Eigen::MatrixXd rigid = Eigen::MatrixXd::Zero(3 * size, 6);
      Eigen::VectorXd error(3 * size);
      Eigen::Index row = 0;
      for (int c = 0; c < rig.mesh.numCopies(); ++c) {
        if (piece[c] != s) continue;
        rigid.block<3, 3>(row, 0).setIdentity();
        for (int axis = 0; axis < 3; ++axis) rigid.block<3, 1>(row, 3 + axis) = Vec3::Unit(axis).cross(X[c]);
        error.segment<3>(row) = u[c] - answer[c];
        row += 3;
      }
      worst = std::max(worst, (error - rigid * rigid.colPivHouseholderQr().solve(error)).cwiseAbs().maxCoeff());
    }
    return worst;
  }
};

TEST_P(PatchTest, ExactAnswerIsInEquilibrium) {
  // Steps below the period in which tension turns the block back: what turns a warped part is explicit in time.
  for (const bool warping : {false, true}) {
    Block rig(warping, 0.01);
    const std::vector<Vec3> u = exactDisplacements(rig.mesh);
    for (std::size_t c = 0; c < u.size(); ++c) rig.motion.x[c] += u[c];
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(rig.advance());
    EXPECT_LT(largestDifference(rig.displacements(), u), TOLERANCE * largest(u));
    const Mat3 tension = Vec3(TENSION, 0, 0).asDiagonal();
    for (std::size_t p = 0; p < rig.mesh.parts().size(); ++p)
      EXPECT_LT((rig.step.assembly().stress(static_cast<int>(p), rig.motion.x) - tension).norm(), TOLERANCE * E);
  }
}

TEST_P(PatchTest, ExactAnswerIsFoundFromRest) {
  Block rig(false, 1);
  // The slowest mode, of some 40 rad/s, loses a factor of 40 a step of a second.
  for (int i = 0; i < 12; ++i) ASSERT_TRUE(rig.advance());
  EXPECT_LT(errorOfShape(rig), TOLERANCE * largest(exactDisplacements(rig.mesh)));
}

const PlaneCut ALONG = plane(Vec3(0.5, 0.4, 0.3), Vec3(0, 0.6, 0.8));
std::string patchName(const ::testing::TestParamInfo<std::vector<PlaneCut>>& test) {
  constexpr const char* NAMES[] = {"Uncut", "Severed", "Slit", "Crossed"};
  return NAMES[test.index];
}

INSTANTIATE_TEST_SUITE_P(
    CutAlgebra, PatchTest,
    ::testing::Values(std::vector<PlaneCut>{}, std::vector<PlaneCut>{ALONG},
                      std::vector<PlaneCut>{rectangle(ALONG.point, ALONG.normal, Vec3::UnitX(), 0.5, 0.6)},
                      std::vector<PlaneCut>{ALONG, plane(Vec3(0.5, 0.37, 0.31), Vec3(0, -0.8, 0.6))}),
    patchName);

// How many eigenvalues of K, scaled to a unit diagonal so that small fragments weigh as much as large ones, are zero.
int rigidModes(const Rig& rig) {
  Eigen::MatrixXd K = systemMatrix(rig.step.assembly(), {0, 1}, allCopies(rig.mesh));
  const Eigen::VectorXd unit = K.diagonal().cwiseSqrt().cwiseInverse();
  K = unit.asDiagonal() * K * unit.asDiagonal();
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K, Eigen::EigenvaluesOnly).eigenvalues();
  return static_cast<int>((values.array() < 1e-9).count());
}

TEST(RigidModes, AreSixAPiece) {
  Rig rig(block({3, 2, 2}, Vec3(1, 0.7, 0.8)), {});
  EXPECT_EQ(rigidModes(rig), 6);
  rig.cut(plane(Vec3(0.45, 0.3, 0.4), Vec3(1, 0.2, 0.1)));
  ASSERT_EQ(rig.pieces(), 2);
  EXPECT_EQ(rigidModes(rig), 12);
  rig.cut(plane(Vec3(0.45, 0.3, 0.4), Vec3(0.1, 1, 0.2)));
  ASSERT_EQ(rig.pieces(), 4);
  EXPECT_EQ(rigidModes(rig), 24);
}

TEST(RigidModes, AreSixForAFragmentWithinOneElement) {
  Rig rig(block({2, 1, 1}, Vec3(1, 0.5, 0.5)), {});
  // A corner of share (0.02)³ of its element.
  rig.cut(plane(Vec3(0.01, 0, 0), Vec3(1, 1, 1)));
  ASSERT_EQ(rig.pieces(), 2);
  EXPECT_EQ(rigidModes(rig), 12);
}

TEST(RigidModes, AreSixForASlitBody) {
  Rig rig(block({3, 2, 2}, Vec3(1, 0.7, 0.8)), {});
  ASSERT_TRUE(rig.cut(rectangle(Vec3(0, 0.4, 0.35), Vec3(0.1, 1, 0.2), Vec3::UnitX(), 1, 0)).changed());
  ASSERT_EQ(rig.pieces(), 1);
  EXPECT_EQ(rigidModes(rig), 6);
}

// Loads the end at x = 1 of a block cut once, and compares the largest velocity after a step on either side.
double movedAlong(const PlaneCut& cut) {
  RigSettings settings;
  settings.conditions.loads = {{slab(0, 1), Vec3(1e5, 2e4, -3e4), 0}};
  Rig rig(block({4, 2, 2}, Vec3(1, 0.5, 0.5)), settings);
  rig.cut(cut);
  EXPECT_EQ(rig.pieces(), 2);
  EXPECT_TRUE(rig.advance());
  int count = 0;
  const std::vector<int> piece = rig.mesh.copyPieces(&count);
  int loaded = 0;
  for (int c = 0; c < rig.mesh.numCopies(); ++c)
    if (rig.motion.v[c].norm() > rig.motion.v[loaded].norm()) loaded = c;
  double other = 0;
  for (int c = 0; c < rig.mesh.numCopies(); ++c)
    if (piece[c] != piece[loaded]) other = std::max(other, rig.motion.v[c].norm());
  return other / rig.motion.v[loaded].norm();
}

TEST(MovementIndependence, OfTwoHalvesInTheSameElements) {
  EXPECT_LT(movedAlong(plane(Vec3(0.55, 0.2, 0.2), Vec3(1, 0.1, 0.2))), 1e-12);
}

TEST(MovementIndependence, OfAFragmentWithoutANode) {
  // A corner of share (0.02)³ of its element, away from the load.
  EXPECT_LT(movedAlong(plane(Vec3(0.005, 0, 0), Vec3(1, 1, 1))), 1e-12);
}

}  // namespace
}  // namespace incision

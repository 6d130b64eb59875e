#include "incision/fem/tension.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "support/rig.h"

namespace incision {
namespace {

constexpr double TIME_STEP = 0.1, LONG_STEP = 2;

/// A cut block that is held at one end, deformed by this matrix and at random by so much of an element besides, and the
/// tension in it.
struct Pulled {
  Rig rig;
  Tension tension;

  explicit Pulled(const Mat3& F, double jitter = 0, Pressure pressure = Pressure::ELEMENT)
      : rig(block({4, 3, 3}, Vec3(1, 0.75, 0.75)), settings(pressure)), tension(rig.step.assembly()) {
    rig.cut(rectangle(Vec3(0.41, 0.3, 0.3), Vec3(1, 0.3, 0.2), Vec3::UnitZ(), 0.6, 0));
    const std::vector<Vec3> moved = randomVectors(rig.motion.x.size(), 0.25 * jitter, 3);
    for (std::size_t c = 0; c < moved.size(); ++c) rig.motion.x[c] = F * (rig.motion.x[c] + moved[c]);
    rig.step.begin(TIME_STEP, rig.motion);  // finds the rotations
    tension.topologyChanged(rig.step.pieceOf(), rig.step.pieces(), rig.step.held());
    tension.find(TensionScheme::IMPLICIT, TIME_STEP, rig.motion.x);
  }

  static RigSettings settings(Pressure pressure) {
    RigSettings settings;
    settings.pressure = pressure;
    settings.material = {1e5, 0.3, 1000, 0, 0};
    settings.conditions.clamps = {{slab(0, 0), Vec3::Zero()}};
    return settings;
  }

  /// Δt² V b_I · S⁺ b_J by principal axes, in the frame of the stress as it is.
  double expected(int part, int I, int J) const {
    const Assembly& assembly = rig.step.assembly();
    const Eigen::SelfAdjointEigenSolver<Mat3> axes(assembly.stress(part, rig.motion.x));
    const Mat3 positive =
        axes.eigenvectors() * axes.eigenvalues().cwiseMax(0).asDiagonal() * axes.eigenvectors().transpose();
    const Gradients g = assembly.rotatedGradients(part);
    return TIME_STEP * TIME_STEP * assembly.volume(part) * g.col(I).dot(positive * g.col(J));
  }

  /// That of the whole stress, which sets the scale.
  double scale(int part) const {
    const Assembly& assembly = rig.step.assembly();
    return TIME_STEP * TIME_STEP * assembly.volume(part) * assembly.stress(part, rig.motion.x).norm() *
           assembly.rotatedGradients(part).squaredNorm();
  }
};

const Mat3 TURN = Eigen::AngleAxisd(2, Vec3(1, 2, -1).normalized()).toRotationMatrix();

TEST(Tension, IsThePositivePartOfTheStress) {
  for (const Pressure pressure : {Pressure::ELEMENT, Pressure::AVERAGED})
    for (const double jitter : {1e-6, 1e-2, 0.1, 0.5}) {
      const Pulled body(TURN, jitter, pressure);
      ASSERT_TRUE(body.tension.acts());
      for (int p = 0; p < static_cast<int>(body.rig.mesh.parts().size()); ++p)
        for (int I = 0; I < 4; ++I)
          for (int J = 0; J < 4; ++J)
            EXPECT_NEAR(body.tension.products(p).of(I, J), body.expected(p, I, J), 1e-7 * body.scale(p));
    }
}

// Two principal stresses are equal here, or zero.
TEST(Tension, IsSoInPlainStates) {
  const auto stretched = [](double x, double y, double z) -> Mat3 {
    return TURN * Vec3(1 + x, 1 + y, 1 + z).asDiagonal();
  };
  for (const Mat3& F : {stretched(0.1, -0.03, -0.03), stretched(0.1, 0.1, -0.05), stretched(0.1, 0.1, 0.1),
                        stretched(0.1, 0, -0.1), stretched(0.1, 0.05, 0), stretched(-0.1, -0.2, -0.1)}) {
    const Pulled body(F);
    for (int p = 0; p < static_cast<int>(body.rig.mesh.parts().size()); ++p)
      for (int I = 0; I < 4; ++I)
        for (int J = 0; J < 4; ++J)
          EXPECT_NEAR(body.tension.products(p).of(I, J), body.expected(p, I, J), 1e-7 * body.scale(p));
  }
}

TEST(Tension, IsTheSameInTheMatrixAndInTheForces) {
  const Pulled body(TURN, 0.2);
  const std::vector<int> copies = allCopies(body.rig.mesh);
  const SystemFactors without{1, 0.01};
  const Eigen::SparseMatrix<double> added =
      systemMatrix(body.rig.step.assembly(), {without.mass, without.stiffness, &body.tension}, copies) -
      systemMatrix(body.rig.step.assembly(), without, copies);
  const std::vector<Vec3> w = randomVectors(copies.size(), 1, 5);
  std::vector<Vec3> impulses;
  body.tension.multiply(w, &impulses);
  Eigen::VectorXd all(3 * w.size());
  for (std::size_t c = 0; c < w.size(); ++c) all.segment<3>(3 * static_cast<int>(c)) = w[c];
  const Eigen::VectorXd product = added * all;
  for (std::size_t c = 0; c < w.size(); ++c)
    EXPECT_LT((product.segment<3>(3 * static_cast<int>(c)) - impulses[c]).norm(),
              1e-9 * product.lpNorm<Eigen::Infinity>());
  EXPECT_GT(all.dot(product), 0);
}

// A string under the pull F pushes back what leaves its line by F times the angles.
TEST(Tension, ResistsTurningAsAStringDoes) {
  const Pulled body(Vec3(1.1, 1, 1).asDiagonal());
  const CutMesh& mesh = body.rig.mesh;
  std::vector<Vec3> turned(body.rig.motion.x.size()), impulses;
  for (std::size_t c = 0; c < turned.size(); ++c) turned[c] = Vec3(0, 0, body.rig.motion.x[c].x());
  body.tension.multiply(turned, &impulses);
  double pull = 0;
  for (int p = 0; p < static_cast<int>(mesh.parts().size()); ++p) {
    const Mat3 stress = body.rig.step.assembly().stress(p, body.rig.motion.x);
    pull += body.rig.step.assembly().volume(p) * stress(0, 0) / 1.0;  // by the length at rest
  }
  double at_end = 0;
  for (std::size_t c = 0; c < turned.size(); ++c)
    if (std::abs(mesh.mesh().nodes[mesh.copyNode(static_cast<int>(c))].x() - 1) < 1e-9) at_end += impulses[c].z();
  EXPECT_NEAR(at_end, TIME_STEP * TIME_STEP * pull * 1.1, 1e-9 * pull);
}

TEST(Tension, ActsOnlyInHeldPiecesThatAreWarpedAndWhereItIsAskedFor) {
  RigSettings settings = Pulled::settings(Pressure::ELEMENT);
  for (const bool held : {true, false})
    for (const bool warping : {true, false}) {
      settings.conditions.clamps.resize(held ? 1 : 0);
      settings.warping = warping;
      Rig rig(block({4, 3, 3}, Vec3(1, 0.75, 0.75)), settings);
      for (Vec3& x : rig.motion.x) x.x() *= 1.1;
      rig.step.begin(TIME_STEP, rig.motion);
      Tension tension(rig.step.assembly());
      tension.topologyChanged(rig.step.pieceOf(), rig.step.pieces(), rig.step.held());
      for (const TensionScheme scheme : {TensionScheme::EXPLICIT, TensionScheme::IMPLICIT, TensionScheme::AUTO}) {
        tension.find(scheme, LONG_STEP, rig.motion.x);
        EXPECT_EQ(tension.acts(), held && warping && scheme != TensionScheme::EXPLICIT);
      }
    }
}

// Δt σ above h √(E ρ) / 2, in a bar that is pulled along.
TEST(Tension, ActsByItselfJustWhereThePullDoesMoreInAStepThanTheStiffness) {
  for (const double share : {0.3, 0.45, 0.55, 1.9}) {
    const double stress = share * 0.75 * std::sqrt(1e5 * 1000) / LONG_STEP;
    const double e = stress / 1e5;  // the stretch along the bar, and 0.3 of it across
    Pulled body(Vec3(1 + e, 1 - 0.3 * e, 1 - 0.3 * e).asDiagonal());
    body.tension.find(TensionScheme::AUTO, LONG_STEP, body.rig.motion.x);
    EXPECT_EQ(body.tension.acts(), share > 0.5) << share;
    body.tension.find(TensionScheme::AUTO, LONG_STEP / 4, body.rig.motion.x);
    EXPECT_FALSE(body.tension.acts());
  }
}

TEST(Tension, ActsByItselfAtAnyTimeStepInWhatIsStretchedToTwiceItsLength) {
  for (const double stretch : {1.8, 2.2}) {
    Pulled body(Vec3(stretch, 1.3 - 0.3 * stretch, 1.3 - 0.3 * stretch).asDiagonal());
    body.tension.find(TensionScheme::AUTO, 1e-6, body.rig.motion.x);
    EXPECT_EQ(body.tension.acts(), stretch > 2) << stretch;
  }
}

}  // namespace
}  // namespace incision

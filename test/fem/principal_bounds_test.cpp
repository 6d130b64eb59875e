#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

#include "support/rig.h"

namespace incision {
namespace {

/// A cut block, deformed by this matrix and at random by so much of an element besides.
struct Deformed {
  Rig rig;
  std::vector<Mat3> stress;
  std::vector<PrincipalBounds> bounds;

  Deformed(Pressure pressure, bool warping, double poisson_ratio, const Mat3& F, double jitter)
      : rig(block({4, 3, 3}, Vec3(1, 0.75, 0.75)), settings(pressure, warping, poisson_ratio)) {
    rig.cut(plane(Vec3(0.41, 0.3, 0.3), Vec3(1, 0.3, 0.2)));
    const std::vector<Vec3> moved = randomVectors(rig.motion.x.size(), 0.25 * jitter, 3);
    for (std::size_t c = 0; c < moved.size(); ++c) rig.motion.x[c] = F * (rig.motion.x[c] + moved[c]);
    rig.step.assembly().stresses(rig.motion.x, &stress);
    rig.step.assembly().principalBounds(rig.motion.x, &bounds);
  }

  static RigSettings settings(Pressure pressure, bool warping, double poisson_ratio) {
    RigSettings settings;
    settings.pressure = pressure;
    settings.warping = warping;
    settings.material.poisson_ratio = poisson_ratio;
    return settings;
  }

  Vec3 principal(std::size_t p) const { return Eigen::SelfAdjointEigenSolver<Mat3>(stress[p]).eigenvalues(); }
};

TEST(PrincipalBounds, HoldThePrincipalStresses) {
  const Mat3 turn = Eigen::AngleAxisd(2, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  for (const Pressure pressure : {Pressure::ELEMENT, Pressure::AVERAGED})
    for (const bool warping : {true, false})
      for (const double poisson_ratio : {-0.4, 0.0, 0.3, 0.49})
        for (const double jitter : {0.0, 1e-8, 1e-3, 0.03, 0.1, 0.3, 1.0}) {
          const Deformed body(pressure, warping, poisson_ratio, warping ? turn : Mat3::Identity(), jitter);
          for (std::size_t p = 0; p < body.stress.size(); ++p) {
            EXPECT_LE(body.bounds[p][0], body.principal(p)[0]);
            EXPECT_GE(body.bounds[p][1], body.principal(p)[2]);
          }
        }
}

TEST(PrincipalBounds, AreCloseWhereTheStrainIsSmall) {
  Mat3 F = Mat3::Identity();
  F(0, 0) += 0.01;
  const Deformed body(Pressure::ELEMENT, true, 0.3, F, 0);
  for (std::size_t p = 0; p < body.stress.size(); ++p) {
    EXPECT_LT(body.bounds[p][1], 1.02 * body.principal(p)[2]);
    EXPECT_GT(body.bounds[p][0], body.principal(p)[0] - 0.5 * body.principal(p)[2]);
  }
}

TEST(PrincipalBounds, ExcludeNothingWherePartsAreInvertedFarStretchedOrNoNumber) {
  Mat3 mirror = Mat3::Identity(), stretch = Mat3::Identity(), none = Mat3::Identity();
  mirror(1, 1) = -1;
  stretch(2, 2) = 2;
  none(0, 0) = std::nan("");
  for (const Mat3& F : {mirror, stretch, none}) {
    Rig rig(block({2, 2, 2}, Vec3::Ones()), RigSettings());
    for (Vec3& x : rig.motion.x) x = F * x;
    std::vector<PrincipalBounds> bounds;
    rig.step.assembly().principalBounds(rig.motion.x, &bounds);
    for (const PrincipalBounds& of : bounds) {
      EXPECT_FALSE(of[1] < 1e300);
      EXPECT_FALSE(of[0] > -1e300);
    }
  }
}

}  // namespace
}  // namespace incision

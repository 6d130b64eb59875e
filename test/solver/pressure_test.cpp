// Bodies under a pressure that follows their faces, against formulas.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "support/rig.h"

namespace incision {
namespace {

Load pressing(const RestBox& box, double pressure) {
  Load load;
  load.place = box;
  load.pressure = pressure;
  return load;
}

/// The stress E/(1 − 2ν) (1 − λ) of a body that shrinks to λ balances the pressure on its shrunken faces, p λ².
TEST(Pressure, ShrinksABlockUntilItsStressBalancesItOnTheFacesAsTheyAre) {
  constexpr double E = 1e5, NU = 0.3, P = 2e4;
  RigSettings settings = statics(E, NU);
  settings.material.density = 1;
  settings.warping = true;
  settings.conditions.loads = {pressing({Vec3::Constant(-10), Vec3::Constant(10)}, P)};
  Rig rig(block({3, 2, 2}, Vec3(0.9, 0.6, 0.4)), settings);
  for (int k = 0; k < 60; ++k) ASSERT_TRUE(rig.advance());
  const double stiffness = E / (1 - 2 * NU);
  const double shrunk = (std::sqrt(stiffness * stiffness + 4 * P * stiffness) - stiffness) / (2 * P);
  ASSERT_LT(shrunk, 0.95);
  const std::vector<Vec3> X = restPositions(rig.mesh);
  for (std::size_t c = 0; c < X.size(); ++c)
    for (std::size_t d = 0; d < c; ++d)
      EXPECT_NEAR((rig.motion.x[c] - rig.motion.x[d]).norm(), shrunk * (X[c] - X[d]).norm(), 1e-10) << c << " " << d;
}

/// A ball of radius 1 with a hollow of half its size: a cube of cells whose shells are drawn onto spheres.
TetMesh hollowBall(int cells) {
  const TetMesh cube = block({cells, cells, cells}, Vec3::Constant(2), Vec3::Constant(-1));
  TetMesh ball;
  std::vector<int> number(cube.nodes.size(), -1);
  for (const auto& element : cube.elements) {
    Vec3 centroid = Vec3::Zero();
    for (int n : element) centroid += cube.nodes[n] / 4;
    if (centroid.cwiseAbs().maxCoeff() < 0.5) continue;
    ball.elements.push_back(element);
    for (int& n : ball.elements.back()) {
      if (number[n] < 0) {
        number[n] = static_cast<int>(ball.nodes.size());
        const Vec3& at = cube.nodes[n];
        ball.nodes.push_back(at.cwiseAbs().maxCoeff() / at.norm() * at);
      }
      n = number[n];
    }
  }
  return ball;
}

/// How far the hollow of the ball grows under a pressure in it [m].
double growth(int cells, double young_modulus, double poisson_ratio, double pressure) {
  RigSettings settings = statics(young_modulus, poisson_ratio);
  settings.material.density = 1;
  settings.conditions.loads = {pressing({Vec3::Constant(-0.51), Vec3::Constant(0.51)}, pressure)};
  Rig rig(hollowBall(cells), settings);
  for (int k = 0; k < 4; ++k) EXPECT_TRUE(rig.advance());
  const std::vector<Vec3> X = restPositions(rig.mesh), u = rig.displacements();
  double sum = 0;
  int count = 0;
  for (std::size_t c = 0; c < X.size(); ++c) {
    if (X[c].norm() > 0.51) continue;
    sum += u[c].dot(X[c].normalized());
    ++count;
  }
  return sum / count;
}

/// Lamé: u(a) = p a³/(E (b³ − a³)) ((1 − 2ν) a + (1 + ν) b³/(2 a²)). Errors go with the square of the elements' size
/// and with its fourth power.
TEST(Pressure, InflatesAThickSphereAsLameHasIt) {
  constexpr double E = 1e6, NU = 0.3, P = 1, A = 0.5, B = 1;
  const double exact =
      P * A * A * A / (E * (B * B * B - A * A * A)) * ((1 - 2 * NU) * A + (1 + NU) * B * B * B / (2 * A * A));
  const std::array<int, 3> cells = {12, 16, 20};
  std::array<double, 3> square, share;
  for (int i = 0; i < 3; ++i) {
    square[i] = 1.0 / (cells[i] * cells[i]);
    share[i] = growth(cells[i], E, NU, P) / exact;
  }
  double extrapolated = 0;
  for (int i = 0; i < 3; ++i) {
    const double j = square[(i + 1) % 3], k = square[(i + 2) % 3];
    extrapolated += share[i] * j * k / ((j - square[i]) * (k - square[i]));
  }
  EXPECT_LT(share[0], share[1]);
  EXPECT_LT(share[1], share[2]);
  EXPECT_NEAR(share[2], 1, 0.06);
  EXPECT_NEAR(extrapolated, 1, 0.01);
}

/// What turns freely has its pressure turned along, from the step's start to its end. The face is a square.
TEST(Pressure, TurnsWithAFreePiece) {
  constexpr double P = 100;
  RigSettings settings;
  settings.material = {1e7, 0.3, 1000, 0, 0};
  settings.conditions.loads = {pressing(slab(0, 1), P)};
  Rig rig(block({2, 2, 2}, Vec3::Ones()), settings);
  const auto at = [&](const Vec3& X) {
    for (std::size_t n = 0; n < rig.mesh.mesh().nodes.size(); ++n)
      if ((rig.mesh.mesh().nodes[n] - X).norm() < 1e-9) return rig.motion.x[n];
    return Vec3(Vec3::Zero());
  };
  for (std::size_t c = 0; c < rig.motion.x.size(); ++c)
    rig.motion.v[c] = Vec3(0, 0, 2).cross(rig.motion.x[c] - Vec3::Constant(0.5));
  Vec3 normal = Vec3::UnitX();
  for (int k = 1; k <= 100; ++k) {
    const Vec3 before = rig.momentum();
    ASSERT_TRUE(rig.advance());
    normal = (at(Vec3(1, 1, 0)) - at(Vec3(1, 0, 0))).cross(at(Vec3(1, 0, 1)) - at(Vec3(1, 0, 0)));
    EXPECT_LT((rig.momentum() - before + P * rig.time_step * normal).norm(), 1e-4 * P * rig.time_step) << k;
  }
  EXPECT_LT(normal.x(), -0.3);  // it has turned by some 2 rad
}

}  // namespace
}  // namespace incision

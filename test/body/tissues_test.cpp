// Bodies of two tissues against formulas.
#include <gtest/gtest.h>

#include <cmath>

#include "support/breaking.h"
#include "support/rig.h"

namespace incision::test {
namespace {

RegionSettings tissue(const Place& place, double young_modulus, double poisson_ratio) {
  RegionSettings region;
  region.place = place;
  region.young_modulus = young_modulus;
  region.poisson_ratio = poisson_ratio;
  return region;
}

// Two springs in series. Displacements are linear in each half, so that linear elements have them exactly, also where a
// cut goes along the bar.
TEST(Tissues, ABarOfTwoGivesWayAsTwoSpringsInSeries) {
  constexpr double SOFT = 1e4, STIFF = 1e8, PULL = 100, LENGTH = 1;
  for (const bool is_cut : {false, true}) {
    RigSettings settings = statics(SOFT, 0);
    settings.regions = {tissue({Vec3(0.5, -1, -1), Vec3(2, 2, 2)}, STIFF, 0)};
    settings.conditions.clamps = {{slab(0, 0), Vec3::Zero()}};
    settings.conditions.loads = {{slab(0, LENGTH), Vec3(PULL, 0, 0), 0}};
    Rig rig(block({8, 2, 2}, Vec3(LENGTH, 0.25, 0.25)), settings);
    if (is_cut) {
      ASSERT_TRUE(rig.cut(rectangle(Vec3(LENGTH, 0.1, 0.1), Vec3::UnitY(), Vec3::UnitX(), 1.3, 0)).changed());
    }
    ASSERT_TRUE(rig.advance());
    const std::vector<Vec3> u = rig.displacements(), X = restPositions(rig.mesh);
    const double end = PULL * LENGTH / 2 * (1 / SOFT + 1 / STIFF);
    for (std::size_t c = 0; c < u.size(); ++c) {
      const double x = X[c].x();
      const double exact = PULL * (std::min(x, LENGTH / 2) / SOFT + std::max(0.0, x - LENGTH / 2) / STIFF);
      EXPECT_LT((u[c] - Vec3(exact, 0, 0)).norm(), 1e-8 * end);
    }
  }
}

/// A stiff ball of radius a = ½ in a matrix that is stretched alike in all directions by FAR, far away:
///   u = (FAR + b) X in it, u = (FAR + b a³/r³) X outside,  b = 3 (K − K_i) FAR / (3 K_i + 4 μ),
/// K_i being the ball's bulk modulus, K and μ the matrix's. Here is the cube [0, 1]³, an eighth of it, whose boundary
/// goes as it does there. The ball's surface lies on faces of elements.
class Ball {
 public:
  /// `cells` is even.
  explicit Ball(int cells) {
    mesh_ = block({cells, cells, cells}, Vec3::Ones());
    PhysicalGroup ball;
    ball.name = "ball";
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
      Vec3 centroid = Vec3::Zero();
      for (int n : mesh_.elements[e]) centroid += mesh_.nodes[n] / 4;
      if (centroid.maxCoeff() < RADIUS) ball.elements.push_back(static_cast<int>(e));
    }
    mesh_.groups = {ball};
    for (Vec3& X : mesh_.nodes) X = rounded(X);
  }

  /// The root of the mean square error at the nodes inside, over that of the displacement.
  double error() const {
    RigSettings settings = statics(MATRIX.young_modulus, MATRIX.poisson_ratio);
    Place place;
    place.group = "ball";
    settings.regions = {tissue(place, BALL.young_modulus, BALL.poisson_ratio)};
    settings.conditions.clamps = clampEach(
        mesh_, [](const Vec3& X) { return X.minCoeff() < 1e-9 || X.maxCoeff() > 1 - 1e-9; }, mesh_, exact);
    Rig rig(mesh_, settings);
    EXPECT_TRUE(rig.advance());
    double off = 0, all = 0;
    for (int c : rig.freeCopies()) {
      const Vec3& X = rig.mesh.mesh().nodes[rig.mesh.copyNode(c)];
      off += (rig.motion.x[c] - X - exact(X)).squaredNorm();
      all += exact(X).squaredNorm();
    }
    return std::sqrt(off / all);
  }

 private:
  static constexpr double RADIUS = 0.5, FAR = 0.01;
  static constexpr Material MATRIX = {1e4, 0.3, 1, 0, 0}, BALL = {1e6, 0.2, 1, 0, 0};

  static double bulk(const Material& m) { return m.young_modulus / (3 * (1 - 2 * m.poisson_ratio)); }
  static Vec3 exact(const Vec3& X) {
    const double b = 3 * (bulk(MATRIX) - bulk(BALL)) * FAR / (3 * bulk(BALL) + 4 * MATRIX.mu());
    return (FAR + b * std::min(1.0, std::pow(RADIUS / X.norm(), 3))) * X;
  }
  /// Makes a sphere of the cube with this half edge, and leaves the centre and the unit cube as they are.
  static Vec3 rounded(const Vec3& X) {
    const double t = X.maxCoeff();
    if (t == 0) return X;
    const double share = 1 - std::pow(2 * t - 1, 2);
    return (1 + share * (t / X.norm() - 1)) * X;
  }

  TetMesh mesh_;
};

TEST(Tissues, AStiffBallInAMatrixConvergesAtSecondOrder) {
  const double coarse = Ball(4).error(), fine = Ball(8).error();
  RecordProperty("error", std::to_string(fine));
  EXPECT_LT(fine, 0.02);
  EXPECT_GT(std::log2(coarse / fine), 1.7);
}

}  // namespace
}  // namespace incision::test

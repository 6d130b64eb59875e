#include "incision/fracture/cohesion.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "support/rig.h"

namespace incision::test {
namespace {

constexpr double STRENGTH = 1e4, ENERGY = 20, YOUNG = 1e6;  // [Pa], [J/m²], [Pa]
constexpr double LAST = 2 * ENERGY / STRENGTH;              // δ_c [m]
constexpr double AREA = 0.25 * 0.25;                        // [m²]
constexpr double TIME_STEP = 0.01;

FractureSettings cohesive() {
  FractureSettings settings;
  settings.tensile_strength = STRENGTH;
  settings.fracture_energy = ENERGY;
  return settings;
}

/// A bar that a crack has gone through, whose halves a test moves apart.
class BrokenBar : public Rig {
 public:
  explicit BrokenBar(const std::vector<RegionSettings>& regions = {})
      : Rig(block({4, 2, 2}, Vec3(1, 0.25, 0.25)), settings(regions)), cohesion(cohesive(), materials) {
    cohesion.add(cut(plane(Vec3(0.47, 0, 0), Vec3::UnitX())), mesh, motion.x);
    cohesion.changed(mesh);
    int count = 0;
    piece = mesh.copyPieces(&count);
  }

  /// The positive half goes by so much in a step; returns the force on it [N].
  Vec3 move(const Vec3& by) {
    std::vector<Vec3> ways(motion.x.size(), Vec3::Zero());
    for (std::size_t c = 0; c < ways.size(); ++c)
      if (onPositiveSide(static_cast<int>(c))) ways[c] = by;
    const bool bonded = begin();
    std::vector<Vec3> forces(ways.size(), Vec3::Zero());
    const std::vector<Vec3> moved = update(ways);
    for (std::size_t i = 0; i < springs.size(); ++i) addShares(springs[i], springs[i].at(moved[i]), &forces);
    Vec3 force = Vec3::Zero(), all = Vec3::Zero();
    for (std::size_t c = 0; c < ways.size(); ++c) {
      motion.x[c] += ways[c];
      all += forces[c];
      if (onPositiveSide(static_cast<int>(c))) force += forces[c];
    }
    EXPECT_LT(all.norm(), 1e-10);  // action and reaction
    if (bonded) cohesion.accept({TIME_STEP}, spanOf(moved), motion, Wrench());
    return force;
  }

  /// Begins a step; returns whether any bond may act in it.
  bool begin() {
    springs.clear();
    const std::vector<Vec3> none(motion.x.size(), Vec3::Zero());
    const std::vector<double> ones(motion.x.size(), 1);
    return cohesion.begin({{TIME_STEP}, mesh, piece, motion, none, ones, ones}, &springs);
  }

  /// Gives the springs their forces where the copies go by `ways` [m]; returns how far their points go.
  std::vector<Vec3> update(const std::vector<Vec3>& ways) {
    std::vector<Vec3> moved;
    for (const Spring& spring : springs) moved.push_back(weightedSum(spring, ways));
    if (springs.empty()) return moved;
    const std::vector<double> all(moved.size(), 1);
    cohesion.takeBounds(spanOf(moved), {all.data(), all.data() + all.size()});
    cohesion.update(spanOf(moved), {springs.data(), springs.data() + springs.size()});
    return moved;
  }

  static Span<const Vec3> spanOf(const std::vector<Vec3>& values) {
    return {values.data(), values.data() + values.size()};
  }

  std::vector<Spring> springs;

  Cohesion cohesion;

 private:
  static RigSettings settings(const std::vector<RegionSettings>& regions) {
    RigSettings settings;
    settings.regions = regions;
    settings.material.young_modulus = YOUNG;
    return settings;
  }
  bool onPositiveSide(int copy) const { return piece[copy] != piece[mesh.ownCopy(0)]; }
  std::vector<int> piece;
};

TEST(Cohesion, EachRegionTakesItsOwnEnergy) {
  RegionSettings tough;
  tough.place = {Vec3(-1, 0.125, -1), Vec3(2, 1, 1)};
  tough.fracture_energy = 3 * ENERGY;
  BrokenBar bar({tough});
  for (int k = 0; k < 40; ++k) bar.move(Vec3(LAST / 10, 0, 0));
  EXPECT_NEAR(bar.cohesion.dissipated(), 2 * ENERGY * AREA, 1e-9 * ENERGY * AREA);
}

TEST(Cohesion, TheTractionFallsFromTheStrengthToNothing) {
  BrokenBar bar;
  const double step = LAST / 50;
  double highest = 0;
  for (double opening = step; opening < 1.01 * LAST; opening += step) {
    const double pull = -bar.move(Vec3(step, 0, 0))[0] / (STRENGTH * AREA);
    highest = std::max(highest, pull);
    EXPECT_NEAR(pull, std::max(0.0, 1 - opening / LAST), 0.03) << opening;  // the rise, the tolerance of the slope
  }
  EXPECT_GT(highest, 0.9);
  EXPECT_LE(highest, 1 + 1e-12);
  EXPECT_EQ(bar.move(Vec3(LAST, 0, 0)).norm(), 0);
  EXPECT_FALSE(bar.begin());
}

TEST(Cohesion, OpeningTakesTheFractureEnergyWhateverTheDirection) {
  for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.6, 0, 0.8)}) {
    BrokenBar bar;
    double work = 0, last = 0;
    const int steps = 400;
    for (int k = 0; k < steps; ++k) {
      const double force = -bar.move(1.05 * LAST / steps * direction).dot(direction);
      work += (force + last) / 2 * 1.05 * LAST / steps;
      last = force;
    }
    EXPECT_NEAR(work, ENERGY * AREA, 0.02 * ENERGY * AREA);  // the slope's tolerance
    EXPECT_NEAR(bar.cohesion.dissipated(), ENERGY * AREA, 1e-12 * ENERGY * AREA);
  }
}

TEST(Cohesion, ClosingGoesStraightBackToZeroAndTakesNothing) {
  BrokenBar bar;
  for (int k = 0; k < 10; ++k) bar.move(Vec3(0.05 * LAST, 0, 0));
  const double spent = bar.cohesion.dissipated(), full = -bar.move(Vec3(0, 0, 0))[0];
  EXPECT_NEAR(full, STRENGTH * AREA / 2, 0.05 * STRENGTH * AREA);
  EXPECT_NEAR(-bar.move(Vec3(-0.25 * LAST, 0, 0))[0], full / 2, 1e-9 * full);
  EXPECT_NEAR(-bar.move(Vec3(-0.25 * LAST, 0, 0))[0], 0, 1e-9 * full);
  EXPECT_EQ(bar.cohesion.dissipated(), spent);
  EXPECT_NEAR(-bar.move(Vec3(0.5 * LAST, 0, 0))[0], full, 1e-9 * full);
}

TEST(Cohesion, FacesThatWouldCrossArePushedApart) {
  BrokenBar bar;
  EXPECT_GT(bar.move(Vec3(-0.1 * LAST, 0, 0))[0], STRENGTH * AREA);
  EXPECT_EQ(bar.cohesion.dissipated(), 0);
}

TEST(Cohesion, RotatingTheBodyTurnsTheTraction) {
  BrokenBar straight, turned;
  const Mat3 R = Eigen::AngleAxisd(1, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (Vec3& x : turned.motion.x) x = R * x;
  const Vec3 by(0.2 * LAST, 0.1 * LAST, 0);
  EXPECT_LT((R * straight.move(by) - turned.move(R * by)).norm(), 1e-9 * STRENGTH * AREA);
}

TEST(Cohesion, ALaterCrackDoesNotChangeWhatTheFacesFeel) {
  BrokenBar whole, halved;
  const Vec3 by(0.3 * LAST, 0, 0);
  whole.move(by);
  halved.move(by);
  halved.cut(plane(Vec3(0, 0.11, 0), Vec3::UnitY()));
  halved.cohesion.changed(halved.mesh);
  const double spent = halved.cohesion.dissipated();
  ASSERT_TRUE(halved.begin());
  halved.update(std::vector<Vec3>(halved.motion.x.size(), Vec3::Zero()));
  int count = 0;
  const std::vector<int> piece = halved.mesh.copyPieces(&count);
  ASSERT_EQ(count, 4);
  double pull = 0;
  for (const Spring& spring : halved.springs) {
    pull += spring.force.norm();
    std::set<int> pieces;
    for (int i = 0; i < spring.count; ++i) pieces.insert(piece[spring.copies[i]]);
    EXPECT_EQ(pieces.size(), 2u);  // one on either side
  }
  EXPECT_NEAR(pull, whole.move(Vec3::Zero()).norm(), 1e-9 * STRENGTH * AREA);
  EXPECT_EQ(halved.cohesion.dissipated(), spent);
}

}  // namespace
}  // namespace incision::test

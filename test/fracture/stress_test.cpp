#include "incision/fracture/stress.h"

#include <gtest/gtest.h>

#include "incision/fracture/rankine.h"
#include "support/random.h"
#include "support/rig.h"

namespace incision::test {
namespace {

/// Beyond x = 0.5 a hundred times as stiff.
RigSettings softAndStiff() {
  RigSettings settings;
  settings.regions.resize(1);
  settings.regions[0].place = {Vec3(0.5, -1, -1), Vec3(2, 2, 2)};
  settings.regions[0].young_modulus = 100 * settings.material.young_modulus;
  return settings;
}

TEST(SmoothedStress, AUniformStressStaysWhatItIs) {
  Random random(3);
  Rig rig(jitteredGrid({{3, 3, 3}, Vec3::Ones(), Vec3::Zero()}, 0.2, &random), RigSettings());
  rig.cut(plane(Vec3(0.41, 0.52, 0.48), Vec3(1, 0.3, 0.2)));
  const Mat3 F = Mat3::Identity() + 1e-2 * Mat3(random.rotation());
  for (Vec3& x : rig.motion.x) x = F * x;
  SmoothedStress stress;
  stress.topologyChanged(rig.step.assembly());
  stress.update(rig.step.assembly(), rig.motion.x);
  const Mat3 expected = rig.step.assembly().stress(0, rig.motion.x);
  for (const Mat3& smoothed : stress.smoothed()) EXPECT_LT((smoothed - expected).norm(), 1e-10 * expected.norm());
}

TEST(SmoothedStress, IsTheMeanByVolumeOfAnElementAndTheFourBesideIt) {
  Rig rig(block({3, 3, 3}, Vec3::Ones()), RigSettings());
  rig.motion.x = randomVectors(rig.motion.x.size(), 1, 4);
  SmoothedStress stress;
  stress.topologyChanged(rig.step.assembly());
  stress.update(rig.step.assembly(), rig.motion.x);
  for (std::size_t e = 0; e < rig.mesh.parts().size(); ++e) {
    const int part = static_cast<int>(e);
    double volume = elementVolume(rig.mesh.mesh(), part);
    Mat3 sum = volume * rig.step.assembly().stress(part, rig.motion.x);
    for (int other : rig.mesh.topology().neighbours[e]) {
      if (other < 0) continue;
      volume += elementVolume(rig.mesh.mesh(), other);
      sum += elementVolume(rig.mesh.mesh(), other) * rig.step.assembly().stress(other, rig.motion.x);
    }
    EXPECT_LT((stress.smoothed()[e] - sum / volume).norm(), 1e-12 * (sum / volume).norm());
  }
}

TEST(SmoothedStress, NothingCrossesACut) {
  for (const double at : {0.5, 0.47}) {  // along faces, through elements
    Rig rig(block({4, 2, 2}, Vec3(1, 0.5, 0.5)), RigSettings());
    rig.cut(plane(Vec3(at, 0, 0), Vec3::UnitX()));
    // One side is stretched, the other at rest.
    int count = 0;
    const std::vector<int> piece = rig.mesh.copyPieces(&count);
    ASSERT_EQ(count, 2);
    const int left = piece[rig.mesh.ownCopy(0)];
    for (std::size_t c = 0; c < piece.size(); ++c)
      if (piece[c] != left) rig.motion.x[c][0] *= 1.1;
    SmoothedStress stress;
    stress.topologyChanged(rig.step.assembly());
    stress.update(rig.step.assembly(), rig.motion.x);
    const RigSettings settings;
    const double pulled = 0.1 * (settings.material.lambda() + 2 * settings.material.mu());
    for (std::size_t p = 0; p < rig.mesh.parts().size(); ++p) {
      const bool still = piece[rig.mesh.parts()[p].copies[0]] == left;
      EXPECT_NEAR(stress.smoothed()[p](0, 0), still ? 0 : pulled, 1e-9 * pulled);
    }
  }
}

TEST(SmoothedStress, NothingCrossesFromOneRegionToAnother) {
  const RigSettings settings = softAndStiff();
  Rig rig(block({4, 2, 2}, Vec3(1, 0.5, 0.5)), settings);
  for (Vec3& x : rig.motion.x) x[0] *= 1.1;
  SmoothedStress stress;
  stress.topologyChanged(rig.step.assembly());
  stress.update(rig.step.assembly(), rig.motion.x);
  for (std::size_t p = 0; p < rig.mesh.parts().size(); ++p) {
    const Lame& lame = rig.materials.lame(rig.mesh.parts()[p].element);
    const double pulled = 0.1 * (lame.lambda + 2 * lame.mu);
    EXPECT_NEAR(stress.smoothed()[p](0, 0), pulled, 1e-9 * pulled);
  }
}

TEST(SmoothedStress, EveryPartBeyondItsStrengthIsASuspectAndFewOthersAre) {
  const RigSettings settings = softAndStiff();
  Rig rig(block({8, 4, 4}, Vec3(1, 0.5, 0.5)), settings);
  rig.cut(plane(Vec3(0.31, 0.3, 0.3), Vec3(1, 0.3, 0.2)));
  const std::vector<Vec3> moved = randomVectors(rig.motion.x.size(), 1e-3, 6);
  for (std::size_t c = 0; c < moved.size(); ++c) rig.motion.x[c] += moved[c];
  SmoothedStress all, some;
  for (SmoothedStress* stress : {&all, &some}) stress->topologyChanged(rig.step.assembly());
  all.update(rig.step.assembly(), rig.motion.x);
  const std::size_t parts = rig.mesh.parts().size();
  std::size_t suspected = 0, broken = 0;
  for (const double strain : {3e-3, 4e-3, 6e-3, 8e-3, 1e-2}) {
    const double soft = strain * settings.material.young_modulus;
    const std::vector<Strength> strengths = {{soft, 1.5 * soft}, {100 * soft, 150 * soft}};
    std::vector<char> suspects(parts, 0);
    if (!some.findSuspects(rig.step.assembly(), rig.motion.x, strengths, &suspects)) suspects.assign(parts, 0);
    some.update(rig.step.assembly(), rig.motion.x, suspects);
    for (std::size_t p = 0; p < parts; ++p) {
      const Strength& strength = strengths[rig.materials.regions().of(rig.mesh.parts()[p].element)];
      const bool breaks = rankine(all.smoothed()[p], strength).share > 1;
      EXPECT_TRUE(!breaks || suspects[p]);
      EXPECT_TRUE(!suspects[p] || some.smoothed()[p] == all.smoothed()[p]);
      suspected += suspects[p];
      broken += breaks;
    }
  }
  EXPECT_GT(broken, 0U);
  EXPECT_LT(suspected, 4 * broken);
}

TEST(SmoothedStress, WhatACrackRelievesDoesNotHideWhatLiesAhead) {
  Rig rig(block({4, 4, 2}, Vec3(1, 1, 0.5)), RigSettings());
  const Insertion done = rig.cut(rectangle(Vec3(0.47, 0, 0), Vec3::UnitX(), Vec3::UnitY(), 1, 4));
  ASSERT_TRUE(done.changed());
  SmoothedStress stress;
  stress.topologyChanged(rig.step.assembly());
  rig.motion.x = randomVectors(rig.motion.x.size(), 1, 5);
  stress.update(rig.step.assembly(), rig.motion.x);
  // An element ahead of the cut averages over those beside it that are not split, and itself.
  int ahead = 0;
  for (std::size_t e = 0; e < rig.mesh.mesh().elements.size(); ++e) {
    if (!rig.mesh.isWhole(static_cast<int>(e))) continue;
    double volume = 0;
    Mat3 sum = Mat3::Zero();
    bool beside_the_cut = false;
    for (int other : {static_cast<int>(e), rig.mesh.topology().neighbours[e][0], rig.mesh.topology().neighbours[e][1],
                      rig.mesh.topology().neighbours[e][2], rig.mesh.topology().neighbours[e][3]}) {
      if (other < 0) continue;
      const bool whole = rig.mesh.isWhole(other);
      const auto& nodes = rig.mesh.mesh().elements[e];
      const auto low = [&](int n) { return rig.mesh.mesh().nodes[n][0] < 0.47; };
      const bool crossed =
          std::any_of(nodes.begin(), nodes.end(), low) && !std::all_of(nodes.begin(), nodes.end(), low);
      beside_the_cut = beside_the_cut || (!whole && crossed);
      if (!whole) continue;
      volume += elementVolume(rig.mesh.mesh(), other);
      sum += elementVolume(rig.mesh.mesh(), other) * rig.step.assembly().stress(other, rig.motion.x);
    }
    if (!beside_the_cut) continue;
    ++ahead;
    EXPECT_LT((stress.smoothed()[e] - sum / volume).norm(), 1e-12 * (sum / volume).norm());
  }
  EXPECT_GT(ahead, 0);
}

}  // namespace
}  // namespace incision::test

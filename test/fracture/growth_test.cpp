#include "incision/fracture/growth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/rig.h"

namespace incision::test {
namespace {

constexpr double STRETCH = 0.01, TENSILE_STRENGTH = 1e4;  // what 1 % takes of E = 1e6 Pa

/// A bar along x in empty space, stretched by so much.
class StretchedBar : public Rig {
 public:
  explicit StretchedBar(double stretch, const RigSettings& tissue = settings())
      : Rig(block({8, 2, 2}, Vec3(1, 0.25, 0.25)), tissue) {
    for (Vec3& x : motion.x) x[0] *= 1 + stretch;
  }
  static RigSettings settings() {
    RigSettings settings;
    settings.material = {1e6, 0, 1000, 0, 0};
    settings.warping = false;
    return settings;
  }
  std::vector<CrackAdvance> advances(CrackGrowth* growth) {
    return growth->advances(time, time_step, step.assembly(), motion.x, step.pieceOf());
  }
  Insertion insert(const CrackField& field) {
    const Insertion done = mesh.insert(field);
    for (int c = static_cast<int>(motion.x.size()); c < mesh.numCopies(); ++c) {
      motion.x.push_back(motion.x[mesh.copyParent(c)]);
      motion.v.push_back(motion.v[mesh.copyParent(c)]);
    }
    return done;
  }
  /// As the body does it; returns what the cracks did.
  std::vector<CrackResult> fracture(CrackGrowth* growth) {
    std::vector<CrackResult> results;
    std::vector<int> touched;
    for (const CrackAdvance& advance : advances(growth)) {
      const auto field = growth->field(advance, mesh);
      if (!field) continue;
      const Insertion done = insert(*field);
      EXPECT_TRUE(done.changed());
      results.push_back(growth->inserted(time, advance, *field, done, mesh, motion.x));
      touched.insert(touched.end(), done.touched.begin(), done.touched.end());
    }
    if (touched.empty()) return results;
    step.topologyChanged(motion, touched);
    growth->topologyChanged(step.assembly(), touched);
    return results;
  }
};

FractureSettings strength(double tensile) {
  FractureSettings settings;
  settings.tensile_strength = tensile;
  return settings;
}

TEST(CrackGrowth, OnlyAWeakRegionCracks) {
  RigSettings settings = StretchedBar::settings();
  settings.regions.resize(1);
  settings.regions[0].place = {Vec3(0.5, -1, -1), Vec3(0.75, 1, 1)};
  settings.regions[0].tensile_strength = 0.9 * TENSILE_STRENGTH;
  StretchedBar bar(0.95 * STRETCH, settings);
  CrackGrowth growth(strength(TENSILE_STRENGTH));
  growth.topologyChanged(bar.step.assembly(), {});
  const std::vector<CrackAdvance> advances = bar.advances(&growth);
  ASSERT_EQ(advances.size(), 1u);
  for (int p : advances[0].parts) EXPECT_EQ(bar.materials.regions().of(bar.mesh.parts()[p].element), 1);
}

TEST(CrackGrowth, NothingCracksBelowTheStrength) {
  StretchedBar bar(0.999 * STRETCH);
  CrackGrowth growth(strength(TENSILE_STRENGTH));
  growth.topologyChanged(bar.step.assembly(), {});
  EXPECT_TRUE(bar.advances(&growth).empty());
}

TEST(CrackGrowth, APieceStartsOneCrackAcrossThePull) {
  StretchedBar bar(1.001 * STRETCH);
  CrackGrowth growth(strength(TENSILE_STRENGTH));
  growth.topologyChanged(bar.step.assembly(), {});
  const std::vector<CrackResult> results = bar.fracture(&growth);
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results[0].change, CrackChange::STARTED);
  EXPECT_EQ(results[0].elements.size(), 1u);
  EXPECT_NEAR(results[0].stress, 1.001 * TENSILE_STRENGTH, 1e-6 * TENSILE_STRENGTH);
  EXPECT_GT(std::abs(results[0].normal[0]), std::cos(0.05));  // it passes nodes at a distance
}

TEST(CrackGrowth, EveryLoadedPieceStartsItsOwn) {
  StretchedBar bar(1.001 * STRETCH);
  bar.cut(plane(Vec3(0.51, 0, 0), Vec3::UnitX()));
  for (Vec3& x : bar.motion.x) x[0] += STRETCH * std::pow(x[0] - 0.51, 3);  // most far from the cut
  CrackGrowth growth(strength(TENSILE_STRENGTH));
  growth.topologyChanged(bar.step.assembly(), {});
  const std::vector<CrackResult> results = bar.fracture(&growth);
  ASSERT_EQ(results.size(), 2u);
  EXPECT_LT((results[0].where[0] - 0.515) * (results[1].where[0] - 0.515), 0);
}

TEST(CrackGrowth, WhereACrackGrowsNoOtherStarts) {
  StretchedBar bar(1.001 * STRETCH);
  CrackGrowth growth(strength(TENSILE_STRENGTH));
  growth.topologyChanged(bar.step.assembly(), {});
  bar.fracture(&growth);
  growth.stepTaken();
  const std::vector<CrackResult> results = bar.fracture(&growth);
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results[0].change, CrackChange::GREW);
  EXPECT_EQ(results[0].crack, 0);
  EXPECT_LE(results[0].elements.size(), 4u);  // across the faces of the first
}

TEST(CrackGrowth, NoneStartsInACrackElement) {
  StretchedBar bar(1.001 * STRETCH);
  for (int piece = 0; piece < 2; ++piece) {
    bar.cut(plane(Vec3(0, 0, 0.06 + 0.13 * piece), Vec3::UnitZ()));  // along the pull, through the lower cells
    CrackGrowth growth(strength(TENSILE_STRENGTH));
    growth.topologyChanged(bar.step.assembly(), {});
    for (const CrackAdvance& advance : bar.advances(&growth)) {
      ASSERT_EQ(advance.parts.size(), 1u);
      const int element = bar.mesh.parts()[advance.parts[0]].element;
      EXPECT_LT(bar.mesh.parts()[element].next, 0) << piece << " " << element;
    }
  }
}

TEST(CrackGrowth, PartsBesideAChangeWaitForTheNextStep) {
  StretchedBar bar(1.5 * STRETCH);
  CrackGrowth growth(strength(TENSILE_STRENGTH));
  std::vector<int> all;
  for (std::size_t n = 0; n < bar.mesh.mesh().nodes.size(); ++n) all.push_back(static_cast<int>(n));
  growth.topologyChanged(bar.step.assembly(), all);
  EXPECT_TRUE(bar.advances(&growth).empty());
  growth.stepTaken();
  EXPECT_EQ(bar.advances(&growth).size(), 1u);
}

TEST(CrackGrowth, WhatTheMeshRefusesIsNotTriedAgain) {
  StretchedBar bar(1.5 * STRETCH);
  CrackGrowth growth(strength(TENSILE_STRENGTH));
  growth.topologyChanged(bar.step.assembly(), {});
  const std::vector<CrackAdvance> first = bar.advances(&growth);
  EXPECT_EQ(growth.refused(0, first.at(0)).change, CrackChange::STOPPED);
  const std::vector<CrackAdvance> second = bar.advances(&growth);
  ASSERT_EQ(second.size(), 1u);
  EXPECT_NE(second[0].parts, first[0].parts);

  bar.fracture(&growth);
  growth.stepTaken();
  const std::vector<CrackAdvance> grown = bar.advances(&growth);
  ASSERT_EQ(grown.at(0).crack, 0);
  growth.refused(0, grown[0]);
  for (const CrackAdvance& advance : bar.advances(&growth))
    for (int part : advance.parts) EXPECT_EQ(std::count(grown[0].parts.begin(), grown[0].parts.end(), part), 0);
}

TEST(CrackGrowth, OneThatRecallsAMemoryGoesOnAsTheOneThatHadIt) {
  StretchedBar bar(1.3 * STRETCH);
  FractureSettings settings = strength(TENSILE_STRENGTH);
  settings.crack_speed = 50;  // so that when a crack reached an element counts
  CrackGrowth growth(settings);
  growth.topologyChanged(bar.step.assembly(), {});
  for (int k = 0; k < 30; ++k) {
    bar.fracture(&growth);
    if (k % 3 > 0) growth.stepTaken();  // otherwise some parts wait
    const CrackGrowth::Memory memory = growth.memory();
    CrackGrowth other(settings);
    other.recall(memory);
    other.topologyChanged(bar.step.assembly(), {});
    bar.time += bar.time_step;
    const std::vector<CrackAdvance> first = bar.advances(&growth), second = bar.advances(&other);
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
      EXPECT_EQ(first[i].crack, second[i].crack);
      EXPECT_EQ(first[i].parts, second[i].parts);
      EXPECT_EQ(first[i].reached, second[i].reached);
      EXPECT_EQ(first[i].fresh, second[i].fresh);
    }
    if (!first.empty()) growth.refused(bar.time, first[0]);
  }
}

TEST(CrackGrowth, AMemoryThatIsKeptDoesNotChange) {
  StretchedBar bar(1.3 * STRETCH);
  CrackGrowth growth(strength(TENSILE_STRENGTH));
  growth.topologyChanged(bar.step.assembly(), {});
  bar.fracture(&growth);
  const CrackGrowth::Memory memory = growth.memory();
  const auto phi = memory.cracks.at(0).phi;
  growth.stepTaken();
  bar.fracture(&growth);
  EXPECT_GT(growth.memory().cracks.at(0).phi.size(), phi.size());
  EXPECT_EQ(memory.cracks.at(0).phi, phi);
}

TEST(GrowingCracks, OneThatHasTakenInOthersAnswersToAllTheirNumbers) {
  GrowingCracks cracks;
  for (int number : {0, 1, 2, 3}) cracks.cracks[number].phi = {{10 + number, 0.5}};
  cracks.join(1, 2, -1);
  const GrowingCracks before = cracks;
  cracks.join(0, 2, 1);
  for (int number : {0, 1, 2}) {
    EXPECT_EQ(cracks.survivorOf(number), 0);
    EXPECT_EQ(cracks.find(number), &cracks.cracks.at(0));
  }
  EXPECT_EQ(cracks.at(2).phi, (std::unordered_map<int, double>{{10, 0.5}, {11, 0.5}, {12, -0.5}}));
  EXPECT_EQ(cracks.survivorOf(3), 3);
  EXPECT_EQ(cracks.find(4), nullptr);
  EXPECT_EQ(before.survivorOf(2), 1);
  EXPECT_EQ(before.at(1).phi.size(), 2u);
}

TEST(CrackGrowth, PositionsThatAreNotFiniteCrackNothing) {
  StretchedBar bar(2 * STRETCH);
  for (Vec3& x : bar.motion.x) x[1] = std::numeric_limits<double>::quiet_NaN();
  CrackGrowth growth(strength(TENSILE_STRENGTH));
  growth.topologyChanged(bar.step.assembly(), {});
  EXPECT_TRUE(bar.advances(&growth).empty());
}

TEST(CrackGrowth, EnergyAndMomentumDoNotRiseAtACrack) {
  StretchedBar bar(1.3 * STRETCH);
  bar.time_step = 1e-3;
  CrackGrowth growth(strength(TENSILE_STRENGTH));
  growth.topologyChanged(bar.step.assembly(), {});
  const double first = bar.energy();
  int cracked = 0;
  for (int k = 0; k < 60; ++k) {
    const double before = bar.energy();
    const Vec3 momentum = bar.momentum();
    cracked += static_cast<int>(bar.fracture(&growth).size());
    EXPECT_NEAR(bar.energy(), before, 1e-12 * first);
    EXPECT_LT((bar.momentum() - momentum).norm(), 1e-12 * std::sqrt(first * 62.5));
    ASSERT_TRUE(bar.advance());
    growth.stepTaken();
    EXPECT_LE(bar.energy(), before * (1 + 1e-12));
  }
  EXPECT_GT(cracked, 5);
}

TEST(CrackGrowth, TheCrackSurfaceHasNoSteps) {
  StretchedBar bar(1.3 * STRETCH);
  CrackGrowth growth(strength(TENSILE_STRENGTH));
  growth.topologyChanged(bar.step.assembly(), {});
  for (int k = 0; k < 100 && bar.pieces() < 2; ++k) {  // nothing moves: every step finds the same stretch
    bar.fracture(&growth);
    growth.stepTaken();
  }
  ASSERT_EQ(bar.pieces(), 2);
  // All elements between the two pieces are split, or the pieces would hang together, and each by one plane.
  std::vector<double> volumes(2, 0);
  int count = 0;
  const std::vector<int> piece = bar.mesh.copyPieces(&count);
  for (std::size_t p = 0; p < bar.mesh.parts().size(); ++p)
    volumes[piece[bar.mesh.parts()[p].copies[0]]] += bar.step.assembly().volume(static_cast<int>(p));
  EXPECT_NEAR(volumes[0] + volumes[1], 0.0625, 1e-12);
  for (std::size_t e = 0; e < bar.mesh.mesh().elements.size(); ++e) {
    const int next = bar.mesh.parts()[e].next;
    EXPECT_TRUE(next < 0 || bar.mesh.parts()[next].next < 0);
  }
}

}  // namespace
}  // namespace incision::test

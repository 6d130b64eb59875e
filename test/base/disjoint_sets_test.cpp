#include "incision/base/disjoint_sets.h"

#include <gtest/gtest.h>

#include <random>

namespace incision {
namespace {

TEST(DisjointSets, AreKnownByTheirLowestNumberInWhateverOrderTheyJoin) {
  std::mt19937 random(1);
  for (int seed = 0; seed < 50; ++seed) {
    const int n = 1 + static_cast<int>(random() % 60);
    std::vector<std::pair<int, int>> joins(random() % n);
    for (auto& [a, b] : joins) a = static_cast<int>(random() % n), b = static_cast<int>(random() % n);
    // Every number takes the lowest label of its set by being relabelled at each join.
    std::vector<int> label(n);
    std::iota(label.begin(), label.end(), 0);
    for (const auto& [a, b] : joins) {
      const int low = std::min(label[a], label[b]), high = std::max(label[a], label[b]);
      std::replace(label.begin(), label.end(), high, low);
    }
    std::shuffle(joins.begin(), joins.end(), random);
    DisjointSets sets(n);
    for (const auto& [a, b] : joins) sets.join(a, b);
    for (int i = 0; i < n; ++i) EXPECT_EQ(sets.lowest(i), label[i]);
  }
}

TEST(DisjointSets, AJoinSaysWhetherItJoined) {
  DisjointSets sets(4);
  EXPECT_TRUE(sets.join(3, 2));
  EXPECT_TRUE(sets.join(2, 1));
  EXPECT_FALSE(sets.join(1, 3));
  EXPECT_FALSE(sets.join(0, 0));
  EXPECT_NE(sets.lowest(0), sets.lowest(3));
}

TEST(DisjointSets, AreNumberedInTheOrderOfTheirLowestNumbers) {
  DisjointSets sets(6);
  sets.join(5, 1);
  sets.join(4, 2);
  std::vector<int> set_of;
  EXPECT_EQ(sets.enumerate(&set_of), 4);
  EXPECT_EQ(set_of, std::vector<int>({0, 1, 2, 3, 2, 1}));
  sets.reset(2);
  EXPECT_EQ(sets.enumerate(&set_of), 2);
  EXPECT_EQ(set_of, std::vector<int>({0, 1}));
}

TEST(DisjointSets, ALongChainJoinsAtOnce) {
  const int n = 1'000'000;
  DisjointSets sets(n);
  for (int i = n - 1; i > 0; --i) sets.join(i, i - 1);
  EXPECT_EQ(sets.lowest(n - 1), 0);
}

}  // namespace
}  // namespace incision

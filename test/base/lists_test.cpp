#include "incision/base/lists.h"

#include <gtest/gtest.h>

#include <random>

namespace incision {
namespace {

template <typename T>
std::vector<T> copyOf(Span<T> span) {
  return {span.begin(), span.end()};
}

TEST(Lists, SortingKeepsTheOrderWithinAList) {
  const std::vector<std::pair<int, int>> entries = {{3, 7}, {0, 5}, {3, 1}, {3, 4}, {0, 9}};
  Lists<int> lists;
  lists.sort(5, [&](const auto& f) {
    for (const auto& [list, value] : entries) f(list, value);
  });
  ASSERT_EQ(lists.count(), 5);
  EXPECT_EQ(copyOf(lists[0]), std::vector<int>({5, 9}));
  EXPECT_EQ(copyOf(lists[3]), std::vector<int>({7, 1, 4}));
  for (int empty : {1, 2, 4}) EXPECT_EQ(lists[empty].size(), 0);
  EXPECT_EQ(lists.start(5), static_cast<int>(entries.size()));
}

TEST(Lists, SortedAndMadeOneByOneAreTheSame) {
  std::mt19937 random(1);
  std::vector<int> list_of(500);
  for (int& list : list_of) list = static_cast<int>(random() % 40);
  const Lists<int> sorted = sortedByList(list_of, 40);
  Lists<int> made;
  for (int list = 0; list < 40; ++list) {
    for (int i = 0; i < 500; ++i)
      if (list_of[i] == list) made.append(i);
    made.finish();
  }
  ASSERT_EQ(made.count(), sorted.count());
  for (int list = 0; list <= 40; ++list) EXPECT_EQ(made.start(list), sorted.start(list));
  EXPECT_EQ(made.values(), sorted.values());
}

TEST(Lists, WhatIsNotFinishedIsNoListYet) {
  Lists<int> lists;
  EXPECT_EQ(lists.count(), 0);
  lists.append(1);
  lists.finish();
  lists.append(2);
  lists.append(3);
  EXPECT_EQ(lists.count(), 1);
  ASSERT_EQ(lists.unfinished().size(), 2);
  lists.unfinished()[0] = 4;
  lists.finish();
  EXPECT_EQ(copyOf(lists[1]), std::vector<int>({4, 3}));
  EXPECT_EQ(lists.unfinished().size(), 0);
}

TEST(Lists, NothingIsLeftOfWhatWasThereBefore) {
  Lists<int> lists = sortedByList({0, 1, 1, 2}, 3);
  lists.sort(1, [](const auto& f) { f(0, 8); });
  EXPECT_EQ(lists.count(), 1);
  EXPECT_EQ(lists.values(), std::vector<int>({8}));
  lists.clear();
  EXPECT_EQ(lists.count(), 0);
  EXPECT_TRUE(lists.values().empty());
  lists.sort(0, [](const auto&) {});
  EXPECT_EQ(lists.count(), 0);
}

}  // namespace
}  // namespace incision

#include "incision/base/short_list.h"

#include <gtest/gtest.h>

#include <numeric>

namespace incision {
namespace {

TEST(ShortList, HasWhatWasPutInHoweverLongItIs) {
  for (int count = 0; count <= 9; ++count) {
    ShortList<int, 4> list;
    for (int i = 0; i < count; ++i) list.push_back(10 * i);
    const ShortList<int, 4> copy = list;
    EXPECT_EQ(copy.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(copy.empty(), count == 0);
    EXPECT_EQ(std::accumulate(copy.begin(), copy.end(), 0), 5 * count * (count - 1));
    for (int i = 0; i < count; ++i) EXPECT_EQ(copy[i], 10 * i);
  }
}

}  // namespace
}  // namespace incision

// Into which parts a step is taken apart.
#include "incision/solver/step_in_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace incision {
namespace {

/// Steps of 1 s in which something turns at a rate [rad/s], and does not settle where a part is longer than `settles`.
struct Turning {
  double rate = 0, settles = 1;
  std::vector<double> parts = {};  ///< that were taken [s]
  double end = 0;

  bool take(double failing_from = 2) {
    return advanceInParts(
        {1}, 0,
        [&](const StepSpan& span, double time, StepDemand demand) {
          const bool sound = span.time_step <= settles, far = span.time_step * rate > 0.5;
          if (time >= failing_from) return false;
          if (demand == StepDemand::SOUND && (!sound || far)) return false;
          if (demand == StepDemand::SHORT_TURNS && far) return false;
          EXPECT_EQ(time, end);
          parts.push_back(span.time_step);
          end += span.time_step;
          return true;
        },
        [&] { return std::make_pair(parts, end); },
        [&](const std::pair<std::vector<double>, double>& before) { std::tie(parts, end) = before; });
  }
};

TEST(StepInParts, ThatDoesNotSettleIsTakenInEighths) {
  for (const double settles : {1.0, 0.5, 0.125, 0.01}) {
    Turning step{0, settles};
    ASSERT_TRUE(step.take());
    EXPECT_EQ(step.end, 1);
    EXPECT_EQ(step.parts, std::vector<double>(step.parts.size(), std::max(settles, 0.125)));
  }
}

TEST(StepInParts, ThatTurnsFarIsTakenInParts64TimesAsShort) {
  for (const int parts : {1, 2, 16, 64}) {
    for (const double settles : {1.0, 0.01}) {
      Turning step{0.5 * parts, settles};
      ASSERT_TRUE(step.take());
      EXPECT_EQ(step.end, 1);
      EXPECT_EQ(step.parts, std::vector<double>(step.parts.size(), std::min(settles < 1 ? 0.125 : 1, 1.0 / parts)));
    }
  }
  Turning faster{1000};
  ASSERT_TRUE(faster.take());
  EXPECT_EQ(faster.parts, std::vector<double>(64, 1.0 / 64));
}

TEST(StepInParts, ThatFailsInAnyLeavesNothing) {
  for (const double from : {0.0, 0.3, 0.98}) {
    Turning step{20};
    EXPECT_FALSE(step.take(from));
    EXPECT_TRUE(step.parts.empty());
    EXPECT_EQ(step.end, 0);
  }
}

}  // namespace
}  // namespace incision

#include "incision/pace/slowness.h"

#include <gtest/gtest.h>

#include "pace/things_in_tests.h"

namespace incision {
namespace {

/// A body with steps of 10 ms and one of four threads.
class SlownessTest : public ::testing::Test {
 protected:
  SlownessTest() { slowness_.restart(START); }

  /// Wall time goes on, and so many steps are taken in it, each of so many ms of solving and of contact; what is said.
  std::string pass(double duration, int steps, double solve_ms, double contact_ms = 0) {
    StepResult step;
    step.phase_ms.solve = solve_ms;
    step.phase_ms.contact = contact_ms;
    step.step_ms = solve_ms + contact_ms;
    for (int k = 0; k < steps; ++k) slowness_.stepTaken(step);
    time_ += duration;
    const auto now = START + std::chrono::duration_cast<SteadyTime::duration>(std::chrono::duration<double>(time_));
    return slowness_.look(now, 1, 4).value_or("");
  }
  static bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

  Slowness slowness_{0.01, true};
  double time_ = 0;
};

TEST_F(SlownessTest, IsSilentWhileStepsKeepUp) {
  for (int k = 0; k < 5; ++k) EXPECT_EQ("", pass(5, 500, 9));
}

TEST_F(SlownessTest, IsSilentWhereASingleStepTakesLong) {
  EXPECT_EQ("", pass(0.4, 1, 400));
  EXPECT_EQ("", pass(4.6, 460, 5));
}

TEST_F(SlownessTest, IsToldWithWhatTakesTheTimeAndWhatWouldHelp) {
  EXPECT_EQ("", pass(4.9, 196, 20, 5));
  EXPECT_EQ(pass(0.1, 4, 20, 5),
            "slower than real time, at 0.4 of it: a step of 10 ms takes 25 ms (solve 80 %, contact 20 %); a coarser "
            "mesh or a longer solver.time_step would help, perhaps more solver.threads (1, the machine has 4)");
}

TEST_F(SlownessTest, IsToldOnceUntilStepsHaveKeptUpAgain) {
  EXPECT_NE("", pass(5, 200, 25));
  EXPECT_EQ("", pass(5, 200, 25));
  EXPECT_EQ("", pass(5, 200, 25));
  EXPECT_EQ("", pass(5, 500, 5));
  EXPECT_NE("", pass(5, 200, 25));
}

TEST_F(SlownessTest, OfTimeBetweenStepsSaysSo) {
  const std::string said = pass(5, 200, 5);
  EXPECT_TRUE(has(said, "a step of 10 ms takes 5 ms (solve 100 %), and between steps something else")) << said;
  EXPECT_FALSE(has(said, "coarser")) << said;
}

TEST_F(SlownessTest, OfAFewLongStepsSaysSo) {
  EXPECT_EQ("", pass(2, 2, 1000));
  const std::string said = pass(3, 300, 5);
  EXPECT_TRUE(has(said, "at 0.604 of it: a step of 10 ms takes 11.6 ms")) << said;
  EXPECT_EQ("", pass(0.95, 1, 950));
  EXPECT_EQ("", pass(4.05, 405, 5));
  EXPECT_EQ(pass(5, 500, 5), "");
  EXPECT_EQ("", pass(0.8, 1, 800));
  const std::string few = pass(4.2, 420, 5);
  EXPECT_TRUE(has(few, "takes 6.89 ms (solve 100 %) on average, the longest 800 ms")) << few;
}

TEST_F(SlownessTest, OfContactNamesWhatPiecesNeedNot) { EXPECT_TRUE(has(pass(5, 200, 5, 20), "contact.self: false")); }

TEST_F(SlownessTest, APauseIsNoTime) {
  EXPECT_EQ("", pass(4, 400, 5));
  time_ = 1000;
  slowness_.restart(START + std::chrono::seconds(1000));
  EXPECT_EQ("", pass(5, 500, 5));
  EXPECT_EQ("", pass(100, 0, 0));  // no step at all, which /diagnostics tells
}

}  // namespace
}  // namespace incision

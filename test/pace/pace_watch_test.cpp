#include "incision/pace/pace_watch.h"

#include <gtest/gtest.h>

#include "answers_in_tests.h"
#include "frames_in_tests.h"
#include "pace/things_in_tests.h"

namespace incision {
namespace {

using std::chrono::seconds;

class PaceWatchTest : public ::testing::Test {
 protected:
  PaceWatchTest() { tick(0, 1000 * SECOND); }

  /// A clock message so many seconds after the start, when it has been waited for.
  void tick(int after, Nanoseconds clock) {
    pacer_.tick(START + seconds(after), clock);
    pacer_.update(START + seconds(after) + CLOCK_DELAY);
  }
  /// What is warned of so many seconds after the start.
  std::string look(double after) {
    answers_.warnings.clear();
    watch_.look(START + std::chrono::duration_cast<SteadyTime::duration>(std::chrono::duration<double>(after)));
    EXPECT_LE(answers_.warnings.size(), 1u);
    return answers_.warnings.empty() ? "" : answers_.warnings[0];
  }
  void cut(Nanoseconds stamp) {
    PlaneCut plane;
    plane.label = "x";
    commands_.add({plane, "body", stamp, START});
  }
  static bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

  FramesInTests frames_;
  AnswersInTests answers_;
  Wakeup wakeup_;
  ClockPacer pacer_{0.01, 1};
  Commands commands_{{{"tool"}, true, 60}, frames_, answers_, wakeup_};
  PaceWatch watch_{pacer_, commands_, answers_};
};

TEST_F(PaceWatchTest, IsSilentWhereNothingIsLostAndNothingWaits) {
  cut(1001 * SECOND);
  for (int i = 0; i < 3; ++i) EXPECT_EQ("", look(i));
}

TEST_F(PaceWatchTest, WarnsOfSkippedTimeOnce) {
  EXPECT_EQ("", look(0));
  tick(1, 1007 * SECOND);
  const std::string warning = look(2);
  EXPECT_TRUE(has(warning, "no steps are taken for 7 s of /clock")) << warning;
  EXPECT_TRUE(has(warning, "slower")) << warning;
  EXPECT_EQ("", look(4));
}

TEST_F(PaceWatchTest, WarnsOfThinnedPosesOnce) {
  EXPECT_EQ("", look(0));
  for (std::size_t i = 0; i < MAX_WAITING_POSES + 3; ++i) commands_.add({ToolPose{0, {}}, "body", 0, START});
  EXPECT_TRUE(has(look(2), "tool 'tool': 3 of its poses and jaw's angles are left out so far"));
  EXPECT_EQ("", look(4));
}

TEST_F(PaceWatchTest, WarnsAgainAndAgainOfACommandThatWaitsLongForItsStamp) {
  cut(1020 * SECOND);
  EXPECT_EQ("", look(2.5));
  for (const double after : {4.6, 6.7}) {
    const std::string warning = look(after);
    EXPECT_TRUE(has(warning, "the cut 'x' has waited")) << warning;
    EXPECT_TRUE(has(warning, "its stamp, 1020.000, which is 20.000 s ahead of the clock")) << warning;
    EXPECT_FALSE(has(warning, "wall time")) << warning;
  }
}

TEST_F(PaceWatchTest, AStampOfWallTimeOnASimulatedClockIsTakenForOne) {
  cut(1'764'000'000 * SECOND);
  EXPECT_TRUE(has(look(4), "is it wall time, while the clock is simulated?"));
}

TEST_F(PaceWatchTest, SaysWhatHasNoTransform) {
  cut(1020 * SECOND);
  commands_.add({ToolPose{0, {}}, "nowhere", 0, START - seconds(1)});
  const std::string warning = look(4);
  EXPECT_TRUE(has(warning, "a pose of the tool 'tool' has waited 5 s for the transform of its frame \"nowhere\""))
      << warning;
  EXPECT_TRUE(has(warning, "with it 1 more wait")) << warning;
}

TEST(PaceWatch, SaysWhereNoClockHasCome) {
  FramesInTests frames;
  AnswersInTests answers;
  Wakeup wakeup;
  ClockPacer pacer(0.01, 1);
  Commands commands({{}, true, 1}, frames, answers, wakeup);
  commands.add({PlaneCut(), "body", 1, START});
  PaceWatch(pacer, commands, answers).look(START + seconds(4));
  ASSERT_EQ(1u, answers.warnings.size());
  EXPECT_NE(std::string::npos, answers.warnings[0].find("no /clock has come yet")) << answers.warnings[0];
}

}  // namespace
}  // namespace incision

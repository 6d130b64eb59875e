#include "incision/pace/agenda.h"

#include <gtest/gtest.h>

#include "pace/things_in_tests.h"

namespace incision {
namespace {

ReceivedPose receivedAt(double x) { return {{Vec3(x, 0, 0), Eigen::Quaterniond::Identity()}, 1, SteadyTime()}; }

TEST(Agenda, CommandsComeInTheOrderOfStampsThenOfArrival) {
  Agenda agenda(1);
  agenda.add(labelled("c"), 20);
  agenda.add(labelled("a"), 10);
  agenda.add(labelled("b"), 10);
  std::string labels;
  for (const WaitingCut& cut : agenda.takeCuts(20)) labels += cut.plane.label;
  EXPECT_EQ("abc", labels);
}

TEST(Agenda, WhatIsStampedLaterWaits) {
  Agenda agenda(1);
  agenda.add(labelled("later"), 30);
  EXPECT_TRUE(agenda.takeCuts(29).empty());
  EXPECT_EQ(1u, agenda.takeCuts(30).size());
}

TEST(Agenda, AStampThatIsPassedCountsAsLateAndNowDoesNot) {
  Agenda agenda(1);
  agenda.takeCuts(100);
  agenda.add(labelled("now"), 0);
  agenda.add(labelled("in time"), 101);
  EXPECT_EQ(0u, agenda.late());
  agenda.add(0, receivedAt(0), 100);
  EXPECT_EQ(1u, agenda.late());
}

TEST(Agenda, AFullAgendaPutsOutTheLatestCut) {
  Agenda agenda(1);
  agenda.add(labelled("far future"), 1'000'000'000);
  for (std::size_t i = 1; i < MAX_WAITING_CUTS; ++i) EXPECT_FALSE(agenda.add(labelled("near"), 10));
  EXPECT_EQ("far future", agenda.add(labelled("near"), 10)->label);
  EXPECT_EQ(MAX_WAITING_CUTS, agenda.takeCuts(10).size());
}

TEST(Agenda, ALongPathKeepsItsShape) {
  Agenda agenda(1);
  const int count = 3 * MAX_WAITING_POSES;
  for (int i = 0; i < count; ++i) agenda.add(0, receivedAt(i), 0);
  const std::vector<ReceivedPose> path = agenda.takeTool(0, 0).poses;
  EXPECT_LE(path.size(), MAX_WAITING_POSES);
  EXPECT_EQ(count, static_cast<int>(path.size() + agenda.thinned()));
  EXPECT_EQ(0, path.front().pose.position.x());
  EXPECT_EQ(count - 1, path.back().pose.position.x());
  for (std::size_t i = 1; i < path.size(); ++i) EXPECT_LE(path[i].pose.position.x() - path[i - 1].pose.position.x(), 8);
}

TEST(Agenda, KnowsHowManyWaitAndSinceWhen) {
  const auto after = [](int seconds) { return SteadyTime(std::chrono::seconds(seconds)); };
  Agenda agenda(2);
  EXPECT_EQ(0u, agenda.size());
  agenda.add(labelled("now"), 0, after(1));
  agenda.add(labelled("later"), 90, after(3));
  agenda.add(labelled("earlier"), 80, after(4));
  agenda.add(1, ReceivedPose{{}, 70, after(6)}, 70);
  agenda.add(1, ReceivedAngle{0.1, 60, after(5)}, 60);
  EXPECT_EQ(5u, agenda.size());
  EXPECT_EQ("later", agenda.firstCutAfter(0)->plane.label);
  EXPECT_EQ(90, agenda.firstCutAfter(0)->stamp);
  EXPECT_FALSE(agenda.firstCutAfter(90));
  EXPECT_FALSE(agenda.firstOfToolAfter(0, 0));
  EXPECT_EQ(after(5), agenda.firstOfToolAfter(1, 0)->received);
  EXPECT_EQ(70, agenda.firstOfToolAfter(1, 60)->stamp);
  agenda.clearTools();
  EXPECT_EQ(3u, agenda.size());
}

TEST(Agenda, GivesTheCutsThatWillNotBeMadeOneByOne) {
  Agenda agenda(1);
  agenda.add(labelled("later"), 60);
  agenda.add(labelled("earlier"), 50);
  agenda.add(0, receivedAt(0), 50);
  agenda.clearTools();
  EXPECT_TRUE(agenda.takeTool(0, 50).poses.empty());
  EXPECT_EQ("earlier", agenda.takeCut()->plane.label);
  EXPECT_EQ("later", agenda.takeCut()->plane.label);
  EXPECT_FALSE(agenda.takeCut());
}

TEST(Agenda, TheBladeIsOnUntilItIsSwitchedAndAfterClearing) {
  Agenda agenda(1);
  EXPECT_TRUE(agenda.takeTool(0, 0).active);
  agenda.activate(0, false);
  EXPECT_FALSE(agenda.takeTool(0, 0).active);
  agenda.clearTools();
  EXPECT_TRUE(agenda.takeTool(0, 0).active);
}

TEST(Agenda, ASwitchOfTheBladeComesBetweenThePosesBeforeAndAfterIt) {
  Agenda agenda(1);
  agenda.add(0, receivedAt(1), 0);
  agenda.activate(0, false);
  agenda.add(0, receivedAt(2), 0);
  agenda.activate(0, true);
  const ToolInput input = agenda.takeTool(0, 0);
  ASSERT_EQ(2u, input.poses.size());
  EXPECT_TRUE(input.poses[0].active);
  EXPECT_FALSE(input.poses[1].active);
  EXPECT_TRUE(input.active);
}

TEST(Agenda, ASwitchOfTheBladeWaitsWithThePoseBeforeIt) {
  Agenda agenda(1);
  agenda.add(0, receivedAt(1), 30);
  agenda.activate(0, false);
  EXPECT_TRUE(agenda.takeTool(0, 29).active);
  EXPECT_FALSE(agenda.takeTool(0, 30).active);
}

TEST(Agenda, WhatIsAskedOfOneToolIsNotAskedOfAnother) {
  Agenda agenda(2);
  agenda.add(1, receivedAt(1), 0);
  agenda.activate(0, false);
  agenda.add(1, receivedAt(2), 0);
  const ToolInput first = agenda.takeTool(0, 0), second = agenda.takeTool(1, 0);
  EXPECT_TRUE(first.poses.empty());
  EXPECT_FALSE(first.active);
  ASSERT_EQ(2u, second.poses.size());
  EXPECT_TRUE(second.poses[1].active);
  EXPECT_TRUE(second.active);
}

}  // namespace
}  // namespace incision

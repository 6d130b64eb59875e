#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "incision/base/archive.h"
#include "incision/base/input_error.h"
#include "incision/pace/jaw_tracker.h"
#include "incision/pace/link_tracker.h"
#include "incision/pace/tool_tracker.h"
#include "pace/frames_in_tests.h"
#include "pace/things_in_tests.h"

namespace incision {
namespace {

constexpr Nanoseconds STEP = 10 * MILLISECOND, FIRST = SECOND;
constexpr int STEPS = 400;

/// As it comes back from a file.
template <class Memory>
Memory savedAndRead(Memory memory) {
  std::ostringstream out;
  ArchiveWriter writer(out);
  writer(memory);
  const std::string bytes = out.str();
  ArchiveReader reader(bytes);
  Memory read;
  reader(read);
  check(read, MemoryLimits());
  EXPECT_EQ(reader.left(), 0u);
  return read;
}

/// Poses as from a hand that sometimes pauses, jumps, switches the blade, or is slower or faster than steps.
std::vector<ToolInput> poseStream(unsigned seed) {
  std::mt19937 random(seed);
  const auto oneOf = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  std::vector<ToolInput> inputs(STEPS);
  double x = 0;
  bool active = true;
  for (Nanoseconds time = 0; time < STEPS * STEP;) {
    time += oneOf(30) == 0 ? 700 * MILLISECOND
                           : (1 + oneOf(45)) * MILLISECOND;  // beyond the tool's timeout, or about a step
    x += oneOf(20) == 0 ? 0.5 : 1e-3 * oneOf(60);            // a jump, or a part of the way
    if (oneOf(15) == 0) active = !active;
    const auto step = static_cast<std::size_t>((time + STEP - 1) / STEP);
    if (step < inputs.size()) inputs[step].poses.push_back({poseAt(x), FIRST + time, SteadyTime(), active});
  }
  for (std::size_t i = 0; i < inputs.size(); ++i)
    inputs[i].active = !inputs[i].poses.empty() ? inputs[i].poses.back().active : i == 0 || inputs[i - 1].active;
  return inputs;
}

void expectSame(const ToolMove& move, const ToolMove& expected) {
  EXPECT_EQ(move.active, expected.active);
  EXPECT_TRUE(move.placed == expected.placed);
  EXPECT_TRUE(move.path == expected.path);
  EXPECT_EQ(move.jump, expected.jump);
  EXPECT_EQ(move.went_stale, expected.went_stale);
  EXPECT_EQ(move.came_again, expected.came_again);
}

ToolTracker toolTracker() { return {ToolSettings(), {Vec3::Zero(), Vec3(0, 0, 0.05)}, TIME_STEP}; }

TEST(TrackerMemory, AToolTrackerRecalledIsAsIfNeverKept) {
  int stale = 0, waited = 0, on_the_way = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const std::vector<ToolInput> inputs = poseStream(seed);
    ToolTracker never = toolTracker(), again = toolTracker();
    for (int i = 0; i < STEPS; ++i) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(i));
      const ToolMove expected = never.follow(inputs[static_cast<std::size_t>(i)], FIRST + i * STEP, false);
      expectSame(again.follow(inputs[static_cast<std::size_t>(i)], FIRST + i * STEP, false), expected);
      const ToolTrackerMemory memory = savedAndRead(again.keep());
      again.restart();
      again.recall(memory);
      stale += static_cast<int>(memory.stale);
      waited += static_cast<int>(!memory.waiting.empty());
      on_the_way += static_cast<int>(!memory.way.empty());
    }
  }
  EXPECT_GT(stale, 0);
  EXPECT_GT(waited, 0);
  EXPECT_GT(on_the_way, 0);
}

/// A branch may be recalled at any time later, on any clock.
TEST(TrackerMemory, AToolTrackersPosesAreAsOldAsWhenTheyWereKept) {
  ToolTracker kept = toolTracker();
  kept.follow({{{poseAt(0), FIRST, SteadyTime(), true}}}, FIRST, false);
  kept.follow({{{poseAt(0.05), FIRST + 50 * MILLISECOND, SteadyTime(), true}}}, FIRST + 50 * MILLISECOND, false);
  for (const Nanoseconds later : {Nanoseconds{0}, 3000 * MILLISECOND, 1'000'000 * MILLISECOND}) {
    ToolTracker tracker = toolTracker();
    tracker.recall(kept.keep());
    for (int i = 1; i <= 4; ++i) {
      const ToolMove move = tracker.follow({}, FIRST + later + i * STEP, false);
      ASSERT_EQ(move.path.size(), 1u);
      EXPECT_NEAR(move.path[0].position.x(), 0.01 * (1 + i), 1e-14);
    }
    EXPECT_FALSE(tracker.stale());
  }
}

TEST(TrackerMemory, AToolLedByNobodyYetGoesOnFromWhereItStands) {
  ToolTracker tracker = toolTracker();
  tracker.restart(poseAt(0.3));
  EXPECT_TRUE(tracker.stale());
  const ToolMove move = tracker.follow({{{poseAt(0.31), FIRST, SteadyTime(), true}}}, FIRST, false);
  EXPECT_FALSE(move.placed);
  ASSERT_EQ(move.path.size(), 1u);
  EXPECT_TRUE(move.came_again);
}

TEST(TrackerMemory, AJawTrackerRecalledIsAsIfNeverKept) {
  std::mt19937 random(1);
  JawTracker never(TIME_STEP), again(TIME_STEP);
  for (int i = 0; i < STEPS; ++i) {
    std::vector<ReceivedAngle> angles;
    if (random() % 4 == 0) angles.push_back({1e-3 * static_cast<double>(random() % 1000), FIRST + i * STEP});
    EXPECT_EQ(again.follow(angles, FIRST + i * STEP, false), never.follow(angles, FIRST + i * STEP, false)) << i;
    const JawTrackerMemory memory = savedAndRead(again.keep());
    again.restart();
    again.recall(memory);
  }
}

TEST(TrackerMemory, ALinkTrackerRecalledIsAsIfNeverKept) {
  FramesInTests frames;
  const auto tracker = [&] {
    return LinkTracker(LinkLookup(frames, [](const std::string&, const std::string&) {}), {{"arm", poseAt(1)}, {"rib"}},
                       TIME_STEP);
  };
  std::mt19937 random(1);
  LinkTracker never = tracker(), again = tracker();
  int moved = 0;
  for (int i = 0; i < STEPS; ++i) {
    for (const char* name : {"arm", "rib"})
      if (random() % 5 == 0) frames.set(name, FIRST + i * STEP, poseAt(random() % 10 == 0 ? 5 : 1 + 1e-4 * i));
    const std::vector<LinkMove> expected = never.follow(FIRST + i * STEP, 0), moves = again.follow(FIRST + i * STEP, 0);
    ASSERT_EQ(moves.size(), expected.size()) << i;
    for (std::size_t k = 0; k < moves.size(); ++k) {
      EXPECT_EQ(moves[k].link, expected[k].link);
      EXPECT_TRUE(moves[k].pose == expected[k].pose);
      EXPECT_EQ(moves[k].at_once, expected[k].at_once);
      ++moved;
    }
    const std::vector<FollowedLinkMemory> memory = savedAndRead(again.keep());
    again.restart();
    again.recall(memory);
  }
  EXPECT_GT(moved, STEPS / 2);
}

template <class Memory>
void expectRefused(Memory memory) {
  EXPECT_THROW(savedAndRead(std::move(memory)), InputError);
}

TEST(TrackerMemory, WhatNoTrackerCanRememberIsRefused) {
  ToolTrackerMemory tool;
  tool.age = -1;
  expectRefused(tool);
  tool = ToolTrackerMemory();
  tool.pose.orientation.w() = 3;
  expectRefused(tool);
  JawTrackerMemory jaw;
  jaw.approach.aim(0.05, TIME_STEP);  // to no angle
  expectRefused(jaw);
  FollowedLinkMemory link;
  link.age = std::numeric_limits<Nanoseconds>::max();
  expectRefused(std::vector<FollowedLinkMemory>{link});
}

}  // namespace
}  // namespace incision

#include <rosgraph_msgs/Clock.h>

#include <cmath>
#include <map>

#include "bag_run.h"
#include "incision/body/quantities.h"

namespace incision {
namespace {

TEST_F(BagRun, ACutIsThatOfTheBatchProgramAtItsStamp) {
  writeCut("cut.bag");
  const Json line = summaryOf("cut.bag", "plain.yaml", {"--record", file("bag.csv")});
  EXPECT_EQ(11, line["steps"]);
  EXPECT_EQ(1, line["bag"]["cuts_applied"]);
  EXPECT_EQ(1, line["bag"]["messages"]);
  EXPECT_EQ(0, line["bag"]["late_commands"]);
  ASSERT_EQ(run({file("plain.yaml"), "--steps", "11", "--set",
                 "cuts=[{time: 0.02, label: half, point: [0.6, 0, 0], normal: [1, 0, 0]}]"}),
            BatchStatus::DONE)
      << err_.str();
  EXPECT_EQ(Json::parse(out_.str())["state_hash"], line["state_hash"]);
  const std::string last = lines("bag.csv").back();
  EXPECT_EQ(line["state_hash"], last.substr(last.rfind(',') + 1));
}

TEST_F(BagRun, CompressedBagsAreReadToo) {
  writeCut("plain.bag");
  writeCut("bz2.bag", rosbag::compression::BZ2);
  writeCut("lz4.bag", rosbag::compression::LZ4);
  const std::string hash = hashOf("plain.bag");
  EXPECT_EQ(hash, hashOf("bz2.bag"));
  EXPECT_EQ(hash, hashOf("lz4.bag"));
}

TEST_F(BagRun, ACutThatComesWithinTheClocksDelayIsInTimeAndLaterOnesAreLate) {
  for (const double delay : {0.05, 0.07}) {
    {
      rosbag::Bag bag(file("late.bag"), rosbag::bagmode::Write);
      lasting(bag, 0.2);
      bag.write("/incision/cut_plane", at(0.02 + delay), across(0.6, 0.02, "half"));
    }
    EXPECT_EQ(delay == 0.05 ? 0 : 1, summaryOf("late.bag")["bag"]["late_commands"]) << delay;
  }
}

TEST_F(BagRun, WhereTheBagHasAClockStepsGoByIt) {
  {
    rosbag::Bag bag(file("clock.bag"), rosbag::bagmode::Write);
    for (int i = 0; i <= 20; ++i) {
      rosgraph_msgs::Clock clock;
      clock.clock = ros::Time(5 + 0.01 * i);
      bag.write("/clock", at(0.02 * i), clock);
    }
    CutPlane plane = across(0.6, 0, "half");
    plane.header.stamp = ros::Time(5.015);
    bag.write("/incision/cut_plane", at(0.03), plane);
  }
  writeCut("cut.bag");
  const Json line = summaryOf("clock.bag");
  EXPECT_EQ(21, line["steps"]);
  EXPECT_EQ(summaryOf("clock.bag", "plain.yaml", {"--steps", "11"})["state_hash"], hashOf("cut.bag"));
}

TEST_F(BagRun, EveryCutIsAnswered) {
  {
    rosbag::Bag bag(file("answers.bag"), rosbag::bagmode::Write);
    lasting(bag, 4);
    const auto write = [&](const CutPlane& plane) { bag.write("/incision/cut_plane", at(0.5), plane); };
    write(across(0.6, 0.6, "applied"));
    write(across(9, 0.6, "beside"));
    write(across(0.6, 0.6, "nowhere", "nowhere"));
    write(across(0.6, 1e6, "far"));
    CutPlane bad = across(0.6, 0.6, "bad");
    bad.normal.x = 0;
    write(bad);
  }
  const Json line = summaryOf("answers.bag"), counts = line["bag"];
  EXPECT_EQ(1, counts["cuts_applied"]);
  EXPECT_EQ(1, counts["cuts_missed"]);
  EXPECT_EQ(3, counts["cuts_rejected"]);
  std::map<std::string, std::string> answers;
  for (const Json& cut : line["cuts"]) answers[cut["label"]] = cut["status"];
  EXPECT_EQ(answers, (std::map<std::string, std::string>{{"applied", "applied"},
                                                         {"beside", "missed"},
                                                         {"nowhere", "rejected"},
                                                         {"far", "rejected"},
                                                         {"bad", "rejected"}}));
  EXPECT_EQ(runBag({file("answers.bag"), file("plain.yaml"), "--strict"}), BatchStatus::CUT_MISSED);
  for (const char* said : {"cut 'beside' at 0.6 s missed", "cut 'nowhere' at ", "cut 'bad' at 0.4",
                           "cut 'far' at 4.01 s was rejected: the run has ended"})
    EXPECT_NE(err_.str().find(said), std::string::npos) << said << " in\n" << err_.str();
  EXPECT_NE(err_.str().find("is it wall time"), std::string::npos) << err_.str();
}

// The first step is taken while the clock stands still before the first message, as with `rosbag play`.
TEST_F(BagRun, WhatWasSetAnewTakesEffect) {
  const auto update = [](const char* name, double value) {
    dynamic_reconfigure::Config config;
    config.doubles.resize(1);
    config.doubles[0].name = name;
    config.doubles[0].value = value;
    return config;
  };
  {
    rosbag::Bag bag(file("set.bag"), rosbag::bagmode::Write);
    lasting(bag, 0.1);
    bag.write("/incision/cut_plane", at(0.015), across(9, 0.015, "beside"));
    bag.write("/incision/parameter_updates", at(0), update("gravity_y", 7));
    bag.write("/incision/parameter_updates", at(0.05), update("tolerance", 1));
  }
  const Json line = summaryOf("set.bag");
  EXPECT_NE(err_.str().find("tolerance: '1' (allowed: "), std::string::npos) << err_.str();
  const Scene scene = loadScene(file("plain.yaml"));
  DeformableBody body(scene, loadMesh(scene));
  body.step();
  LiveSettings settings = body.live();
  settings.gravity.y() = 7;
  body.set(settings);
  while (body.steps() < line["steps"].get<int>()) body.step();
  EXPECT_EQ(line["state_hash"], hexadecimal(body.stateHash()));
}

TEST_F(BagRun, FramesToolsJawsAndSwitchesAreFollowed) {
  writeAll("all.bag");
  const Json line = summaryOf("all.bag", "tools.yaml");
  EXPECT_EQ(121, line["bag"]["messages"]);
  EXPECT_GT(line["tools"]["knife"]["area"].get<double>(), 0.02);
  EXPECT_GT(line["tools"]["forceps"]["jaw"].get<double>(), 0.25);
  EXPECT_GT(line["max_displacement"].get<double>(), 0.02);  // with the clamp
  EXPECT_EQ(0, line["bag"]["ignored_transforms"]);
  EXPECT_EQ(0, line["bag"]["late_commands"]);
}

TEST_F(BagRun, ARestoredBodyIsLedOnAsIfItHadNeverBeenSaved) {
  const auto write = [&](const std::string& name, int first, int last) {
    rosbag::Bag bag(file(name), rosbag::bagmode::Write);
    for (int i = first; i <= last; ++i) {
      const double time = 0.01 * i;
      rosgraph_msgs::Clock clock;
      clock.clock = at(time);
      bag.write("/tf", at(time), message(frame("hand", time + 0.01, 1e-3 * i)));
      geometry_msgs::PoseStamped pose;
      pose.header.stamp = at(time);
      pose.pose.position.x = 0.6;
      pose.pose.position.y = -0.05 + 0.01 * i;
      pose.pose.orientation.w = 1;
      if (i % 3 == 0) bag.write("/incision/knife/servo_cp", at(time), pose);
      bag.write("/clock", at(time), clock);
    }
  };
  write("whole.bag", 0, 30);
  write("first.bag", 0, 15);
  write("second.bag", 16, 30);
  const Json whole = summaryOf("whole.bag", "tools.yaml");
  EXPECT_EQ(16, summaryOf("first.bag", "tools.yaml", {"--save", file("half.state")})["steps"]);
  const Json second = summaryOf("second.bag", "tools.yaml", {"--restore", file("half.state")});
  EXPECT_EQ(31, second["steps"]);
  EXPECT_EQ(whole["state_hash"], second["state_hash"]);
  EXPECT_GT(whole["tools"]["knife"]["area"].get<double>(), 0.02);
}

TEST_F(BagRun, TransformsOfNoUseAreSaidAndChangeNothing) {
  writeAll("good.bag");
  writeAll("odd.bag");
  {
    rosbag::Bag bag(file("odd.bag"), rosbag::bagmode::Append);
    geometry_msgs::TransformStamped odd = frame("hand", 0.1, 1);
    odd.transform.rotation.w = 2;
    bag.write("/tf", at(0.1), message(odd));
    odd.transform.translation.x = std::nan("");
    bag.write("/tf", at(0.1), message(odd));
    bag.write("/tf", at(0.1), message(frame("", 0.1, 1)));
    bag.write("/tf", at(0.3), message(frame("hand", -20, 1)));
  }
  const Json good = summaryOf("good.bag", "tools.yaml"), odd = summaryOf("odd.bag", "tools.yaml");
  EXPECT_EQ(good["state_hash"], odd["state_hash"]);
  EXPECT_NE(err_.str().find("tf takes no transform of \"hand\" in \"body\" stamped 1000.1"), std::string::npos)
      << err_.str();
}

TEST_F(BagRun, TheNodeMayHaveAnotherName) {
  writeAll("ours.bag");
  writeAll("other.bag", "/a/b");
  const Json ours = summaryOf("ours.bag", "tools.yaml");
  for (const char* name : {"/a/b", "a/b/"})
    EXPECT_EQ(ours["state_hash"], summaryOf("other.bag", "tools.yaml", {"--node", name})["state_hash"]);
}

}  // namespace
}  // namespace incision

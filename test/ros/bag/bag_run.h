#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <gtest/gtest.h>
#include <incision/CutPlane.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "incision/ros/bag/bag_steps.h"
#include "support/batch_folder.h"

namespace incision {

using Json = nlohmann::json;

/// A folder of scenes and bags, and the program that runs these.
class BagRun : public BatchFolder {
 protected:
  static constexpr double START = 1000;  ///< [s] of the bags, a multiple of the time step

  void SetUp() override {
    BatchFolder::SetUp();
    std::ofstream(file("tools.yaml")) << R"(
body: {grid: {cells: [4, 1, 1], size: [1, 0.25, 0.25]}}
boundary: [{box: [[-1, -1, -1], [1.0e-6, 1, 1]], frame: hand}]
solver: {method: direct, threads: 1}
contact: {friction: 0.3}
tools:
  knife: {type: blade, edge: [[0, 0, -0.5], [0, 0, 0.5]]}
  forceps: {type: grasper, description: package://incision/config/forceps.urdf, link: palm, joint: jaw, closed: 0.1, grip: 5}
)";
    std::ofstream(file("plain.yaml")) << "body: {grid: {cells: [4, 1, 1], size: [1, 0.25, 0.25]}}\n"
                                         "boundary: [{box: [[-1, -1, -1], [1.0e-6, 1, 1]]}]\n"
                                         "solver: {method: direct, threads: 1}\n";
  }

  BatchStatus runBag(const std::vector<std::string>& arguments) {
    out_.str("");
    err_.str("");
    return runProgram(BAG, arguments, out_, err_);
  }
  /// Runs the bag through a scene that it fits, and returns what the summary says.
  Json summaryOf(const std::string& bag, const std::string& scene = "plain.yaml",
                 const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {file(bag), file(scene)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(runBag(arguments), BatchStatus::DONE) << err_.str();
    return Json::parse(out_.str());
  }
  std::string hashOf(const std::string& bag) { return summaryOf(bag)["state_hash"]; }

  std::string bytesOf(const std::string& bag) const {
    std::ifstream whole(file(bag), std::ios::binary);
    return {std::istreambuf_iterator<char>(whole), {}};
  }

  static ros::Time at(double time) { return ros::Time(START) + ros::Duration(time); }

  static CutPlane across(double x, double stamp, const std::string& label, const std::string& frame = "body") {
    CutPlane plane;
    plane.header.frame_id = frame;
    plane.header.stamp = at(stamp);
    plane.label = label;
    plane.point.x = x;
    plane.normal.x = 1;
    return plane;
  }
  static geometry_msgs::TransformStamped frame(const std::string& name, double stamp, double x) {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = "body";
    transform.header.stamp = at(stamp);
    transform.child_frame_id = name;
    transform.transform.translation.x = x;
    transform.transform.rotation.w = 1;
    return transform;
  }
  static tf2_msgs::TFMessage message(const geometry_msgs::TransformStamped& transform) {
    tf2_msgs::TFMessage message;
    message.transforms = {transform};
    return message;
  }
  /// A message that is for nothing in any scene, so that the bag lasts from 0 to `end` [s].
  static void lasting(rosbag::Bag& bag, double end) {
    for (const double time : {0.0, end}) bag.write("/other", at(time), std_msgs::String());
  }

  /// One cut half a step before the third step.
  void writeCut(const std::string& name, rosbag::CompressionType compression = rosbag::compression::Uncompressed) {
    rosbag::Bag bag(file(name), rosbag::bagmode::Write);
    bag.setCompression(compression);
    lasting(bag, 0.1);
    bag.write("/incision/cut_plane", at(0.015), across(0.6, 0.015, "half"));
  }

  /// Messages of all kinds for tools.yaml.
  void writeAll(const std::string& name, const std::string& node = "/incision") {
    rosbag::Bag bag(file(name), rosbag::bagmode::Write);
    const auto time = [](int i) { return at(0.01 * i); };
    bag.write("/other", time(0), std_msgs::String());
    for (int i = 1; i <= 30; ++i) {
      tf2_msgs::TFMessage frames;
      frames.transforms.resize(1);
      frames.transforms[0].header.frame_id = "body";
      frames.transforms[0].header.stamp = time(i);
      frames.transforms[0].child_frame_id = "hand";
      frames.transforms[0].transform.translation.x = 1e-3 * i;
      frames.transforms[0].transform.rotation.w = 1;
      bag.write("/tf", time(i), frames);
      geometry_msgs::PoseStamped pose;
      pose.header.stamp = time(i);
      pose.pose.position.x = 0.6;
      pose.pose.position.y = -0.05 + 0.01 * i;
      pose.pose.orientation.w = 1;
      bag.write(node + "/knife/servo_cp", time(i), pose);
      pose.pose.position.x = 3;
      bag.write(node + "/forceps/servo_cp", time(i), pose);
      sensor_msgs::JointState jaw;
      jaw.header.stamp = time(i);
      jaw.position = {0.01 * i};
      bag.write(node + "/forceps/jaw/servo_jp", time(i), jaw);
    }
    std_msgs::Bool active;
    active.data = 0;
    bag.write(node + "/knife/active", at(0.255), active);
  }
};

}  // namespace incision

#pragma once

#include <ros/node_handle.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "incision/pace/command.h"
#include "incision/ros/demo/tool_path.h"
#include "incision/ros/demo/tool_pose_publisher.h"

namespace incision {

/// The private parameters of incision_scalpel.
struct ScalpelSettings {
  std::string frame = "body";        ///< ~frame of the path
  std::string tool_frame = "blade";  ///< ~tool_frame in tf
  std::vector<Waypoint> path;        ///< ~path: poses [x, y, z, roll, pitch, yaw], m and rad; ~jaw; ~leg_times
  bool has_jaw = false;              ///< ~jaw is given: angles are published, too
  double speed = 0.05;               ///< ~speed [m/s] above 0 … 100
  double rate = 100;                 ///< ~rate [Hz] 1 … 20000: poses a second
  bool loop = false;                 ///< ~loop: from the last waypoint on to the first
};

/// Throws InputError with parameter, value and what is allowed.
ScalpelSettings loadScalpelSettings(const ros::NodeHandle& node);

/// Leads a tool along a path: waits for a subscriber, then publishes poses at an exact mean rate, and repeats the last
/// one, so that whoever follows knows that the tool is still there. ~done says whether the path is through.
class Scalpel {
 public:
  Scalpel(ros::NodeHandle& node, const ScalpelSettings& settings);

  /// Until ROS ends.
  void run();

 private:
  void publishDue(Nanoseconds now);
  Nanoseconds afterStart(std::int64_t pose) const;
  void publishNext();
  void publishJaw(double angle, const ros::Time& stamp);
  void publishDone(bool done);

  const ScalpelSettings settings_;
  const ToolPath path_;
  ToolPosePublisher publisher_;
  ros::Publisher jaw_publisher_;  ///< of a tool that has one
  ros::Publisher done_publisher_;
  bool done_ = false;
  std::optional<Nanoseconds> start_;  ///< of the path; none: nobody has listened yet
  std::int64_t count_ = 0;            ///< poses published
};

}  // namespace incision

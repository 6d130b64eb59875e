#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <incision/CutPlane.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/Bool.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <string>
#include <vector>

#include "incision/pace/agenda.h"
#include "incision/pace/transform_queue.h"
#include "incision/pace/wakeup.h"
#include "incision/ros/parameters.h"
#include "incision/ros/reporter.h"
#include "incision/ros/tf_frames.h"
#include "incision/ros/validation.h"

namespace incision {

/// Messages that may wait to be looked at. At a thousand messages a second it takes this thread a stall of more than a
/// second to lose one.
inline constexpr std::uint32_t MESSAGE_QUEUE = 1000;

/// How often commands that wait for a transform try again [s].
inline constexpr double TRANSFORM_POLL = 0.01;

/// Receives the commands on a thread of its own: checks each, brings it into the body's frame and puts it on the
/// agenda. The stepping thread never sees a message that is no command.
class CommandInput {
 public:
  CommandInput(ros::NodeHandle& node, const NodeSettings& settings, const DeformableBody& body, Agenda& agenda,
               Reporter& reporter, Wakeup& wakeup);

  /// A command stamped at or before `time` still waits for its transform.
  bool waitsFor(Nanoseconds time) const;

  /// What the node knows of tf.
  const Frames& frames() const { return frames_; }

  /// Refuses the commands that wait for a transform.
  void clear(const Refused& refused);

 private:
  void receiveCut(const CutPlane& message);
  void receivePose(int tool, const geometry_msgs::PoseStamped& message);
  void receiveJaw(int tool, const Jaw& jaw, const sensor_msgs::JointState& message);
  template <class Message, class Receive>
  void subscribe(ros::NodeHandle& node, const std::string& topic, Receive receive);
  void subscribeToTool(ros::NodeHandle& node, int tool, const ToolSettings& settings, const ToolForm& form);
  Nanoseconds timeOf(Nanoseconds stamp, SteadyTime received) const;
  void accept(const Command& command);
  void release(const Command& command);
  void refuse(const Command& command, const Refused& refused);

  const bool use_sim_time_;
  const std::string body_frame_;
  Agenda& agenda_;
  Reporter& reporter_;
  Wakeup& wakeup_;

  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  const TfFrames frames_;
  TransformQueue transforms_;
  ros::CallbackQueue callbacks_;
  std::vector<ros::Subscriber> subscribers_;
  ros::WallTimer poll_;
  ros::AsyncSpinner spinner_;  ///< last: its thread uses all of the above
};

}  // namespace incision

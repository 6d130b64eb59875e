#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <string>
#include <vector>

#include "incision/pace/commands.h"
#include "incision/ros/command_messages.h"
#include "incision/ros/parameters.h"
#include "incision/ros/tf_frames.h"

namespace incision {

/// Messages that may wait to be looked at. At a thousand messages a second it takes this thread a stall of more than a
/// second to lose one.
inline constexpr std::uint32_t MESSAGE_QUEUE = 1000;

/// How often commands that wait for a transform try again [s].
inline constexpr double TRANSFORM_POLL = 0.01;

/// Receives the commands on a thread of its own: checks each, brings it into the body's frame and keeps it until its
/// step. The stepping thread never sees a message that is no command.
class CommandInput {
 public:
  CommandInput(ros::NodeHandle& node, const NodeSettings& settings, const DeformableBody& body, Answers& answers,
               Wakeup& wakeup);

  /// What has been received.
  Commands& commands() { return commands_; }

  /// What the node knows of tf.
  const Frames& frames() const { return frames_; }

  /// Receives no more. What has come is looked at; then the cuts that wait are refused.
  void close(const Refused& refused);

 private:
  template <class Message>
  void subscribe(ros::NodeHandle& node, const std::string& topic, const Receiver<Message>& receive);

  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  const TfFrames frames_;
  Commands commands_;
  CommandMessages messages_;
  ros::CallbackQueue callbacks_;
  std::vector<ros::Subscriber> subscribers_;
  ros::WallTimer poll_;
  ros::AsyncSpinner spinner_;  ///< last: its thread uses all of the above
};

}  // namespace incision

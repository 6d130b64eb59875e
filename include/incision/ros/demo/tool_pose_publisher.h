#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <ros/node_handle.h>
#include <tf2_ros/transform_broadcaster.h>

#include <string>

namespace incision {

/// Says where a tool is: on ~pose, and as a frame of tf, in which rviz shows the wrench on it.
class ToolPosePublisher {
 public:
  /// `queue`: poses that may wait for a slow subscriber.
  ToolPosePublisher(ros::NodeHandle& node, std::string tool_frame, std::uint32_t queue);

  std::string topic() const { return poses_.getTopic(); }
  bool hasSubscribers() const { return poses_.getNumSubscribers() > 0; }

  /// Each pose goes to the topic, up to a hundred a second to tf.
  void publish(const geometry_msgs::PoseStamped& pose);

 private:
  const std::string tool_frame_;
  ros::Publisher poses_;
  tf2_ros::TransformBroadcaster transforms_;
  ros::Time last_transform_;
};

}  // namespace incision

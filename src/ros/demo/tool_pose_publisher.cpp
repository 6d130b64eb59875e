#include "incision/ros/demo/tool_pose_publisher.h"

#include <utility>

namespace incision {
namespace {

/// Least time [s] between transforms, and far more than rviz needs. tf complains of two with the same stamp.
constexpr double TRANSFORM_PERIOD = 0.01;

/// A pose a period later by the grid of its stamps may be a rounding error earlier.
constexpr double EARLY = 1e-6;

}  // namespace

ToolPosePublisher::ToolPosePublisher(ros::NodeHandle& node, std::string tool_frame, std::uint32_t queue)
    : tool_frame_(std::move(tool_frame)), poses_(node.advertise<geometry_msgs::PoseStamped>("pose", queue)) {}

void ToolPosePublisher::publish(const geometry_msgs::PoseStamped& pose) {
  poses_.publish(pose);
  const double since = (pose.header.stamp - last_transform_).toSec();
  if (since >= 0 && since < TRANSFORM_PERIOD - EARLY) return;
  last_transform_ = pose.header.stamp;
  geometry_msgs::TransformStamped transform;
  transform.header = pose.header;
  transform.child_frame_id = tool_frame_;
  transform.transform.translation.x = pose.pose.position.x;
  transform.transform.translation.y = pose.pose.position.y;
  transform.transform.translation.z = pose.pose.position.z;
  transform.transform.rotation = pose.pose.orientation;
  transforms_.sendTransform(transform);
}

}  // namespace incision

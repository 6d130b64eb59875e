#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <incision/ToolState.h>
#include <ros/node_handle.h>
#include <sensor_msgs/JointState.h>

#include <string>

#include "incision/pace/tool_guide.h"
#include "incision/ros/publishing_thread.h"

namespace incision {

/// Publishes of one of the body's tools, in the words of the collaborative robotics toolkit, where it is
/// (`measured_cp`, `jaw/measured_js`) and what it feels (`measured_cf`): force and torque of the tissue on the tool,
/// the torque about the origin of the tool's link, both in the frame of that link. A tool that presses down on tissue
/// is pushed up. Used by the stepping thread.
class ToolPublisher {
 public:
  /// `tool`: its index in the scene.
  ToolPublisher(ros::NodeHandle& node, std::size_t tool, const Scene& scene, PublishingThread* thread);

  /// Right after a step: where the tool is and what it feels, while it is in place. What it feels has a stamp of zero
  /// where it is not valid: once when its pose has gone stale, or when it has been taken away, and none until a pose
  /// comes.
  void publish(const StepResult& step, const DeformableBody& body, const ToolGuide& guide);

  /// The tool has been taken away.
  void restart();

  /// What is known of the tool, but for the messages refused.
  ToolState state(const StepResult& step, const DeformableBody& body, const ToolGuide& guide) const;

 private:
  const ToolReport& reportIn(const StepResult& step) const;
  void publishPose(const Pose& pose, const ros::Time& stamp);
  void publishJaw(const ToolReport& report, const ros::Time& stamp);
  void publishWrench(const ToolReport& report, const ros::Time& stamp);

  const std::size_t tool_;
  const std::string name_, joint_, body_frame_, wrench_frame_;
  bool valid_ = false;  ///< the last wrench was
  double latency_ = 0;  ///< [s]
  Outlet<geometry_msgs::PoseStamped> poses_;
  Outlet<geometry_msgs::WrenchStamped> wrenches_;
  Outlet<sensor_msgs::JointState> jaws_;
};

}  // namespace incision

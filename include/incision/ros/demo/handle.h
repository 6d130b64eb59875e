#pragma once

#include <interactive_markers/interactive_marker_server.h>
#include <interactive_markers/menu_handler.h>
#include <ros/node_handle.h>

#include <array>
#include <string>

#include "incision/rigid/pose.h"
#include "incision/ros/demo/tool_pose_publisher.h"

namespace incision {

/// The private parameters of incision_handle.
struct HandleSettings {
  std::string frame = "body";                     ///< ~frame of the markers
  std::string tool_frame = "blade";               ///< ~tool_frame in tf
  double rate = 10;                               ///< ~rate [Hz] 1 … 1000: at least so many poses a second
  Pose scalpel_pose;                              ///< ~scalpel_pose: [x, y, z, roll, pitch, yaw], m and rad
  double scalpel_size = 0.1;                      ///< ~scalpel_size [m] above 0 … 1000: of the handle drawn
  Pose plane_pose;                                ///< ~plane_pose, like ~scalpel_pose
  std::array<double, 2> plane_size = {0.1, 0.1};  ///< ~plane_size [m]: length, width, above 0 … 1000
};

/// Throws InputError with parameter, value and what is allowed.
HandleSettings loadHandleSettings(const ros::NodeHandle& node);

/// Lets a user of rviz move a scalpel and a cut plane. Dragging the scalpel publishes its poses; its menu turns the
/// blade on and off. The plane's menu asks for the cut.
class Handle {
 public:
  Handle(ros::NodeHandle& node, const HandleSettings& settings);

 private:
  using Feedback = visualization_msgs::InteractiveMarkerFeedbackConstPtr;

  void addScalpel();
  void addPlane();
  void moveScalpel(const Feedback& feedback);
  void publishPose();
  void toggleBlade();
  void publishActive();
  /// `size`: length and width [m]; 0: unbounded.
  void cut(const std::array<double, 2>& size);

  const HandleSettings settings_;
  ToolPosePublisher publisher_;
  ros::Publisher active_publisher_, cut_publisher_;
  interactive_markers::InteractiveMarkerServer server_;
  interactive_markers::MenuHandler scalpel_menu_, plane_menu_;
  interactive_markers::MenuHandler::EntryHandle blade_entry_ = 0;  ///< of the scalpel's menu
  ros::WallTimer timer_;                                           ///< repeats the last pose
  geometry_msgs::PoseStamped pose_;
  bool active_ = true;
  int cuts_ = 0;
};

}  // namespace incision

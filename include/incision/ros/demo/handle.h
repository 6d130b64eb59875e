#pragma once

#include <interactive_markers/interactive_marker_server.h>
#include <interactive_markers/menu_handler.h>
#include <ros/node_handle.h>

#include <array>
#include <optional>
#include <string>

#include "incision/rigid/pose.h"
#include "incision/ros/demo/tool_pose_publisher.h"

namespace incision {

/// Angles of a tool's jaw [rad].
struct JawAngles {
  double open, closed;
};

/// The private parameters of incision_handle.
struct HandleSettings {
  std::string frame = "body";                     ///< ~frame of the markers
  std::string tool_frame = "blade";               ///< ~tool_frame in tf
  double rate = 10;                               ///< ~rate [Hz] 1 … 1000: at least so many poses a second
  Pose tool_pose;                                 ///< ~tool_pose: [x, y, z, roll, pitch, yaw], m and rad
  double tool_size = 0.1;                         ///< ~tool_size [m] above 0 … 1000: of the handle drawn
  Vec3 tool_axis = Vec3::UnitZ();                 ///< ~tool_axis: x, y or z; the handle points against it
  std::optional<JawAngles> jaw;                   ///< ~jaw_open, ~jaw_closed; none: the tool has no jaw
  bool plane = true;                              ///< ~plane: there is a cut plane, too
  Pose plane_pose;                                ///< ~plane_pose, like ~tool_pose
  std::array<double, 2> plane_size = {0.1, 0.1};  ///< ~plane_size [m]: length, width, above 0 … 1000
};

/// Throws InputError with parameter, value and what is allowed.
HandleSettings loadHandleSettings(const ros::NodeHandle& node);

/// Lets a user of rviz move a tool and a cut plane. Dragging the tool publishes its poses; its menu switches it on and
/// off, and moves its jaw. The plane's menu asks for the cut.
class Handle {
 public:
  Handle(ros::NodeHandle& node, const HandleSettings& settings);

 private:
  using Feedback = visualization_msgs::InteractiveMarkerFeedbackConstPtr;

  void addTool();
  void addPlane();
  void moveTool(const Feedback& feedback);
  void addJawEntries();
  void publishPose();
  void publishJaw(const ros::Time& time);
  void toggleTool();
  void publishActive();
  /// `size`: length and width [m]; 0: unbounded.
  void cut(const std::array<double, 2>& size);

  const HandleSettings settings_;
  ToolPosePublisher publisher_;
  ros::Publisher active_publisher_, cut_publisher_, jaw_publisher_;
  interactive_markers::InteractiveMarkerServer server_;
  interactive_markers::MenuHandler tool_menu_, plane_menu_;
  interactive_markers::MenuHandler::EntryHandle active_entry_ = 0;  ///< of the tool's menu
  ros::WallTimer timer_;                                            ///< repeats the last pose
  geometry_msgs::PoseStamped pose_;
  bool active_ = true;
  double jaw_ = 0, jaw_target_ = 0;  ///< [rad] where it is, and where the user wants it
  int cuts_ = 0;
};

}  // namespace incision

#include "incision/pace/command.h"

namespace incision {
namespace {

PlaneCut carried(const PlaneCut& plane, const Eigen::Isometry3d& to_body) {
  PlaneCut result = plane;
  result.point = to_body * plane.point;
  result.normal = to_body.linear() * plane.normal;
  result.tangent = to_body.linear() * plane.tangent;
  return result;
}

ToolPose carried(const ToolPose& asked, const Eigen::Isometry3d& to_body) {
  const Eigen::Quaterniond turned = Eigen::Quaterniond(to_body.linear()) * asked.pose.orientation;
  return {asked.tool, {to_body * asked.pose.position, turned.normalized()}};
}

}  // namespace

Command inBodyFrame(const Command& command, const Pose& frame, const std::string& body_frame) {
  const Eigen::Isometry3d to_body = Eigen::Translation3d(frame.position) * frame.orientation;
  Command result = command;
  std::visit([&](auto& action) { action = carried(action, to_body); }, result.action);
  result.frame = body_frame;
  return result;
}

}  // namespace incision

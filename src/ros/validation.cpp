#include "incision/ros/validation.h"

#include <utility>

#include "incision/base/printable.h"
#include "incision/pace/validation.h"
#include "incision/ros/conversions.h"

namespace incision {
namespace {

constexpr std::uint32_t NANOSECONDS_PER_SECOND = 1'000'000'000;

std::optional<Refused> whyRefused(const std_msgs::Header& header) {
  if (auto refused = whyRefusedFrame(header.frame_id)) return refused;
  if (header.stamp.nsec < NANOSECONDS_PER_SECOND) return std::nullopt;
  return Refused{Refusal::OUT_OF_RANGE, "header.stamp: a second or more of nanoseconds"};
}

Command toCommand(Action action, const std_msgs::Header& header, const std::string& body_frame, SteadyTime received) {
  std::string frame = header.frame_id;
  if (!frame.empty() && frame.front() == '/') frame.erase(0, 1);
  if (frame.empty()) frame = body_frame;
  return {std::move(action), std::move(frame), static_cast<Nanoseconds>(header.stamp.toNSec()), received};
}

}  // namespace

std::optional<Refused> whyRefused(const CutPlane& message) {
  if (auto refused = whyRefused(message.header)) return refused;
  return whyRefused(toPlaneCut(message));
}

std::optional<Refused> whyRefused(const geometry_msgs::PoseStamped& message) {
  if (auto refused = whyRefused(message.header)) return refused;
  const geometry_msgs::Quaternion& q = message.pose.orientation;
  return whyRefused(Pose{toVec3(message.pose.position), Eigen::Quaterniond(q.w, q.x, q.y, q.z)});
}

std::optional<Refused> whyRefused(const sensor_msgs::JointState& message, const Jaw& jaw) {
  if (auto refused = whyRefused(message.header)) return refused;
  const auto outOfRange = [](const std::string& reason) { return Refused{Refusal::OUT_OF_RANGE, reason}; };
  if (message.position.size() != 1)
    return outOfRange("position: " + std::to_string(message.position.size()) +
                      " values (allowed: one, the jaw's angle; neither velocity nor effort is followed)");
  if (message.name.size() > 1 || (message.name.size() == 1 && message.name[0] != jaw.joint))
    return outOfRange("name: " + printable(message.name[0]) + " (allowed: none, or the jaw's joint " +
                      printable(jaw.joint) + ")");
  return whyRefused(message.position[0], jaw.angles);
}

Command toCommand(const CutPlane& message, const std::string& body_frame, SteadyTime received) {
  return toCommand(toPlaneCut(message), message.header, body_frame, received);
}

Command toCommand(const geometry_msgs::PoseStamped& message, int tool, const std::string& body_frame,
                  SteadyTime received) {
  return toCommand(ToolPose{tool, toPose(message.pose)}, message.header, body_frame, received);
}

}  // namespace incision

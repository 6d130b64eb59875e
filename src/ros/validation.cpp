#include "incision/ros/validation.h"

#include <cmath>

#include "incision/ros/conversions.h"
#include "incision/scene/scene.h"

namespace incision {
namespace {

constexpr std::uint32_t NANOSECONDS_PER_SECOND = 1'000'000'000;

Refused outOfRange(const std::string& reason) { return {Refusal::OUT_OF_RANGE, reason}; }

std::optional<Refused> whyRefused(const std_msgs::Header& header) {
  if (header.frame_id.size() > MAX_FRAME)
    return outOfRange("header.frame_id: longer than " + std::to_string(MAX_FRAME) + " characters");
  if (header.stamp.nsec >= NANOSECONDS_PER_SECOND) return outOfRange("header.stamp: a second or more of nanoseconds");
  return std::nullopt;
}

bool allFinite(const PlaneCut& plane) {
  return plane.point.allFinite() && plane.normal.allFinite() && plane.tangent.allFinite() &&
         std::isfinite(plane.length) && std::isfinite(plane.width);
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
  if (message.label.size() > MAX_LABEL)
    return outOfRange("label: longer than " + std::to_string(MAX_LABEL) + " characters");
  const PlaneCut plane = toPlaneCut(message);
  const std::string reason = whyInvalid(plane);
  if (reason.empty()) return std::nullopt;
  return Refused{allFinite(plane) ? Refusal::OUT_OF_RANGE : Refusal::NOT_FINITE, reason};
}

std::optional<Refused> whyRefused(const geometry_msgs::PoseStamped& message) {
  if (auto refused = whyRefused(message.header)) return refused;
  const Vec3 position = toVec3(message.pose.position);
  const geometry_msgs::Quaternion& q = message.pose.orientation;
  const Eigen::Vector4d quaternion(q.x, q.y, q.z, q.w);
  if (!position.allFinite() || !quaternion.allFinite())
    return Refused{Refusal::NOT_FINITE, "pose: a value is infinite or not a number"};
  if (position.cwiseAbs().maxCoeff() > MAX_POSITION) return outOfRange("pose.position: beyond 1e9 m");
  if (std::abs(quaternion.stableNorm() - 1) > QUATERNION_TOLERANCE)
    return outOfRange("pose.orientation: not a quaternion of length 1");
  return std::nullopt;
}

Command toCommand(const CutPlane& message, const std::string& body_frame, SteadyTime received) {
  return toCommand(toPlaneCut(message), message.header, body_frame, received);
}

Command toCommand(const geometry_msgs::PoseStamped& message, const std::string& body_frame, SteadyTime received) {
  return toCommand(toPose(message.pose), message.header, body_frame, received);
}

}  // namespace incision

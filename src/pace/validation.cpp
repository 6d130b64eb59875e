#include "incision/pace/validation.h"

#include <cmath>

#include "incision/base/limits.h"
#include "incision/scene/scene.h"

namespace incision {
namespace {

Refused outOfRange(const std::string& reason) { return {Refusal::OUT_OF_RANGE, reason}; }

bool allFinite(const PlaneCut& plane) {
  return plane.point.allFinite() && plane.normal.allFinite() && plane.tangent.allFinite() &&
         std::isfinite(plane.length) && std::isfinite(plane.width);
}

}  // namespace

std::optional<Refused> whyRefused(const PlaneCut& plane) {
  if (plane.label.size() > MAX_LABEL)
    return outOfRange("label: longer than " + std::to_string(MAX_LABEL) + " characters");
  const std::string reason = whyInvalid(plane);
  if (reason.empty()) return std::nullopt;
  return Refused{allFinite(plane) ? Refusal::OUT_OF_RANGE : Refusal::NOT_FINITE, reason};
}

std::optional<Refused> whyRefused(const Pose& pose) {
  const Eigen::Vector4d quaternion = pose.orientation.coeffs();
  if (!pose.position.allFinite() || !quaternion.allFinite())
    return Refused{Refusal::NOT_FINITE, "pose: a value is infinite or not a number"};
  if (pose.position.cwiseAbs().maxCoeff() > MAX_COORDINATE) return outOfRange("pose.position: beyond 1e9 m");
  if (std::abs(quaternion.stableNorm() - 1) > QUATERNION_TOLERANCE)
    return outOfRange("pose.orientation: not a quaternion of length 1");
  return std::nullopt;
}

std::optional<Refused> whyRefused(double angle, const Range& jaw) {
  if (!std::isfinite(angle)) return Refused{Refusal::NOT_FINITE, "position: infinite or not a number"};
  if (angle >= jaw.min && angle <= jaw.max) return std::nullopt;
  return outOfRange("position: " + std::to_string(angle) + " (allowed by the joint: " + std::to_string(jaw.min) +
                    " to " + std::to_string(jaw.max) + ")");
}

std::optional<Refused> whyRefusedFrame(const std::string& name) {
  if (name.size() <= MAX_NAME) return std::nullopt;
  return outOfRange("header.frame_id: longer than " + std::to_string(MAX_NAME) + " characters");
}

}  // namespace incision

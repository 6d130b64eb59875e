#include "clamp_motions.h"

#include <stdexcept>

#include "incision/tool/tool.h"

namespace incision {
/// A frame that has not moved leaves its nodes where they are to the last digit.
std::optional<Pose> ClampMotion::at(double share) const {
  if (!first) return std::nullopt;
  const Pose now = in_step.at(share);
  return now == *first ? Pose() : composed(now, inverse(*first));
}

ClampMotions::ClampMotions(const std::vector<Clamp>& clamps)
    : clamps_(clamps), motions_(clamps.size()), ends_(clamps.size()) {
  for (const Clamp& clamp : clamps) any_ = any_ || clamp.isPosed();
}

ClampMotion& ClampMotions::posed(std::size_t clamp) {
  if (!clamps_.at(clamp).isPosed()) throw std::out_of_range("this clamp has no frame");
  return motions_[clamp];
}

void ClampMotions::move(std::size_t clamp, const Pose& pose) {
  ClampMotion& motion = posed(clamp);
  if (!motion.first) motion = {pose, {pose, pose}};
  motion.in_step.to = pose;
}

Pose ClampMotions::place(std::size_t clamp, const Pose& pose) {
  ClampMotion& motion = posed(clamp);
  if (!motion.first) motion.first = pose;
  motion.in_step = {pose, pose};
  return *motion.at(1);
}

void ClampMotions::startStep(double time, double time_step) {
  for (std::size_t i = 0; i < clamps_.size(); ++i) {
    const std::vector<TimedPose>& poses = clamps_[i].poses;
    const double end = time + time_step;
    if (poses.empty() || end < poses.front().time - DUE_TOLERANCE) continue;
    if (!motions_[i].first) move(i, poses.front().pose);
    move(i, poseAt(poses, end));
  }
}

void ClampMotions::endStep() {
  for (ClampMotion& motion : motions_) motion.in_step.from = motion.in_step.to;
}

const std::vector<std::optional<Pose>>& ClampMotions::at(double share) {
  for (std::size_t i = 0; i < motions_.size(); ++i) ends_[i] = motions_[i].at(share);
  return ends_;
}

Pose ClampMotions::startOf(std::size_t clamp) const { return motions_[clamp].in_step.from; }

}  // namespace incision

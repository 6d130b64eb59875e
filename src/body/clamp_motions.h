#pragma once

#include <optional>
#include <vector>

#include "incision/fem/boundary_settings.h"
#include "incision/rigid/rigid_motion.h"

namespace incision {

/// A clamp's frame.
struct ClampMotion {
  std::optional<Pose> first;  ///< P₀: where it stood when it was first known; none: it has not been heard of
  RigidMotion in_step;        ///< in the step to come

  /// Where the clamp's nodes are when a share of the step is over, from where they rest: P P₀⁻¹.
  std::optional<Pose> at(double share) const;
};

template <class Archive>
void serialize(Archive& archive, ClampMotion& motion) {
  auto& [first, in_step] = motion;
  archive(first, in_step);
}

/// Where the frames of a body's clamps go. The functions that take a clamp throw std::out_of_range for one that there
/// is not, or that has no frame.
class ClampMotions {
 public:
  explicit ClampMotions(const std::vector<Clamp>& clamps);

  /// Whether any clamp has a frame.
  bool any() const { return any_; }

  /// In the next step the frame moves evenly to the pose, where it stays. The first pose only tells where it stands.
  void move(std::size_t clamp, const Pose& pose);
  /// The frame is put there. Returns where its nodes then are, from where they rest.
  Pose place(std::size_t clamp, const Pose& pose);

  /// A step from `time` [s] on starts: frames whose poses are given go where these have them at its end.
  void startStep(double time, double time_step);
  /// The step has been taken.
  void endStep();

  /// Where each clamp's nodes are when a share of the step is over, from where they rest.
  const std::vector<std::optional<Pose>>& at(double share);

  /// Where the clamp's frame is when the step starts; the body's own where nothing is known of it.
  Pose startOf(std::size_t clamp) const;

  /// All of it outlasts a step.
  const std::vector<ClampMotion>& keep() const { return motions_; }
  void recall(const std::vector<ClampMotion>& motions) { motions_ = motions; }

 private:
  ClampMotion& posed(std::size_t clamp);

  const std::vector<Clamp>& clamps_;
  bool any_ = false;
  std::vector<ClampMotion> motions_;
  std::vector<std::optional<Pose>> ends_;
};

}  // namespace incision

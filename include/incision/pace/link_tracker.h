#pragma once

#include <optional>
#include <string>
#include <vector>

#include "incision/contact/obstacles.h"
#include "incision/pace/approach.h"
#include "incision/pace/link_lookup.h"

namespace incision {

/// A link that is further from where it stood than this speed [m/s] explains did not move there but was put there: it
/// sweeps nothing on its way. No robot's hand is faster; slower jumps would throw the body about.
inline constexpr double MAX_OBSTACLE_SPEED = 10;

/// Where a link goes in the next step.
struct LinkMove {
  int link;
  Pose pose;                              ///< in the body's frame, at the end of the step
  bool at_once = false;                   ///< it is put there, and sweeps nothing on its way
  std::optional<double> jump_speed = {};  ///< [m/s] at which it would have moved there, where that is too fast
};

/// A link to be followed.
struct FollowedLink {
  std::string name;                ///< also that of its frame
  std::optional<Pose> start = {};  ///< where it is until it is heard of, if that is known
  double reach = 0;                ///< [m] of what belongs to it from its origin
};

/// What of a followed link outlasts a step.
struct FollowedLinkMemory {
  Pose pose;  ///< where it is
  std::optional<Pose> target;
  std::optional<Nanoseconds> age;  ///< of the target, when the last step started; none: it holds for all times
  Approach approach;               ///< to the target
  bool found = false;              ///< since the start
};

template <class Archive>
void serialize(Archive& archive, FollowedLinkMemory& memory) {
  auto& [pose, target, age, approach, found] = memory;
  archive(pose, target, age, approach, found);
}

void check(const std::vector<FollowedLinkMemory>& memory, const MemoryLimits& limits);

/// The obstacles' links, which are where the description has them until they are heard of.
std::vector<FollowedLink> linksOf(const Obstacles& obstacles);

/// Follows links by the frames of their names. One of which nothing is known stays where it is. Used by the stepping
/// thread, which it never makes wait.
class LinkTracker {
 public:
  /// `time_step` [s].
  LinkTracker(LinkLookup lookup, const std::vector<FollowedLink>& links, double time_step);

  /// The links that go somewhere in the next step, which starts at the ROS time `now`: to where they are at `end`, when
  /// it ends; where that is not known yet, or `end` is 0, to where they were at last.
  std::vector<LinkMove> follow(Nanoseconds now, Nanoseconds end);

  /// Each link is where it started, until it is heard of again.
  void restart() noexcept;

  /// Goes on as if no time had passed since the step before keep(): transforms are as old as then. `memory` is of as
  /// many links.
  std::vector<FollowedLinkMemory> keep() const;
  void recall(const std::vector<FollowedLinkMemory>& memory) noexcept;

  /// Where the links are, or are going in the step asked for last; the identity where that is not known.
  const std::vector<Pose>& poses() const { return poses_; }

  /// Stamp of the newest pose of a link; none before the first.
  std::optional<Nanoseconds> stampOf(std::size_t link) const;

  /// How often, so far, a link stayed where it was because what is known of it was of no use.
  std::uint64_t ignored() const { return lookup_.ignored(); }

 private:
  struct Link {
    FollowedLink followed;
    std::optional<Pose> target;
    Nanoseconds stamp = 0;
    Approach approach;
    bool found = false;
  };
  void resume(Nanoseconds now);
  void aim(const StampedPose& target, Link* link, LinkMove* move) const;

  LinkLookup lookup_;
  const double time_step_;
  std::vector<Link> links_;
  std::vector<Pose> poses_;
  Nanoseconds last_call_ = 0;  ///< `now` of it
  bool resumed_ = false;       ///< stamps are less the last call's, which is still to be known
};

}  // namespace incision

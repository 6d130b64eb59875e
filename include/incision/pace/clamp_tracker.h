#pragma once

#include <optional>
#include <vector>

#include "incision/fem/boundary_settings.h"
#include "incision/pace/link_tracker.h"
#include "incision/scene/scene.h"

namespace incision {

/// A clamp whose frame's newest transform is older than this [s] is said to hold still: some poses of any stream.
inline constexpr double CLAMP_TIMEOUT = 0.5;

/// Clamps that have a frame do not follow the poses that the scene has of them, which are for runs without one.
void leaveClampsToFrames(Scene* scene);

/// Follows the frames of clamps. A clamp of whose frame nothing is known, or nothing new, stays where it is; that is
/// said. Used by the stepping thread, which it never makes wait.
class ClampTracker {
 public:
  /// `complain` is told of each step in which a clamp's frame is of no use. `time_step` [s].
  ClampTracker(const Frames& frames, LinkLookup::Complain complain, const std::vector<Clamp>& clamps, double time_step);

  /// Where frames go in the next step, as LinkTracker says; `link` is the clamp's index. In a `single` step, of a
  /// paused body, no transform grows old.
  std::vector<LinkMove> follow(Nanoseconds now, Nanoseconds end, bool single);

  /// Nothing is known of any frame, until it is heard of again.
  void restart() noexcept;

  /// As those of a LinkTracker, of each clamp that has a frame.
  std::vector<FollowedLinkMemory> keep() const { return tracker_.keep(); }
  void recall(const std::vector<FollowedLinkMemory>& memory) noexcept;

  /// How often, so far, a clamp stayed where it was because what is known of its frame was of no use.
  std::uint64_t ignored() const { return tracker_.ignored(); }

 private:
  struct Followed {
    int clamp;
    std::string frame;
    std::optional<Nanoseconds> stamp = {};  // of the newest transform
    Nanoseconds since = 0;                  // when it was new
  };
  void checkAge(Nanoseconds now, std::size_t i);

  std::string body_frame_;
  LinkLookup::Complain complain_;
  std::vector<Followed> followed_;
  LinkTracker tracker_;
};

}  // namespace incision

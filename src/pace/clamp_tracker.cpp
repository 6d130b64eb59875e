#include "incision/pace/clamp_tracker.h"

namespace incision {
namespace {

std::vector<FollowedLink> framesOf(const std::vector<Clamp>& clamps) {
  std::vector<FollowedLink> frames;
  for (const Clamp& clamp : clamps)
    if (!clamp.frame.empty()) frames.push_back({clamp.frame});
  return frames;
}

}  // namespace

void leaveClampsToFrames(Scene* scene) {
  for (Clamp& clamp : scene->boundary)
    if (!clamp.frame.empty()) clamp.poses.clear();
}

ClampTracker::ClampTracker(const Frames& frames, LinkLookup::Complain complain, const std::vector<Clamp>& clamps,
                           double time_step)
    : body_frame_(frames.body()),
      complain_(complain),
      tracker_(LinkLookup(frames, std::move(complain)), framesOf(clamps), time_step) {
  for (std::size_t i = 0; i < clamps.size(); ++i)
    if (!clamps[i].frame.empty()) followed_.push_back({static_cast<int>(i), clamps[i].frame});
}

std::vector<LinkMove> ClampTracker::follow(Nanoseconds now, Nanoseconds end, bool single) {
  std::vector<LinkMove> moves = tracker_.follow(now, end);
  for (LinkMove& move : moves) move.link = followed_[static_cast<std::size_t>(move.link)].clamp;
  if (!single)
    for (std::size_t i = 0; i < followed_.size(); ++i) checkAge(now, i);
  return moves;
}

/// What holds for all times does not grow old.
void ClampTracker::checkAge(Nanoseconds now, std::size_t i) {
  Followed& followed = followed_[i];
  const std::optional<Nanoseconds> stamp = tracker_.stampOf(i);
  if (followed.frame == body_frame_ || (stamp && *stamp == 0)) return;
  if (!stamp) {
    complain_(followed.frame, "tf has not told where it is");
  } else if (stamp != followed.stamp) {
    followed.stamp = stamp;
    followed.since = now;
  } else if (toSeconds(now - followed.since) > CLAMP_TIMEOUT) {
    complain_(followed.frame, "its last transform is older than " + std::to_string(CLAMP_TIMEOUT) + " s");
  }
}

void ClampTracker::restart() noexcept {
  tracker_.restart();
  for (Followed& followed : followed_) followed.stamp.reset();
}

void ClampTracker::recall(const std::vector<FollowedLinkMemory>& memory) noexcept {
  tracker_.recall(memory);
  for (Followed& followed : followed_) followed.stamp.reset();
}

}  // namespace incision

#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <list>
#include <mutex>
#include <optional>
#include <string>

#include "incision/pace/frames.h"

namespace incision {

/// Most commands that may wait for a transform. When more come, the oldest of a frame of which nobody has heard goes
/// first: a flood of nonsense then does not push out a command that is only a little ahead of its transform.
inline constexpr std::size_t MAX_WAITING_FOR_TRANSFORM = 256;

/// Commands that wait until it is known where their frame stands in the body's, each until a deadline counted from its
/// arrival. Poses of one tool in one frame leave as they came, one after the other. Thread-safe.
class TransformQueue {
 public:
  using Release = std::function<void(const Command& in_body_frame)>;
  using Refuse = std::function<void(const Command&, const Refused&)>;

  /// `timeout`: how long a command waits [s].
  TransformQueue(const Frames& frames, double timeout, Release release, Refuse refuse);

  /// Releases the command at once when its transform is known, and keeps it otherwise.
  void add(const Command& command);

  /// Releases commands whose transform has come and refuses those whose time is up.
  void poll(SteadyTime now);

  /// Refuses everything that waits.
  void clear(const Refused& refused);

  bool empty() const;
  std::size_t size() const;
  /// The one that came first, of those that wait.
  std::optional<Command> first() const;
  /// Earliest stamp that waits, other than 0 for "now"; nothing when there is none.
  std::optional<Nanoseconds> earliestStamp() const;

 private:
  bool overtakes(const Command& command) const;
  bool tryRelease(const Command& command);
  std::string whyNot(const Command& command) const;
  void putOneOut();

  const Frames& frames_;
  const std::chrono::duration<double> timeout_;
  const Release release_;
  const Refuse refuse_;
  mutable std::mutex mutex_;
  std::list<Command> waiting_;  ///< by arrival
};

}  // namespace incision

#pragma once

#include <tf2/buffer_core.h>

#include <functional>
#include <list>
#include <mutex>
#include <optional>

#include "incision/pace/command.h"

namespace incision {

/// Most commands that may wait for a transform. When more come, the oldest of a frame that tf has never heard of goes
/// first: a flood of nonsense then does not push out a command that is only a little ahead of its transform.
inline constexpr std::size_t MAX_WAITING_FOR_TRANSFORM = 256;

/// Commands that wait for the transform from their frame into the body's, each until a deadline counted from its
/// arrival. Tool poses of one frame leave in the order in which they came.
class TransformQueue {
 public:
  using Release = std::function<void(const Command& in_body_frame)>;
  using Refuse = std::function<void(const Command&, const Refused&)>;

  /// `timeout`: how long a command waits [s].
  TransformQueue(const tf2::BufferCore& buffer, std::string body_frame, double timeout, Release release, Refuse refuse);

  /// Releases the command at once when its transform is known, and keeps it otherwise.
  void add(const Command& command);

  /// Releases commands whose transform has come and refuses those whose time is up.
  void poll(SteadyTime now);

  /// Refuses everything that waits.
  void clear(const Refused& refused);

  bool empty() const;
  /// Earliest stamp that waits, other than 0 for "now"; nothing when there is none. May be called from any thread.
  std::optional<Nanoseconds> earliestStamp() const;

 private:
  bool overtakes(const Command& command) const;
  bool tryRelease(const Command& command);
  std::string whyNot(const Command& command) const;
  void putOneOut();

  const tf2::BufferCore& buffer_;
  const std::string body_frame_;
  const std::chrono::duration<double> timeout_;
  const Release release_;
  const Refuse refuse_;
  mutable std::mutex mutex_;
  std::list<Command> waiting_;  ///< by arrival
};

}  // namespace incision

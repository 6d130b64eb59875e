#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "incision/pace/agenda.h"
#include "incision/pace/answers.h"
#include "incision/pace/transform_queue.h"
#include "incision/pace/wakeup.h"
#include "incision/scene/scene.h"

namespace incision {

/// How commands are treated.
struct CommandSettings {
  std::vector<std::string> tools;  ///< names
  bool by_stamp = false;           ///< stamps are of the clock that steps go by; otherwise commands take effect at once
  double transform_timeout = 1;    ///< [s] by time of receipt
};

CommandSettings commandSettings(const Scene& scene, bool by_stamp, double transform_timeout);

/// A command that waits.
struct WaitingCommand {
  std::string what;   ///< in words
  std::string frame;  ///< whose transform is not known; empty where it waits for its stamp
  Nanoseconds stamp;
  SteadyTime received;
};

/// Commands that have passed validation, until the step before which they take effect: each waits for the transform of
/// its frame, then for its stamp. Every cut is answered in the end: it is taken for the body, or it is refused here.
/// Filled by the thread of the commands, emptied by the one that takes the steps.
class Commands {
 public:
  /// `answers` are told of what is refused; `wakeup` is notified of cuts.
  Commands(const CommandSettings& settings, const Frames& frames, Answers& answers, Wakeup& wakeup);

  /// A cut or a tool's pose.
  void add(const Command& command);
  /// An angle of a tool's jaw [rad].
  void add(int tool, double angle, Nanoseconds stamp, SteadyTime received);
  /// Whether the tool does what it is for, from its pose on that was added last.
  void activate(int tool, bool active);

  /// Commands that wait for a transform try again, and their time may be up. There is nothing to try when none waits.
  void poll(SteadyTime now);
  bool waitForTransforms() const { return !transforms_.empty(); }
  /// A command stamped at or before `time` still waits for its transform.
  bool waitsFor(Nanoseconds time) const;

  /// What takes effect up to `time`.
  std::vector<WaitingCut> takeCuts(Nanoseconds time) { return agenda_.takeCuts(time); }
  ToolInput takeTool(int tool, Nanoseconds time) { return agenda_.takeTool(tool, time); }

  /// Forgets all that waits, and answers each cut with the reason. Tools are switched on then, or as `isActive`
  /// says. Takes no memory from the heap.
  void refuseAll(const Refused& refused, const IsActive& isActive = nullptr) noexcept;

  /// Commands so far that arrived after their stamp had been passed, and poses and angles left out.
  std::uint64_t late() const { return agenda_.late(); }
  std::uint64_t thinned() const { return agenda_.thinned(); }
  std::uint64_t thinned(int tool) const { return agenda_.thinned(tool); }
  const std::vector<std::string>& tools() const { return settings_.tools; }

  /// How many wait for the transform of their frame, and for their stamp or the next step.
  std::size_t waitingForTransform() const { return transforms_.size(); }
  std::size_t waitingForStep() const { return agenda_.size(); }
  /// Of those that wait for a transform or are stamped later than `clock` the one that came first.
  std::optional<WaitingCommand> longestWaiting(Nanoseconds clock) const;

 private:
  Nanoseconds timeOf(Nanoseconds stamp, SteadyTime received) const;
  void release(const Command& command);
  void refuse(const Command& command, const Refused& refused);
  std::string nameOf(const Command& command) const;

  const CommandSettings settings_;
  Answers& answers_;
  Wakeup& wakeup_;
  Agenda agenda_;
  TransformQueue transforms_;
};

}  // namespace incision

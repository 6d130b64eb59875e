#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "incision/pace/tool_queue.h"

namespace incision {

/// Most cuts that may wait for their step: more than anyone plans ahead, and little memory.
inline constexpr std::size_t MAX_WAITING_CUTS = 1000;

/// A cut that waits for its step.
struct WaitingCut {
  PlaneCut plane;
  Nanoseconds stamp;
  SteadyTime received;
};

/// Whether a tool does what its kind does; where there is none they all do. Throws nothing.
using IsActive = std::function<bool(std::size_t tool)>;

/// Commands in the body's frame that wait for the step before which they take effect, ordered by stamp and then by
/// arrival. Filled by the thread of the commands, emptied by the one that takes the steps.
class Agenda {
 public:
  /// `tools`: how many there are.
  explicit Agenda(std::size_t tools) : tools_(tools) {}

  /// When the agenda is full, the cut with the latest stamp is put out and returned.
  std::optional<PlaneCut> add(const PlaneCut& plane, Nanoseconds stamp, SteadyTime received = {});
  /// The agenda knows whether the tool's blade is on.
  void add(int tool, const ReceivedPose& pose, Nanoseconds stamp);
  void add(int tool, const ReceivedAngle& angle, Nanoseconds stamp);

  /// Switches the tool's blade on, as it is at first, or off, after its pose that was added last.
  void activate(int tool, bool active);

  /// What is stamped up to `time`, in order.
  std::vector<WaitingCut> takeCuts(Nanoseconds time);
  ToolInput takeTool(int tool, Nanoseconds time);

  /// Forgets what is asked of the tools, and switches their blades on, or as `isActive` says.
  void clearTools(const IsActive& isActive = nullptr) noexcept;
  /// The next cut, whatever its stamp, if one waits. Takes no memory.
  std::optional<WaitingCut> takeCut() noexcept;

  /// How many commands wait. Of the cuts stamped later than `time`, and of what is asked of a tool, what came first.
  std::size_t size() const;
  std::optional<WaitingCut> firstCutAfter(Nanoseconds time) const;
  std::optional<Arrival> firstOfToolAfter(int tool, Nanoseconds time) const;

  /// Commands so far that arrived after their stamp had been passed, and poses left out.
  std::uint64_t late() const;
  std::uint64_t thinned() const;
  std::uint64_t thinned(int tool) const;

 private:
  ToolQueue& at(int tool) { return tools_.at(static_cast<std::size_t>(tool)); }
  const ToolQueue& at(int tool) const { return tools_.at(static_cast<std::size_t>(tool)); }
  void countIfLate(Nanoseconds stamp);
  void noteTaken(Nanoseconds time);

  mutable std::mutex mutex_;
  StampedQueue<WaitingCut> cuts_;
  std::vector<ToolQueue> tools_;
  Nanoseconds taken_ = 0;  ///< up to this
  std::uint64_t late_ = 0;
};

}  // namespace incision

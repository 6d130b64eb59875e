#pragma once

#include <deque>
#include <mutex>
#include <optional>

#include "incision/pace/command.h"

namespace incision {

/// Says when steps start. Used by the stepping thread.
class Pacer {
 public:
  virtual ~Pacer() = default;

  /// The next step starts as soon as it may: at the start, after a pause or a reset.
  virtual void restart() = 0;
  /// Brings the clock up to now; to be called before the questions below.
  virtual void update(SteadyTime now) = 0;
  /// Whether the next step may start.
  virtual bool due() const = 0;
  virtual void stepTaken() = 0;
  /// When to update again.
  virtual SteadyTime nextUpdate() const = 0;

  /// Commands stamped up to this take effect before the next step.
  virtual Nanoseconds nextStart() const = 0;
  /// Commands stamped up to this take effect while the body is paused.
  virtual Nanoseconds clock() const = 0;
  /// How far [s] the body is behind the clock it follows.
  virtual double lag() const = 0;
  /// Time [s] so far that has passed without steps, and for which none will be taken.
  virtual double skipped() const = 0;
  /// Whether these are times of ROS, by which commands are stamped; otherwise all commands take effect at once.
  virtual bool goesByStamps() const = 0;
};

/// Steps go by wall time. A step that takes too long delays the ones after it; they are not made up for, but skipped.
class WallPacer : public Pacer {
 public:
  explicit WallPacer(double time_step);
  void restart() override;
  void update(SteadyTime now) override;
  bool due() const override;
  void stepTaken() override;
  SteadyTime nextUpdate() const override;
  Nanoseconds nextStart() const override;
  Nanoseconds clock() const override;
  double lag() const override;
  double skipped() const override { return std::chrono::duration<double>(skipped_).count(); }
  bool goesByStamps() const override { return false; }

 private:
  std::chrono::nanoseconds time_step_;
  SteadyTime::duration skipped_{0};
  SteadyTime now_;
  std::optional<SteadyTime> next_;
};

/// How long [wall time] the clock waits for commands sent before it: they come over connections of their own, and
/// a step taken too early would miss them. It covers the scheduling of a busy machine.
inline constexpr std::chrono::milliseconds CLOCK_DELAY(50);

/// A clock that advances by more than this [s] from one message to the next has jumped. Also the least lag that must be
/// made up for, since a slow clock advances by many steps at once.
inline constexpr double MAX_CLOCK_ADVANCE = 1;

/// When step k starts on a clock of which an early message was `clock`: at t0 + k Δt, t0 being the last multiple of Δt
/// not after that message. `time_step` [s].
Nanoseconds startOfStep(Nanoseconds clock, double time_step, std::int64_t k);

/// Steps go by /clock. Step k starts when the clock has reached t0 + k Δt, whatever wall time it took: this makes a bag
/// replay exactly. t0 is the last multiple of Δt not after the first clock message, so that a clock which starts a
/// little later gives the same t0. Lag behind the clock up to `max_lag` is made up for; what is beyond it, and any jump
/// of the clock, moves t0, and time is skipped.
class ClockPacer : public Pacer {
 public:
  ClockPacer(double time_step, double max_lag);

  /// A clock message; may be called from another thread.
  void tick(SteadyTime received, Nanoseconds clock);

  void restart() override;
  void update(SteadyTime now) override;
  bool due() const override;
  void stepTaken() override;
  SteadyTime nextUpdate() const override;
  Nanoseconds nextStart() const override;
  Nanoseconds clock() const override;
  double lag() const override;
  double skipped() const override { return skipped_; }
  bool goesByStamps() const override { return true; }

 private:
  struct Tick {
    SteadyTime received;
    Nanoseconds clock;
  };
  void advance(Nanoseconds clock);
  void anchor(Nanoseconds clock);

  const double time_step_, max_lag_;
  mutable std::mutex mutex_;
  std::deque<Tick> ticks_;  ///< younger than CLOCK_DELAY
  Nanoseconds clock_ = 0;   ///< the last one older than that
  Nanoseconds first_ = 0;   ///< message, from which t0 follows
  std::int64_t steps_ = 0;  ///< since t0
  bool anchored_ = false;   ///< t0 is known
  double skipped_ = 0;      ///< [s]
};

}  // namespace incision

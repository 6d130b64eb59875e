#include "incision/pace/pacer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace incision {
namespace {

constexpr Nanoseconds ANY_TIME = std::numeric_limits<Nanoseconds>::max();

/// Two times of ROS closer than this [ns] are the same.
constexpr Nanoseconds SAME = 1;

}  // namespace

WallPacer::WallPacer(double time_step) : time_step_(std::llround(1e9 * time_step)) {}

void WallPacer::restart() { next_.reset(); }

void WallPacer::update(SteadyTime now) {
  now_ = now;
  if (!next_) next_ = now;
}

bool WallPacer::due() const { return now_ >= *next_; }

void WallPacer::stepTaken() {
  const SteadyTime now = steadyNow();
  const SteadyTime planned = next_ ? *next_ + time_step_ : now;
  next_ = std::max(planned, now);
  skipped_ += *next_ - planned;
}

SteadyTime WallPacer::nextUpdate() const { return next_.value_or(now_); }

Nanoseconds WallPacer::nextStart() const { return ANY_TIME; }
Nanoseconds WallPacer::clock() const { return ANY_TIME; }
double WallPacer::lag() const { return 0; }

Nanoseconds startOfStep(Nanoseconds clock, double time_step, std::int64_t k) {
  const Nanoseconds whole = std::llround(1e9 * time_step);
  return clock / whole * whole + std::llround(1e9 * time_step * static_cast<double>(k));
}

ClockPacer::ClockPacer(double time_step, double max_lag) : time_step_(time_step), max_lag_(max_lag) {}

void ClockPacer::tick(SteadyTime received, Nanoseconds clock) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ticks_.push_back({received, clock});
}

void ClockPacer::restart() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ticks_.clear();
  anchored_ = false;
}

void ClockPacer::update(SteadyTime now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  while (!ticks_.empty() && ticks_.front().received + CLOCK_DELAY <= now) {
    advance(ticks_.front().clock);
    ticks_.pop_front();
  }
}

bool ClockPacer::due() const { return anchored_ && nextStart() <= clock_ + SAME; }

void ClockPacer::advance(Nanoseconds clock) {
  const Nanoseconds last = std::exchange(clock_, clock);
  const double advanced = toSeconds(clock - last);
  if (!anchored_) {
    anchor(clock);
  } else if (advanced < 0 || advanced > MAX_CLOCK_ADVANCE || lag() > max_lag_) {
    const Nanoseconds next = nextStart();
    anchor(clock);
    skipped_ += std::max(0.0, toSeconds((advanced < 0 ? last : nextStart()) - next));
  }
}

void ClockPacer::anchor(Nanoseconds clock) {
  first_ = clock;
  steps_ = 0;
  anchored_ = true;
}

void ClockPacer::stepTaken() { ++steps_; }

SteadyTime ClockPacer::nextUpdate() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return ticks_.empty() ? SteadyTime::max() : ticks_.front().received + CLOCK_DELAY;
}

Nanoseconds ClockPacer::nextStart() const { return anchored_ ? startOfStep(first_, time_step_, steps_) : 0; }

Nanoseconds ClockPacer::clock() const { return clock_; }

double ClockPacer::lag() const { return anchored_ ? std::max(0.0, toSeconds(clock_ - nextStart())) : 0; }

}  // namespace incision

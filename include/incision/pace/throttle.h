#pragma once

#include <chrono>
#include <map>
#include <mutex>
#include <string>

#include "incision/pace/command.h"

namespace incision {

/// Says whether it is time to warn about something again. Thread-safe.
class Throttle {
 public:
  /// `period`: least time [s] between two warnings about one thing.
  explicit Throttle(double period)
      : period_(std::chrono::duration_cast<SteadyTime::duration>(std::chrono::duration<double>(period))) {}

  /// Whether nothing has been said about this for so long; it counts as said now.
  bool lets(const std::string& about, SteadyTime now) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto [said, is_new] = last_.emplace(about, now);
    if (!is_new && now - said->second < period_) return false;
    said->second = now;
    return true;
  }

 private:
  const SteadyTime::duration period_;
  std::mutex mutex_;
  std::map<std::string, SteadyTime> last_;
};

}  // namespace incision

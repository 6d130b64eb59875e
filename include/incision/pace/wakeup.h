#pragma once

#include <condition_variable>
#include <mutex>

#include "incision/pace/command.h"

namespace incision {

/// Lets one thread sleep until a time, or until another thread has something for it.
class Wakeup {
 public:
  void notify() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      notified_ = true;
    }
    condition_.notify_one();
  }

  void waitUntil(SteadyTime time) {
    std::unique_lock<std::mutex> lock(mutex_);
    condition_.wait_until(lock, time, [this] { return notified_; });
    notified_ = false;
  }

 private:
  std::mutex mutex_;
  std::condition_variable condition_;
  bool notified_ = false;
};

}  // namespace incision

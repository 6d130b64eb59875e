#pragma once

#include <functional>
#include <future>
#include <mutex>
#include <vector>

#include "incision/pace/wakeup.h"

namespace incision {

/// Work that other threads ask the stepping thread to do, since it alone touches the body.
class SteppingTasks {
 public:
  explicit SteppingTasks(Wakeup& wakeup) : wakeup_(wakeup) {}

  /// Waits until the stepping thread has run `task`; false when it ends first.
  bool ask(std::function<void()> task);

  /// On the stepping thread: runs what was asked for; whether there was anything.
  bool run();

  /// On the stepping thread: drops what was asked for and takes no more.
  void close();

 private:
  Wakeup& wakeup_;
  std::mutex mutex_;
  std::vector<std::packaged_task<void()>> tasks_;
  bool closed_ = false;
};

}  // namespace incision

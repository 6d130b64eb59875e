#include "incision/pace/stepping_tasks.h"

#include <utility>

namespace incision {

bool SteppingTasks::ask(std::function<void()> task) {
  std::packaged_task<void()> packaged(std::move(task));
  std::future<void> done = packaged.get_future();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (closed_) return false;
    tasks_.push_back(std::move(packaged));
  }
  wakeup_.notify();
  try {
    done.get();
    return true;
  } catch (const std::future_error&) {  // dropped
    return false;
  }
}

bool SteppingTasks::run() {
  std::vector<std::packaged_task<void()>> tasks;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    tasks.swap(tasks_);
  }
  for (auto& task : tasks) task();
  return !tasks.empty();
}

void SteppingTasks::close() {
  const std::lock_guard<std::mutex> lock(mutex_);
  closed_ = true;
  tasks_.clear();
}

}  // namespace incision

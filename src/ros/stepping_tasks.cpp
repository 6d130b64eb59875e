#include "incision/ros/stepping_tasks.h"

#include <ros/init.h>

#include <utility>

namespace incision {

bool SteppingTasks::ask(std::function<void()> task) {
  std::packaged_task<void()> packaged(std::move(task));
  std::future<void> done = packaged.get_future();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    tasks_.push_back(std::move(packaged));
  }
  wakeup_.notify();
  while (done.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready)
    if (!ros::ok()) return false;
  return true;
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

}  // namespace incision

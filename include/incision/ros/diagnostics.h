#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "incision/pace/wakeup.h"
#include "incision/ros/diagnosis.h"
#include "incision/ros/parameters.h"

namespace incision {

/// Publishes on `/diagnostics` how the node is, on a thread of its own: also while a step takes long.
class Diagnostics {
 public:
  /// `counts` and `waiting` are asked on that thread; the former's `ignored_transforms` comes from the condition.
  Diagnostics(const ros::NodeHandle& node, const NodeSettings& settings, std::function<InputCounts()> counts,
              std::function<Waiting()> waiting);
  ~Diagnostics();

  /// On the stepping thread: after a step; and each time round, where `write` writes the condition over the last one.
  void stepTaken(const StepResult& step);
  template <class Write>
  void tell(const Write& write) {
    const std::lock_guard<std::mutex> lock(mutex_);
    write(&condition_);
  }

 private:
  void gather();
  void run();

  const std::chrono::duration<double> period_;
  std::vector<std::string> tools_;
  const std::function<InputCounts()> counts_now_;
  const std::function<Waiting()> waiting_now_;
  std::mutex mutex_;
  Condition condition_;
  StepTally tally_;
  // The thread's own, of this diagnosis:
  Condition of_condition_;
  StepTally of_steps_;
  InputCounts counts_, counts_before_;
  diagnostic_updater::Updater updater_;
  std::atomic<bool> stopping_ = false;
  Wakeup wakeup_;
  std::thread thread_;
};

}  // namespace incision

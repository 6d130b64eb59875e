#include "incision/ros/diagnostics.h"

#include <ros/this_node.h>

#include <utility>

namespace incision {

Diagnostics::Diagnostics(const ros::NodeHandle& node, const NodeSettings& settings, std::function<InputCounts()> counts,
                         std::function<Waiting()> waiting)
    : period_(settings.diagnostic_period),
      counts_now_(std::move(counts)),
      waiting_now_(std::move(waiting)),
      updater_(ros::NodeHandle(), node, ros::this_node::getName()) {
  for (const ToolSettings& tool : settings.scene.tools) tools_.push_back(tool.name);
  condition_.stale.assign(tools_.size(), 0);
  updater_.setHardwareID("none");
  updater_.add("pace", [this](Status& status) { tellPace(of_condition_, of_steps_, period_.count(), &status); });
  updater_.add("numerics", [this](Status& status) { tellNumerics(of_condition_, of_steps_, &status); });
  updater_.add("input", [this](Status& status) {
    tellInput(counts_, counts_before_, waiting_now_(), of_condition_, tools_, &status);
  });
  updater_.add("memory", [](Status& status) { tellMemory(memoryUse(), &status); });
  thread_ = std::thread([this] { run(); });
}

Diagnostics::~Diagnostics() {
  stopping_ = true;
  wakeup_.notify();
  thread_.join();
}

void Diagnostics::stepTaken(const StepResult& step) {
  const std::lock_guard<std::mutex> lock(mutex_);
  tally_.add(step);
}

void Diagnostics::gather() {
  counts_before_ = counts_;
  counts_ = counts_now_();
  const std::lock_guard<std::mutex> lock(mutex_);
  of_condition_ = condition_;
  of_steps_ = std::exchange(tally_, StepTally());
  counts_.ignored_transforms = of_condition_.ignored_transforms;
}

void Diagnostics::run() {
  SteadyTime next = steadyNow();
  while (true) {
    next += std::chrono::duration_cast<SteadyTime::duration>(period_);
    wakeup_.waitUntil(next);
    if (stopping_) return;
    try {
      gather();
      updater_.force_update();
    } catch (const std::bad_alloc&) {  // the next diagnosis may find memory, and says how little there is
    }
  }
}

}  // namespace incision

#include "incision/ros/checkpoint_server.h"

#include <ros/console.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "incision/base/why.h"
#include "incision/base/yaml_reader.h"

namespace incision {
namespace {

/// Least time [s] between two complaints of a disk that takes nothing.
constexpr double COMPLAINT_PERIOD = 10;

}  // namespace

CheckpointServer::CheckpointServer(ros::NodeHandle& node, const NodeSettings& settings, const SceneKey& key,
                                   SteppingTasks& tasks, Doors doors)
    : start_(settings.restore),
      period_(std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(settings.autosave))),
      tasks_(tasks),
      doors_(std::move(doors)),
      checkpoints_(settings.checkpoint_folder, key, settings.scene.solver.threads),
      since_(steadyNow()),
      save_service_(node.advertiseService("save", &CheckpointServer::saveService, this)),
      restore_service_(node.advertiseService("restore", &CheckpointServer::restoreService, this)) {}

void CheckpointServer::restoreAtStart() {
  if (start_.empty()) return;
  std::string name = start_;
  if (start_ == LAST_CHECKPOINT) {
    std::vector<std::string> passed_over;
    const auto newest = checkpoints_.newest(&passed_over);
    for (const std::string& why : passed_over) ROS_WARN_STREAM("passed over a checkpoint: " << why);
    if (!newest) {
      ROS_INFO_STREAM("there is no checkpoint yet: starts at step 0");
      return;
    }
    name = newest->name;
    doors_.restore(newest->state);
  } else {
    doors_.restore(checkpoints_.find(start_));
  }
  ROS_INFO_STREAM("goes on from the checkpoint '" << name << "' at step " << doors_.step());
}

void CheckpointServer::offer(SteadyTime now, std::uint64_t version) {
  if (period_.count() == 0) return;
  if (saving_.valid()) {
    if (saving_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    std::optional<std::chrono::nanoseconds> took;
    try {
      took = saving_.get();
    } catch (const std::bad_alloc&) {  // there was no memory to tell of it either
    }
    if (took)
      took_ = *took;
    else
      saved_.reset();
  }
  // So early that the next one is on the disk before this one is older than the period.
  if (now < since_ + std::max(period_ / 2, period_ - 2 * took_)) return;
  since_ = now;
  const auto at = std::make_pair(doors_.step(), version);
  if (saved_ == at) return;
  try {
    saving_ = std::async(std::launch::async, [this, state = doors_.save()] { return autosave(state); });
    saved_ = at;
  } catch (const std::exception& error) {  // of memory, or of threads
    ROS_WARN_STREAM_THROTTLE(COMPLAINT_PERIOD, "could not be saved: " << whyOf(error));
  }
}

std::optional<std::chrono::nanoseconds> CheckpointServer::autosave(const SavedState& state) {
  const SteadyTime start = steadyNow();
  try {
    checkpoints_.autosave(state);
    return steadyNow() - start;
  } catch (const std::exception& error) {  // of the disk, or of memory
    ROS_WARN_STREAM_THROTTLE(COMPLAINT_PERIOD, "could not be saved, and is tried again: " << whyOf(error));
    return std::nullopt;
  }
}

bool CheckpointServer::onSteppingThread(const std::function<void()>& task, Service::Response* response) {
  return tasks_.ask([&] {
    try {
      task();
      response->step = doors_.step();
      response->success = true;
    } catch (const std::exception& error) {
      response->message = whyOf(error);
    }
  });
}

bool CheckpointServer::saveService(Service::Request& request, Service::Response& response) {
  try {
    SavedState state;
    if (!onSteppingThread([&] { state = doors_.save(); }, &response)) return false;
    if (!std::exchange(response.success, false)) return true;
    const std::vector<std::string> gone = checkpoints_.save(request.name, state);
    response.success = true;  // also where there is no memory left to say more
    response.message = "saved at step " + std::to_string(response.step);
    if (!gone.empty()) response.message += "; no longer in memory: " + joined(gone);
  } catch (const std::exception& error) {
    if (!response.success) response.message = whyOf(error);
  }
  return true;
}

bool CheckpointServer::restoreService(Service::Request& request, Service::Response& response) {
  try {
    const SavedState state = checkpoints_.find(request.name);
    if (!onSteppingThread([&] { doors_.restore(state); }, &response)) return false;
    if (response.success) response.message = "at step " + std::to_string(response.step);
  } catch (const std::exception& error) {
    response.message = whyOf(error);
  }
  return true;
}

}  // namespace incision

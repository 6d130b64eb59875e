#pragma once

#include <incision/Checkpoint.h>
#include <ros/node_handle.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <future>
#include <optional>
#include <string>
#include <utility>

#include "incision/pace/command.h"
#include "incision/pace/stepping_tasks.h"
#include "incision/ros/parameters.h"
#include "incision/run/checkpoints.h"

namespace incision {

/// The services `~save` and `~restore`, what is saved every `~autosave` seconds, and what the node starts from with
/// `~restore`. The stepping thread only copies the body's bytes or reads them; packing, files and disks are the
/// business of the services' thread and of one for the automatic saving.
class CheckpointServer {
 public:
  /// What the stepping thread can do.
  struct Doors {
    std::function<SavedState()> save;
    std::function<void(const SavedState&)> restore;  ///< throws InputError, with nothing changed
    std::function<std::int64_t()> step;
  };

  /// `key`: of the body. Throws InputError where `~checkpoint_folder` cannot be used.
  CheckpointServer(ros::NodeHandle& node, const NodeSettings& settings, const SceneKey& key, SteppingTasks& tasks,
                   Doors doors);

  /// Restores what the parameter `~restore` asks for, if any. On the thread of the steps, before the first.
  void restoreAtStart();

  /// On the stepping thread, between steps: saves the body when it is time, unless it is as it was (`version`), or the
  /// disk still takes the last one.
  void offer(SteadyTime now, std::uint64_t version);

 private:
  using Service = Checkpoint;
  bool saveService(Service::Request& request, Service::Response& response);
  bool restoreService(Service::Request& request, Service::Response& response);
  bool onSteppingThread(const std::function<void()>& task, Service::Response* response);
  std::optional<std::chrono::nanoseconds> autosave(const SavedState& state);

  const std::string start_;
  const std::chrono::nanoseconds period_;
  SteppingTasks& tasks_;
  const Doors doors_;
  Checkpoints checkpoints_;
  SteadyTime since_;  // the last automatic saving
  std::chrono::nanoseconds took_{0};
  std::optional<std::pair<std::int64_t, std::uint64_t>> saved_;  // by it: step and version
  ros::ServiceServer save_service_, restore_service_;
  // The thread of the last automatic saving, and how long it took, or that it failed. Last: it uses all of the above.
  std::future<std::optional<std::chrono::nanoseconds>> saving_;
};

}  // namespace incision

#pragma once

#include <rosgraph_msgs/Clock.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <memory>
#include <string>
#include <vector>

#include "incision/pace/clamp_tracker.h"
#include "incision/pace/link_tracker.h"
#include "incision/pace/pacer.h"
#include "incision/pace/real_time_factor.h"
#include "incision/pace/stepping_tasks.h"
#include "incision/ros/checkpoint_server.h"
#include "incision/ros/command_input.h"
#include "incision/ros/marker_publisher.h"
#include "incision/ros/tool_driver.h"

namespace incision {

/// The ROS node: owns the body and takes its steps. Everything is in the node's private namespace.
///
/// The thread that calls run() alone touches the body. Commands are received and checked by the thread of
/// CommandInput, services are answered by the global queue's, markers are built by MarkerPublisher's.
class IncisionNode {
 public:
  /// Throws InputError when the parameters do not give a body.
  IncisionNode();
  ~IncisionNode();

  /// Takes steps until ROS shuts down.
  void run();

 private:
  using SetBool = std_srvs::SetBool;
  using Trigger = std_srvs::Trigger;

  bool pauseService(SetBool::Request& request, SetBool::Response& response);
  bool stepService(Trigger::Request& request, Trigger::Response& response);
  bool resetService(Trigger::Request& request, Trigger::Response& response);
  void setPaused(bool paused);
  void reset();
  void dropWaiting(const std::string& why, const std::vector<bool>& active = {});
  void startAnew();
  SavedState save() const;
  void restore(const SavedState& state);

  bool applyCuts(bool step_due);
  void applyCut(const PlaneCut& plane);
  StepTime stepTime() const;
  void leadTools(const StepTime& time);
  void moveObstacles(const StepTime& time);
  void moveClamps(const StepTime& time);
  bool stepDue();
  void step();
  bool tryStep();
  void stepFailed(const std::string& why);
  void reportChanges();
  bool wantsRegionStress() const;
  void publishState();

  ros::NodeHandle node_{"~"};
  NodeSettings settings_;
  DeformableBody body_;
  std::unique_ptr<Pacer> pacer_;

  Wakeup wakeup_;
  SteppingTasks tasks_;
  Agenda agenda_;
  Reporter reporter_;
  MarkerPublisher markers_;
  RealTimeFactor real_time_factor_;
  StepResult last_step_;
  std::string error_;
  bool paused_ = false;
  SteadyTime next_heartbeat_;

  ros::Publisher state_;
  ros::Subscriber clock_;
  ros::ServiceServer pause_service_, step_service_, reset_service_;
  CommandInput input_;
  LinkTracker obstacles_;
  ClampTracker clamps_;
  std::vector<ToolDriver> tools_;
  CheckpointServer checkpoints_;
  ros::AsyncSpinner spinner_;
};

}  // namespace incision

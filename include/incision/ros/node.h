#pragma once

#include <rosgraph_msgs/Clock.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <memory>
#include <string>
#include <vector>

#include "incision/pace/pace_watch.h"
#include "incision/pace/pacer.h"
#include "incision/pace/real_time_factor.h"
#include "incision/pace/slowness.h"
#include "incision/pace/step_input.h"
#include "incision/pace/stepping_tasks.h"
#include "incision/ros/checkpoint_server.h"
#include "incision/ros/command_input.h"
#include "incision/ros/diagnostics.h"
#include "incision/ros/marker_publisher.h"
#include "incision/ros/publishing_thread.h"
#include "incision/ros/reconfigure.h"
#include "incision/ros/reporter.h"
#include "incision/ros/state_publisher.h"
#include "incision/ros/tool_publisher.h"
#include "incision/run/first_steps.h"

namespace incision {

/// The ROS node: owns the body and takes its steps. Everything is in the node's private namespace.
///
/// The thread that calls run() alone touches the body. Commands are received and checked by the thread of
/// CommandInput, services are answered by the global queue's, markers are built by MarkerPublisher's, messages are sent
/// by PublishingThread's and StatePublisher's, and Diagnostics' tells how it goes.
class IncisionNode {
 public:
  /// Throws InputError when the parameters do not give a body.
  IncisionNode();
  /// Answers the cuts that wait.
  ~IncisionNode();

  /// Takes steps until the node is asked to end.
  void run();

 private:
  using SetBool = std_srvs::SetBool;
  using Trigger = std_srvs::Trigger;

  bool pauseService(SetBool::Request& request, SetBool::Response& response);
  bool stepService(Trigger::Request& request, Trigger::Response& response);
  bool resetService(Trigger::Request& request, Trigger::Response& response);
  void setPaused(bool paused);
  void restartPace();
  void reset();
  void startAnew();
  SavedState save() const;
  void restore(const SavedState& state);

  template <class Part>
  void guarded(const Part& part);
  void step();
  bool tryStep();
  void tellStep();
  void stepFailed(const char* why);
  void reportChanges();
  bool wantsRegionStress() const;
  void publishState();
  void tellCondition();
  void tellSlowness();
  void set(const NodeLiveSettings& settings);

  ros::NodeHandle node_{"~"};
  NodeSettings settings_;
  DeformableBody body_;
  std::unique_ptr<Pacer> pacer_;

  Wakeup wakeup_;
  PublishingThread publishing_;
  SteppingTasks tasks_;
  Reporter reporter_;
  MarkerPublisher markers_;
  RealTimeFactor real_time_factor_;
  FirstSteps first_steps_;
  Slowness slowness_;
  StepResult last_step_;
  std::string error_;
  SteadyTime next_heartbeat_;

  StatePublisher state_;
  ros::Subscriber clock_;
  ros::ServiceServer pause_service_, step_service_, reset_service_;
  CommandInput input_;
  StepInput step_input_;
  PaceWatch watch_;
  std::vector<ToolPublisher> tools_;
  Reconfigure reconfigure_;
  CheckpointServer checkpoints_;
  Diagnostics diagnostics_;
  ros::AsyncSpinner spinner_;
};

}  // namespace incision

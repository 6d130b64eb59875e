#pragma once

#include <dynamic_reconfigure/Reconfigure.h>
#include <ros/node_handle.h>

#include <functional>
#include <string>

#include "incision/pace/command.h"
#include "incision/pace/stepping_tasks.h"
#include "incision/ros/live_config.h"
#include "incision/ros/publishing_thread.h"

namespace incision {

/// Lets the clients of dynamic_reconfigure set anew what may change while the node runs, and the messages of a bag,
/// which come on `~parameters`. A request with anything wrong in it changes nothing and is told of, where
/// dynamic_reconfigure::Server would put the nearest value that is allowed in its place; the answer, and
/// `~parameter_updates`, are what holds. Nor are values left on the parameter server, from where the node's next start
/// would take them for those of the scene.
class Reconfigure {
 public:
  /// Both are called on the stepping thread.
  using Apply = std::function<void(const NodeLiveSettings&)>;
  using Refuse = std::function<void(const Refused&)>;

  /// The tasks and the thread must outlive this.
  Reconfigure(const ros::NodeHandle& node, const NodeLiveSettings& at_start, SteppingTasks& tasks,
              PublishingThread* thread, Apply apply, Refuse refuse);

  /// On the stepping thread: the body has got these in another way.
  void show(const LiveSettings& body);

 private:
  using Service = dynamic_reconfigure::Reconfigure;

  bool answer(Service::Request& request, Service::Response& response);
  void receive(const dynamic_reconfigure::Config& message);
  void take(const dynamic_reconfigure::Config& message, const std::string& source);
  void publish();

  SteppingTasks& tasks_;
  PublishingThread* thread_;
  const Apply apply_;
  const Refuse refuse_;
  NodeLiveSettings now_;  // the stepping thread's
  ros::NodeHandle node_;
  ros::Publisher descriptions_;
  Outlet<dynamic_reconfigure::Config> updates_;
  ros::ServiceServer service_;
  ros::Subscriber subscriber_;
};

}  // namespace incision

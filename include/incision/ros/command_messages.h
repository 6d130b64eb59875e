#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <incision/CutPlane.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/Bool.h>

#include <functional>
#include <string>
#include <vector>

#include "incision/body/deformable_body.h"
#include "incision/pace/commands.h"
#include "incision/ros/validation.h"

namespace incision {

/// What is done with a message that has come.
template <class Message>
using Receiver = std::function<void(const Message& message, SteadyTime received)>;

/// Checks the messages of a scene's topics; of those that are commands it makes commands, the others it has refused.
/// The node's subscribers and what reads a bag share it. Only one thread at a time may use it.
class CommandMessages {
 public:
  /// `commands` and `answers` must outlive this.
  CommandMessages(const DeformableBody& body, Commands& commands, Answers& answers);

  /// Calls visit(topic, receiver) for each topic, by its name below the node's; a receiver says by its type what
  /// message the topic has.
  template <class Visit>
  void forEachTopic(const Visit& visit);

 private:
  struct Tool {
    std::string name;
    bool has_frame;  ///< from which its pose comes, and in no message
    std::optional<Jaw> jaw;
  };
  void receiveCut(const CutPlane& message, SteadyTime received);
  void receivePose(int tool, const geometry_msgs::PoseStamped& message, SteadyTime received);
  void receiveJaw(int tool, const sensor_msgs::JointState& message, SteadyTime received);

  const std::string body_frame_;
  std::vector<Tool> tools_;
  Commands& commands_;
  Answers& answers_;
};

template <class Visit>
void CommandMessages::forEachTopic(const Visit& visit) {
  visit("cut_plane", Receiver<CutPlane>([this](const auto& message, auto time) { receiveCut(message, time); }));
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    const auto tool = static_cast<int>(i);
    const std::string& name = tools_[i].name;
    if (!tools_[i].has_frame)
      visit(name + "/servo_cp", Receiver<geometry_msgs::PoseStamped>([this, tool](const auto& message, auto time) {
              receivePose(tool, message, time);
            }));
    visit(name + "/active", Receiver<std_msgs::Bool>([this, tool](const auto& message, auto) {
            commands_.activate(tool, message.data != 0);
          }));
    if (tools_[i].jaw)
      visit(name + "/jaw/servo_jp", Receiver<sensor_msgs::JointState>([this, tool](const auto& message, auto time) {
              receiveJaw(tool, message, time);
            }));
  }
}

}  // namespace incision

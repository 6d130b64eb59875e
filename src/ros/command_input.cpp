#include "incision/ros/command_input.h"

#include "incision/ros/validation.h"

namespace incision {
namespace {

ros::NodeHandle withQueue(ros::NodeHandle node, ros::CallbackQueue& queue) {
  node.setCallbackQueue(&queue);
  return node;
}

}  // namespace

CommandInput::CommandInput(ros::NodeHandle& node, const NodeSettings& settings, Agenda& agenda, Reporter& reporter,
                           Wakeup& wakeup)
    : has_tool_(settings.scene.tool.has_value()),
      use_sim_time_(ros::Time::isSimTime()),
      body_frame_(settings.scene.body.frame),
      agenda_(agenda),
      reporter_(reporter),
      wakeup_(wakeup),
      listener_(buffer_, node),
      transforms_(
          buffer_, body_frame_, settings.transform_timeout, [this](const Command& command) { release(command); },
          [this](const Command& command, const Refused& refused) { refuse(command, refused); }),
      spinner_(1, &callbacks_) {
  ros::NodeHandle commands = withQueue(node, callbacks_);
  const auto hints = ros::TransportHints().tcpNoDelay();
  cuts_ = commands.subscribe("cut_plane", MESSAGE_QUEUE, &CommandInput::receiveCut, this, hints);
  if (!has_tool_ || settings.scene.tool->frame.empty())
    poses_ = commands.subscribe("tool_pose", MESSAGE_QUEUE, &CommandInput::receivePose, this, hints);
  active_ = commands.subscribe("tool_active", MESSAGE_QUEUE, &CommandInput::receiveActive, this, hints);
  poll_ = commands.createWallTimer(
      ros::WallDuration(TRANSFORM_POLL),
      [this](const ros::WallTimerEvent&) {
        transforms_.poll(std::chrono::steady_clock::now());
        wakeup_.notify();  // a step may have waited for them
        if (transforms_.empty()) poll_.stop();
      },
      false, false);
  spinner_.start();
}

bool CommandInput::waitsFor(Nanoseconds time) const {
  const std::optional<Nanoseconds> earliest = transforms_.earliestStamp();
  return earliest && *earliest <= time;
}

void CommandInput::clear(const Refused& refused) { transforms_.clear(refused); }

void CommandInput::receiveCut(const CutPlane& message) {
  if (const auto refused = whyRefused(message))
    reporter_.refuseCut(message.label, *refused);
  else
    accept(toCommand(message, body_frame_, std::chrono::steady_clock::now()));
}

void CommandInput::receivePose(const geometry_msgs::PoseStamped& message) {
  if (!has_tool_)
    reporter_.refuseTool({Refusal::NO_TOOL, "tool_pose: the scene has no tool"});
  else if (const auto refused = whyRefused(message))
    reporter_.refuseTool(*refused);
  else
    accept(toCommand(message, body_frame_, std::chrono::steady_clock::now()));
}

void CommandInput::receiveActive(const std_msgs::Bool& message) {
  if (has_tool_)
    agenda_.activate(message.data);
  else
    reporter_.refuseTool({Refusal::NO_TOOL, "tool_active: the scene has no tool"});
}

void CommandInput::accept(const Command& command) {
  transforms_.add(command);
  if (!transforms_.empty()) poll_.start();
}

void CommandInput::release(const Command& command) {
  const Nanoseconds stamp = use_sim_time_ ? command.stamp : 0;
  if (const auto* plane = std::get_if<PlaneCut>(&command.action)) {
    if (const auto left_out = agenda_.add(*plane, stamp))
      reporter_.refuseCut(left_out->label, {Refusal::TOO_MANY, "too many cuts wait for their step"});
    wakeup_.notify();
  } else {  // waits for the next step, of which nobody needs to be told
    const auto received = std::chrono::nanoseconds(command.received.time_since_epoch()).count();
    agenda_.add({std::get<Pose>(command.action), use_sim_time_ ? stamp : received, command.received}, stamp);
  }
}

void CommandInput::refuse(const Command& command, const Refused& refused) {
  if (const auto* plane = std::get_if<PlaneCut>(&command.action))
    reporter_.refuseCut(plane->label, refused);
  else
    reporter_.refuseTool(refused);
}

}  // namespace incision

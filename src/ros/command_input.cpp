#include "incision/ros/command_input.h"

#include "incision/ros/validation.h"

namespace incision {
namespace {

ros::NodeHandle withQueue(ros::NodeHandle node, ros::CallbackQueue& queue) {
  node.setCallbackQueue(&queue);
  return node;
}

}  // namespace

CommandInput::CommandInput(ros::NodeHandle& node, const NodeSettings& settings, const DeformableBody& body,
                           Agenda& agenda, Reporter& reporter, Wakeup& wakeup)
    : use_sim_time_(ros::Time::isSimTime()),
      body_frame_(settings.scene.body.frame),
      agenda_(agenda),
      reporter_(reporter),
      wakeup_(wakeup),
      listener_(buffer_, node),
      frames_(buffer_, body_frame_),
      transforms_(
          frames_, settings.transform_timeout, [this](const Command& command) { release(command); },
          [this](const Command& command, const Refused& refused) { refuse(command, refused); }),
      spinner_(1, &callbacks_) {
  ros::NodeHandle commands = withQueue(node, callbacks_);
  subscribe<CutPlane>(commands, "cut_plane", [this](const CutPlane& message) { receiveCut(message); });
  for (std::size_t i = 0; i < settings.scene.tools.size(); ++i)
    subscribeToTool(commands, static_cast<int>(i), settings.scene.tools[i], body.toolForm(i));
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

template <class Message, class Receive>
void CommandInput::subscribe(ros::NodeHandle& node, const std::string& topic, Receive receive) {
  subscribers_.push_back(node.subscribe<Message>(
      topic, MESSAGE_QUEUE, [receive](const boost::shared_ptr<const Message>& message) { receive(*message); },
      ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay()));
}

void CommandInput::subscribeToTool(ros::NodeHandle& node, int tool, const ToolSettings& settings,
                                   const ToolForm& form) {
  if (settings.frame.empty())
    subscribe<geometry_msgs::PoseStamped>(
        node, settings.name + "/servo_cp",
        [this, tool](const geometry_msgs::PoseStamped& message) { receivePose(tool, message); });
  subscribe<std_msgs::Bool>(node, settings.name + "/active",
                            [this, tool](const std_msgs::Bool& message) { agenda_.activate(tool, message.data != 0); });
  if (!settings.jaw) return;
  const Jaw jaw = {settings.jaw->joint, form.jaw};
  subscribe<sensor_msgs::JointState>(
      node, settings.name + "/jaw/servo_jp",
      [this, tool, jaw](const sensor_msgs::JointState& message) { receiveJaw(tool, jaw, message); });
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

void CommandInput::receivePose(int tool, const geometry_msgs::PoseStamped& message) {
  if (const auto refused = whyRefused(message))
    reporter_.refuseTool(tool, *refused);
  else
    accept(toCommand(message, tool, body_frame_, std::chrono::steady_clock::now()));
}

/// Needs no transform.
void CommandInput::receiveJaw(int tool, const Jaw& jaw, const sensor_msgs::JointState& message) {
  if (const auto refused = whyRefused(message, jaw)) {
    reporter_.refuseTool(tool, *refused);
    return;
  }
  const auto stamp = static_cast<Nanoseconds>(message.header.stamp.toNSec());
  const Nanoseconds time = timeOf(stamp, std::chrono::steady_clock::now());
  agenda_.add(tool, ReceivedAngle{message.position[0], time}, use_sim_time_ ? stamp : 0);
}

/// By which what leads a tool grows old.
Nanoseconds CommandInput::timeOf(Nanoseconds stamp, SteadyTime received) const {
  return use_sim_time_ ? stamp : std::chrono::nanoseconds(received.time_since_epoch()).count();
}

void CommandInput::accept(const Command& command) {
  transforms_.add(command);
  if (!transforms_.empty()) poll_.start();
}

void CommandInput::release(const Command& command) {
  const Nanoseconds stamp = use_sim_time_ ? command.stamp : 0;
  if (const auto* plane = std::get_if<PlaneCut>(&command.action)) {
    if (const auto put_out = agenda_.add(*plane, stamp))
      reporter_.refuseCut(put_out->label, {Refusal::TOO_MANY, "too many cuts wait for their step"});
    wakeup_.notify();
  } else {  // waits for the next step, of which nobody needs to be told
    const auto& asked = std::get<ToolPose>(command.action);
    const Nanoseconds time = timeOf(command.stamp, command.received);
    agenda_.add(asked.tool, ReceivedPose{asked.pose, time, command.received}, stamp);
  }
}

void CommandInput::refuse(const Command& command, const Refused& refused) {
  if (const auto* plane = std::get_if<PlaneCut>(&command.action))
    reporter_.refuseCut(plane->label, refused);
  else
    reporter_.refuseTool(std::get<ToolPose>(command.action).tool, refused);
}

}  // namespace incision

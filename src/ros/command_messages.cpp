#include "incision/ros/command_messages.h"

namespace incision {
namespace {

/// Does what a message asks for, or answers that there is no memory for it: a message must not end its thread.
template <class Take, class Refuse>
void take(const Take& take, const Refuse& refuse) {
  try {
    take();
  } catch (const std::bad_alloc&) {
    refuse(Refused{Refusal::BY_BODY, "memory ran out"});
  }
}

}  // namespace

CommandMessages::CommandMessages(const DeformableBody& body, Commands& commands, Answers& answers)
    : body_frame_(body.scene().body.frame), commands_(commands), answers_(answers) {
  for (std::size_t i = 0; i < body.tools(); ++i) {
    const ToolSettings& tool = body.scene().tools[i];
    tools_.push_back({tool.name, !tool.frame.empty(), {}});
    if (tool.jaw) tools_.back().jaw = {tool.jaw->joint, body.toolForm(i).jaw};
  }
}

void CommandMessages::receiveCut(const CutPlane& message, SteadyTime received) {
  take(
      [&] {
        if (const auto refused = whyRefused(message))
          answers_.refuseCut(message.label, *refused);
        else
          commands_.add(toCommand(message, body_frame_, received));
      },
      [&](const Refused& refused) { answers_.refuseCut(message.label, refused); });
}

void CommandMessages::receivePose(int tool, const geometry_msgs::PoseStamped& message, SteadyTime received) {
  take(
      [&] {
        if (const auto refused = whyRefused(message))
          answers_.refuseTool(tool, *refused);
        else
          commands_.add(toCommand(message, tool, body_frame_, received));
      },
      [&](const Refused& refused) { answers_.refuseTool(tool, refused); });
}

/// Needs no transform.
void CommandMessages::receiveJaw(int tool, const sensor_msgs::JointState& message, SteadyTime received) {
  take(
      [&] {
        if (const auto refused = whyRefused(message, *tools_[static_cast<std::size_t>(tool)].jaw))
          answers_.refuseTool(tool, *refused);
        else
          commands_.add(tool, message.position[0], static_cast<Nanoseconds>(message.header.stamp.toNSec()), received);
      },
      [&](const Refused& refused) { answers_.refuseTool(tool, refused); });
}

}  // namespace incision

#include "incision/pace/commands.h"

#include "incision/base/printable.h"

namespace incision {
namespace {

std::string ofTool(const char* what, const std::string& tool) { return what + (" of the tool '" + tool + "'"); }

std::string ofCut(const PlaneCut& plane) { return "the cut '" + printable(plane.label) + "'"; }

}  // namespace

CommandSettings commandSettings(const Scene& scene, bool by_stamp, double transform_timeout) {
  CommandSettings settings;
  for (const ToolSettings& tool : scene.tools) settings.tools.push_back(tool.name);
  settings.by_stamp = by_stamp;
  settings.transform_timeout = transform_timeout;
  return settings;
}

Commands::Commands(const CommandSettings& settings, const Frames& frames, Answers& answers, Wakeup& wakeup)
    : settings_(settings),
      answers_(answers),
      wakeup_(wakeup),
      agenda_(settings.tools.size()),
      transforms_(
          frames, settings.transform_timeout, [this](const Command& command) { release(command); },
          [this](const Command& command, const Refused& refused) { refuse(command, refused); }) {}

void Commands::add(const Command& command) { transforms_.add(command); }

void Commands::add(int tool, double angle, Nanoseconds stamp, SteadyTime received) {
  agenda_.add(tool, ReceivedAngle{angle, timeOf(stamp, received), received}, settings_.by_stamp ? stamp : 0);
}

void Commands::activate(int tool, bool active) { agenda_.activate(tool, active); }

/// By which what leads a tool grows old.
Nanoseconds Commands::timeOf(Nanoseconds stamp, SteadyTime received) const {
  return settings_.by_stamp ? stamp : std::chrono::nanoseconds(received.time_since_epoch()).count();
}

void Commands::release(const Command& command) {
  const Nanoseconds stamp = settings_.by_stamp ? command.stamp : 0;
  if (const auto* plane = std::get_if<PlaneCut>(&command.action)) {
    if (const auto put_out = agenda_.add(*plane, stamp, command.received))
      answers_.refuseCut(put_out->label, {Refusal::TOO_MANY, "too many cuts wait for their step"});
    wakeup_.notify();
  } else {  // waits for the next step, of which nobody needs to be told
    const auto& asked = std::get<ToolPose>(command.action);
    const Nanoseconds time = timeOf(command.stamp, command.received);
    agenda_.add(asked.tool, ReceivedPose{asked.pose, time, command.received}, stamp);
  }
}

void Commands::refuse(const Command& command, const Refused& refused) {
  if (const auto* plane = std::get_if<PlaneCut>(&command.action))
    answers_.refuseCut(plane->label, refused);
  else
    answers_.refuseTool(std::get<ToolPose>(command.action).tool, refused);
}

void Commands::poll(SteadyTime now) {
  transforms_.poll(now);
  wakeup_.notify();  // a step may have waited for them
}

bool Commands::waitsFor(Nanoseconds time) const {
  const std::optional<Nanoseconds> earliest = transforms_.earliestStamp();
  return earliest && *earliest <= time;
}

/// In this order: what leaves the one for the other meanwhile is met there.
void Commands::refuseAll(const Refused& refused, const IsActive& isActive) noexcept {
  transforms_.clear(refused);
  agenda_.clearTools(isActive);
  while (const auto cut = agenda_.takeCut()) answers_.refuseCut(cut->plane.label, refused);
}

std::string Commands::nameOf(const Command& command) const {
  if (const auto* plane = std::get_if<PlaneCut>(&command.action)) return ofCut(*plane);
  return ofTool("a pose", settings_.tools[static_cast<std::size_t>(std::get<ToolPose>(command.action).tool)]);
}

std::optional<WaitingCommand> Commands::longestWaiting(Nanoseconds clock) const {
  std::optional<WaitingCommand> longest;
  const auto offer = [&](const WaitingCommand& command) {
    if (!longest || command.received < longest->received) longest = command;
  };
  if (const auto first = transforms_.first()) offer({nameOf(*first), first->frame, first->stamp, first->received});
  if (const auto cut = agenda_.firstCutAfter(clock)) offer({ofCut(cut->plane), "", cut->stamp, cut->received});
  for (std::size_t i = 0; i < settings_.tools.size(); ++i)
    if (const auto received = agenda_.firstOfToolAfter(static_cast<int>(i), clock))
      offer({ofTool("what was asked", settings_.tools[i]), "", received->stamp, received->received});
  return longest;
}

}  // namespace incision

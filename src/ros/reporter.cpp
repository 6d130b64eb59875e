#include "incision/ros/reporter.h"

#include <ros/console.h>

#include "incision/base/printable.h"
#include "incision/pace/agenda.h"
#include "incision/pace/transform_queue.h"
#include "incision/ros/conversions.h"

namespace incision {
namespace {

/// Reports that may wait for a slow subscriber: of all cuts that may wait here, which a reset answers at once, and of
/// as many more.
constexpr std::uint32_t REPORT_QUEUE = 2 * (MAX_WAITING_CUTS + MAX_WAITING_FOR_TRANSFORM);

/// How long the node stays, when it ends, for reports to leave: what has not been read then waits in the subscribers'
/// sockets, which hold more than all reports there can be. Writing these takes a few milliseconds.
constexpr double FLUSH_TIME = 0.2;

/// Where there is no memory for a report, it is tried again after so long [s], so often: another program may give some
/// back, and who asked for a cut waits for the report.
constexpr double MEMORY_PAUSE = 0.01;
constexpr int MEMORY_TRIALS = 100;

/// What is only told does no harm where there is no memory to tell it.
template <class Tell>
void tellIfPossible(const Tell& tell) {
  try {
    tell();
  } catch (const std::bad_alloc&) {
  }
}

}  // namespace

Reporter::Reporter(ros::NodeHandle& node, const Scene& scene, PublishingThread* thread)
    : body_frame_(scene.body.frame),
      thread_(thread),
      cut_reports_(thread, node.advertise<CutReport>("cut_report", REPORT_QUEUE, true), MessageQueue<CutReport>::ALL),
      of_tools_(scene.tools.size()) {
  for (const ToolSettings& tool : scene.tools) tools_.push_back(tool.name);
  if (scene.fracture)
    crack_events_ = {thread, node.advertise<CrackEvent>("crack_event", REPORT_QUEUE), MessageQueue<CrackEvent>::ALL};
}

void Reporter::setPieces(int pieces) { pieces_ = pieces; }

void Reporter::report(const CutResult& result) {
  if (result.status == CutStatus::REJECTED) {
    count(Refusal::BY_BODY);
    tellIfPossible([&] {
      warnOfRefused("a cut", "the cut '" + printable(result.label) + "'", {Refusal::BY_BODY, result.reason});
    });
  }
  // Where the pieces could not be counted there are still those that were.
  if (result.pieces > 0) setPieces(result.pieces);
  publish(result);
}

void Reporter::report(const CrackResult& result) {
  if (result.change == CrackChange::STOPPED) warn("stopped cracks", "a limit of parts or copies stopped a crack");
  if (!crack_events_.wanted()) return;
  giveInTime([&] {
    crack_events_.give([&](CrackEvent* event) {
      *event = toEvent(result);
      event->header.stamp = ros::Time::now();
      event->header.frame_id = body_frame_;
    });
  });
}

/// Gives a message to those who listen, as soon as there is memory for it.
template <class Give>
void Reporter::giveInTime(const Give& give) {
  for (int trial = 0; trial < MEMORY_TRIALS; ++trial) {
    try {
      give();
      break;
    } catch (const std::bad_alloc&) {
      ros::WallDuration(MEMORY_PAUSE).sleep();
    }
  }
  thread_->flush();
}

void Reporter::refuseCut(const std::string& label, const Refused& refused) {
  count(refused.kind);
  tellIfPossible([&] { warnOfRefused("a cut", "the cut '" + printable(label.substr(0, MAX_LABEL)) + "'", refused); });
  giveInTime([&] {
    CutResult result;
    result.label = label.substr(0, MAX_LABEL);
    result.status = CutStatus::REJECTED;
    result.reason = refused.reason;
    result.pieces = pieces_;
    give(result);
  });
}

void Reporter::refuseTool(int tool, const Refused& refused) {
  ++of_tools_[static_cast<std::size_t>(tool)];
  count(refused.kind);
  tellIfPossible([&] {
    const std::string whose = "a message to the tool '" + tools_[static_cast<std::size_t>(tool)] + "'";
    warnOfRefused(whose, whose, refused);
  });
}

void Reporter::refuseSettings(const Refused& refused) {
  count(refused.kind);
  tellIfPossible([&] { warnOfRefused("what was to be set anew", "what was to be set anew", refused); });
}

void Reporter::warnOfRefused(const std::string& about, const std::string& what, const Refused& refused) {
  warn("refused " + about, "refused " + what + ": " + refused.reason);
}

void Reporter::warn(const std::string& about, const std::string& text) {
  tellIfPossible([&] {
    if (throttle_.lets(about, steadyNow())) ROS_WARN_STREAM(text);
  });
}

void Reporter::inform(const std::string& text) {
  tellIfPossible([&] { ROS_INFO_STREAM(text); });
}

void Reporter::flush() {
  thread_->sendAll();
  if (cut_reports_.wanted()) ros::WallDuration(FLUSH_TIME).sleep();
}

void Reporter::publish(const CutResult& result) {
  giveInTime([&] { give(result); });
}

void Reporter::give(const CutResult& result) {
  cut_reports_.give([&](CutReport* report) {
    *report = toReport(result);
    report->header.stamp = ros::Time::now();
    report->header.frame_id = body_frame_;
  });
}

std::array<std::uint64_t, NUM_REFUSALS> Reporter::counts() const {
  std::array<std::uint64_t, NUM_REFUSALS> counts;
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = counts_[i];
  return counts;
}

void Reporter::fillState(BodyState& state) const {
  const auto count = [this](Refusal kind) { return counts_[static_cast<int>(kind)].load(); };
  state.rejected_not_finite = count(Refusal::NOT_FINITE);
  state.rejected_out_of_range = count(Refusal::OUT_OF_RANGE);
  state.rejected_no_transform = count(Refusal::NO_TRANSFORM);
  state.rejected_overflow = count(Refusal::TOO_MANY);
  state.rejected_by_body = count(Refusal::BY_BODY);
  state.rejected_by_reset = count(Refusal::BY_RESET);
}

}  // namespace incision

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
  if (result.status == CutStatus::REJECTED)
    count("a cut", "the cut '" + printable(result.label) + "'", {Refusal::BY_BODY, result.reason});
  setPieces(result.pieces);
  publish(result);
}

void Reporter::report(const CrackResult& result) {
  if (result.change == CrackChange::STOPPED) warn("stopped cracks", "a limit of parts or copies stopped a crack");
  if (!crack_events_.wanted()) return;
  crack_events_.give([&](CrackEvent* event) {
    *event = toEvent(result);
    event->header.stamp = ros::Time::now();
    event->header.frame_id = body_frame_;
  });
  thread_->flush();
}

void Reporter::refuseCut(const std::string& label, const Refused& refused) {
  count("a cut", "the cut '" + printable(label.substr(0, MAX_LABEL)) + "'", refused);
  CutResult result;
  result.label = label.substr(0, MAX_LABEL);
  result.status = CutStatus::REJECTED;
  result.reason = refused.reason;
  result.pieces = pieces_;
  publish(result);
}

void Reporter::refuseTool(int tool, const Refused& refused) {
  ++of_tools_[static_cast<std::size_t>(tool)];
  const std::string whose = "a message to the tool '" + tools_[static_cast<std::size_t>(tool)] + "'";
  count(whose, whose, refused);
}

void Reporter::refuseSettings(const Refused& refused) {
  count("what was to be set anew", "what was to be set anew", refused);
}

void Reporter::count(const std::string& about, const std::string& what, const Refused& refused) {
  ++counts_[static_cast<int>(refused.kind)];
  warn("refused " + about, "refused " + what + ": " + refused.reason);
}

void Reporter::warn(const std::string& about, const std::string& text) {
  if (throttle_.lets(about, std::chrono::steady_clock::now())) ROS_WARN_STREAM(text);
}

void Reporter::inform(const std::string& text) { ROS_INFO_STREAM(text); }

void Reporter::flush() {
  thread_->sendAll();
  if (cut_reports_.wanted()) ros::WallDuration(FLUSH_TIME).sleep();
}

void Reporter::publish(const CutResult& result) {
  cut_reports_.give([&](CutReport* report) {
    *report = toReport(result);
    report->header.stamp = ros::Time::now();
    report->header.frame_id = body_frame_;
  });
  thread_->flush();
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

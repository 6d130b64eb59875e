#pragma once

#include <incision/BodyState.h>
#include <incision/CrackEvent.h>
#include <incision/CutReport.h>
#include <ros/node_handle.h>

#include <array>
#include <atomic>
#include <string>
#include <vector>

#include "incision/body/deformable_body.h"
#include "incision/pace/answers.h"
#include "incision/pace/throttle.h"
#include "incision/ros/publishing_thread.h"

namespace incision {

/// Tells what became of the commands and what the body did by itself: publishes cut reports and crack events, counts
/// and logs what was refused. Thread-safe.
class Reporter : public Answers {
 public:
  /// There are crack events only of a body that breaks.
  Reporter(ros::NodeHandle& node, const Scene& scene, PublishingThread* thread);

  /// The body's pieces now; every report says them, also of cuts that never reach the body.
  void setPieces(int pieces);

  /// A cut that the body has answered.
  void report(const CutResult& result) override;

  /// What a crack did in a step.
  void report(const CrackResult& result);

  void refuseCut(const std::string& label, const Refused& refused) override;
  void refuseTool(int tool, const Refused& refused) override;
  /// Something that was to be set anew.
  void refuseSettings(const Refused& refused);

  /// Go into the log.
  void warn(const std::string& about, const std::string& text) override;
  void inform(const std::string& text) override;

  /// Before the node ends: gives the reports time to leave for those who listen.
  void flush();

  /// Counts so far, into the fields of the state.
  void fillState(BodyState& state) const;
  std::array<std::uint64_t, NUM_REFUSALS> counts() const;
  /// Messages to the tool that were refused so far.
  std::uint64_t refusedOf(std::size_t tool) const { return of_tools_[tool]; }

 private:
  /// `about`: what is warned of now and then, of which there are no more than the scene has names.
  void warnOfRefused(const std::string& about, const std::string& what, const Refused& refused);
  void count(Refusal kind) { ++counts_[static_cast<int>(kind)]; }
  template <class Give>
  void giveInTime(const Give& give);
  void publish(const CutResult& result);
  void give(const CutResult& result);

  const std::string body_frame_;
  PublishingThread* thread_;
  Outlet<CutReport> cut_reports_;
  Outlet<CrackEvent> crack_events_;
  std::vector<std::string> tools_;  // names
  std::array<std::atomic<std::uint64_t>, NUM_REFUSALS> counts_ = {};
  std::vector<std::atomic<std::uint64_t>> of_tools_;
  std::atomic<int> pieces_ = 0;
  Throttle throttle_{WARNING_PERIOD};
};

}  // namespace incision

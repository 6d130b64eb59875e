#include "incision/ros/bag/bag_answers.h"

#include <utility>

#include "incision/run/batch.h"

namespace incision {

void BagAnswers::setTime(SteadyTime now, double simulated) {
  now_ = now;
  simulated_ = simulated;
}

void BagAnswers::report(const CutResult& result) {
  ++(result.status == CutStatus::APPLIED ? applied_ : result.status == CutStatus::MISSED ? missed_ : rejected_);
  cuts_.push_back(result);
  if (result.status != CutStatus::APPLIED) remarks_.push_back(remarkOn(result, simulated_));
}

void BagAnswers::refuseCut(const std::string& label, const Refused& refused) {
  CutResult result;
  result.label = label;
  result.status = CutStatus::REJECTED;
  result.reason = refused.reason;
  report(result);
}

void BagAnswers::refuseTool(int tool, const Refused& refused) {
  ++refused_;
  const std::string whose = "refused a message to the tool '" + tools_[static_cast<std::size_t>(tool)] + "'";
  warn(whose, whose + ": " + refused.reason);
}

void BagAnswers::warn(const std::string& about, const std::string& text) {
  if (throttle_.lets(about, now_)) remarks_.push_back(text);
}

std::vector<std::string> BagAnswers::takeRemarks() { return std::exchange(remarks_, {}); }

std::vector<Quantity> BagAnswers::quantities() const {
  return {{"cuts_applied", applied_},
          {"cuts_missed", missed_},
          {"cuts_rejected", rejected_},
          {"refused_messages", refused_}};
}

}  // namespace incision

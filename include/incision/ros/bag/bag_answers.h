#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "incision/body/quantities.h"
#include "incision/pace/answers.h"
#include "incision/pace/throttle.h"

namespace incision {

/// Gathers what there is to say while a bag is run, and counts what became of its commands.
class BagAnswers : public Answers {
 public:
  /// `tools`: names of the scene's.
  explicit BagAnswers(std::vector<std::string> tools) : tools_(std::move(tools)) {}

  /// When it is now: by what `now` the bag's messages come, at what simulated time [s] the body is.
  void setTime(SteadyTime now, double simulated);

  void report(const CutResult& result) override;
  void refuseCut(const std::string& label, const Refused& refused) override;
  void refuseTool(int tool, const Refused& refused) override;
  void warn(const std::string& about, const std::string& text) override;
  void inform(const std::string& text) override { remarks_.push_back(text); }

  /// What has been said since the last call, each in a line.
  std::vector<std::string> takeRemarks();

  /// What has become of each cut so far.
  const std::vector<CutResult>& cuts() const { return cuts_; }

  /// Counts so far.
  std::vector<Quantity> quantities() const;

 private:
  const std::vector<std::string> tools_;
  SteadyTime now_;
  double simulated_ = 0;
  Throttle throttle_{WARNING_PERIOD};
  std::vector<std::string> remarks_;
  std::vector<CutResult> cuts_;
  std::int64_t applied_ = 0, missed_ = 0, rejected_ = 0, refused_ = 0;
};

}  // namespace incision

#pragma once

#include <string>
#include <vector>

#include "incision/body/deformable_body.h"

namespace incision {

/// What the steps of a run cost, gathered as they are taken.
class StepStatistics {
 public:
  void add(const StepResult& step);

  /// Wall time [ms] that a share of the steps did not pass, by nearest rank; 0 without steps.
  double quantile(double share) const;
  /// Mean over the steps; they add up to the mean step but for what lies between the phases. 0 without steps.
  PhaseTimes meanPhases() const;
  /// The last step's linear solve; 0 without steps.
  int iterations() const { return iterations_; }
  const ContactReport& contact() const { return contact_; }
  double residual() const { return residual_; }

 private:
  std::vector<double> step_ms_;
  PhaseTimes sum_;
  ContactReport contact_;
  int iterations_ = 0;
  double residual_ = 0;
};

/// One line of JSON on the body as it is now and on the run so far; all numbers read back as the same doubles.
std::string summaryLine(const DeformableBody& body, const StepStatistics& statistics);

}  // namespace incision

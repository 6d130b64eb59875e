#pragma once

#include <string>
#include <vector>

#include "incision/body/deformable_body.h"
#include "incision/run/step_source.h"

namespace incision {

/// What the steps of a run cost, gathered as they are taken.
class StepStatistics {
 public:
  void add(const StepResult& step);

  /// Wall time [ms] that a share of the steps did not pass, by nearest rank; 0 without steps.
  double quantile(double share) const;
  /// Newton steps that a share of the steps did not pass, likewise.
  int solvesQuantile(double share) const;
  /// Mean over the steps; they add up to the mean step but for what lies between the phases. 0 without steps.
  PhaseTimes meanPhases() const;
  /// Of the last step, its contacts, solves, iterations and residual; all 0 without steps.
  const StepResult& last() const { return last_; }

 private:
  std::vector<double> step_ms_;
  std::vector<int> solves_;
  PhaseTimes sum_;
  StepResult last_;
};

/// What a run was asked for and how it went.
struct RunAccount {
  std::string scene;                   ///< the file, as it was named
  std::vector<std::string> overrides;  ///< values of the scene that were set, such as "solver.time_step=0.005"
  std::vector<CutResult> cuts;         ///< what became of those that took effect, in their order
  bool interrupted = false;            ///< it was ended by a signal before its last step
  std::string failure;                 ///< why a step failed; empty: none did
};

/// One line of JSON on the body as it is now and on the run so far, and on where its steps came from unless that is
/// null; all numbers read back as the same doubles. Text that is not UTF-8 is mended.
std::string summaryLine(const DeformableBody& body, const StepStatistics& statistics, const RunAccount& account,
                        const StepSource* source = nullptr);

}  // namespace incision

#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "support/rig.h"

namespace incision {

/// A coupler whose springs a test gives, between the body and something outside.
class GivenSprings : public WithMemory<Coupler, int> {
 public:
  using Update = std::function<void(Span<const Vec3> moved, Span<Spring> springs)>;

  /// Springs that `update` gives their force and stiffness; left out, they are linear.
  explicit GivenSprings(
      std::vector<Spring> springs, Update update = [](auto, auto) {})
      : springs_(std::move(springs)), update_(std::move(update)) {}

  void changed(const CutMesh& /*mesh*/) override {}
  bool begin(const StepStart& /*start*/, std::vector<Spring>* springs) override {
    springs->insert(springs->end(), springs_.begin(), springs_.end());
    return true;
  }
  void update(Span<const Vec3> moved, Span<Spring> springs) override { update_(moved, springs); }
  void accept(const StepSpan& /*span*/, Span<const Vec3> moved, const Motion& /*end*/, const Wrench& felt) override {
    moved_.assign(moved.begin(), moved.end());
    felt_ = felt;
  }
  bool hasOtherEnd() const override { return true; }

  const Wrench& felt() const { return felt_; }
  const std::vector<Vec3>& moved() const { return moved_; }

 private:
  std::vector<Spring> springs_;
  Update update_;
  Wrench felt_;
  std::vector<Vec3> moved_;
};

/// Takes a step under these couplers. Returns whether it could be taken.
inline bool advanceWith(Rig* rig, Couplers* couplers) {
  const std::vector<Vec3>& ahead = rig->step.begin(rig->time_step, rig->motion);
  couplers->begin({{rig->time_step},
                   rig->mesh,
                   rig->step.pieceOf(),
                   rig->motion,
                   ahead,
                   rig->step.inertia(),
                   rig->step.pieceMass()});
  if (!rig->step.advance(rig->time, &rig->motion, couplers)) return false;
  couplers->accept(rig->step.moved(), rig->motion, rig->step.felt());
  rig->time += rig->time_step;
  return true;
}

}  // namespace incision

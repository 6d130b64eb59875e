#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "incision/solver/step_in_parts.h"
#include "support/rig.h"

namespace incision {

/// Any number may be a memory.
inline void check(int /*memory*/, const MemoryLimits& /*limits*/) {}

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
  void accept(const StepSpan& span, Span<const Vec3> moved, const Motion& /*end*/, const Wrench& felt) override {
    moved_.assign(moved.begin(), moved.end());
    if (span.from == 0) felt_ = Wrench();
    felt_.force += (span.to - span.from) * felt.force;
    felt_.torque += (span.to - span.from) * felt.torque;
  }
  bool hasOtherEnd() const override { return true; }

  /// The mean over the last step, whatever parts it was taken in.
  const Wrench& felt() const { return felt_; }
  const std::vector<Vec3>& moved() const { return moved_; }

 private:
  std::vector<Spring> springs_;
  Update update_;
  Wrench felt_;
  std::vector<Vec3> moved_;
};

/// Takes a part of a step under these couplers, or returns false with nothing changed.
inline bool advancePart(Rig* rig, Couplers* couplers, const StepSpan& span, double time, StepDemand demand) {
  const std::vector<Vec3>& ahead = rig->step.begin(span.time_step, rig->motion);
  couplers->begin(
      {span, rig->mesh, rig->step.pieceOf(), rig->motion, ahead, rig->step.inertia(), rig->step.pieceMass()});
  if (!rig->step.advance(time, &rig->motion, couplers, demand)) {
    couplers->stepFailed();
    return false;
  }
  couplers->accept(rig->step.moved(), rig->motion, rig->step.felt());
  return true;
}

/// Takes a step under these couplers, in parts where it must be. Returns whether it could be taken; how it was solved
/// is added to `solved`.
inline bool advanceWith(Rig* rig, Couplers* couplers, SolveStats* solved = nullptr) {
  struct Kept {
    Motion motion;
    ImplicitStep::Memory step;
    std::vector<std::any> couplers;
  };
  const bool taken = advanceInParts(
      {rig->time_step}, rig->time,
      [&](const StepSpan& span, double time, StepDemand demand) {
        const bool part_taken = advancePart(rig, couplers, span, time, demand);
        if (solved) solved->add(rig->step.stats(), part_taken);
        return part_taken;
      },
      [&] {
        return Kept{rig->motion, rig->step.keep(), couplers->keep()};
      },
      [&](const Kept& before) {
        rig->motion = before.motion;
        rig->step.recall(before.step);
        couplers->recall(before.couplers);
      });
  if (taken) rig->time += rig->time_step;
  return taken;
}

}  // namespace incision

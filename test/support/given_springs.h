#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "support/rig.h"

namespace incision {

/// A coupler whose springs a test gives, between the body and something outside.
class GivenSprings : public WithMemory<Coupler, int> {
 public:
  using Give = std::function<bool(const std::vector<Vec3>& v_end, std::vector<Spring>* springs)>;

  /// `give` appends the springs, and says whether they differ from the last ones.
  explicit GivenSprings(Give give) : give_(std::move(give)) {}

  void changed(const CutMesh& /*mesh*/) override {}
  bool begin(const StepStart& /*start*/) override { return true; }
  bool update(const StepSpan& /*span*/, const std::vector<Vec3>& v_end, std::vector<Spring>* springs) override {
    return give_(v_end, springs);
  }
  void accept(const StepSpan& /*span*/, const Motion& /*end*/, const Wrench& felt) override { felt_ = felt; }
  bool hasOtherEnd() const override { return true; }

  const Wrench& felt() const { return felt_; }

 private:
  Give give_;
  Wrench felt_;
};

/// Takes a step under these couplers. Returns whether it could be taken.
inline bool advanceWith(Rig* rig, Couplers* couplers) {
  couplers->begin({{rig->time_step}, rig->mesh, rig->step.pieceOf(), rig->motion});
  if (!rig->step.advance(rig->time, rig->time_step, &rig->motion, couplers)) return false;
  couplers->accept(rig->motion, rig->step.felt());
  rig->time += rig->time_step;
  return true;
}

}  // namespace incision

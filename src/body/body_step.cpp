#include "body_state.h"
#include "incision/base/input_error.h"

namespace incision {

/// Cracks start and grow where the stress at the step's start asks for it. Nothing moves.
void DeformableBody::State::fracture() {
  if (fractured_steps > steps) return;
  fractured_steps = steps + 1;
  const double now = time();
  for (const CrackResult& event : growth->fuse(now, mesh, motion.x)) reports.cracks.push_back(event);
  for (const CrackAdvance& advance :
       growth->advances(now, scene.solver.time_step, step.assembly(), motion.x, step.pieceOf())) {
    const std::optional<CrackField> field = growth->field(advance, mesh);
    if (!field) continue;
    try {
      const Insertion done = door.insert(*field);
      if (!done.changed()) {
        growth->refused(now, advance);
        continue;
      }
      reports.cracks.push_back(growth->inserted(now, advance, *field, done, mesh, motion.x));
      if (cohesion) cohesion->add(done, mesh, motion.x);
    } catch (const InputError& limit) {
      reports.cracks.push_back(growth->refused(now, advance));
    }
  }
  door.finish();
}

/// One step, or a part of one. Returns false with nothing changed.
bool DeformableBody::State::advance(const StepSpan& span, double time) {
  const auto beginning = Clock::now();
  const bool coupled =
      !couplers.areNone() && couplers.begin({span, mesh, step.pieceOf(), motion, step.begin(span.time_step, motion),
                                             step.inertia(), step.pieceMass()});
  couplers_ms = 1e3 * secondsSince(beginning);
  const bool taken = coupled ? step.advance(time, &motion, &couplers) : advanceFreely(time, span.time_step);
  if (!taken) couplers.stepFailed();
  if (!taken || !coupled) return taken;
  last_steps.forget();
  couplers.accept(step.moved(), motion, step.felt());
  return true;
}

/// One step in which no coupler acts.
bool DeformableBody::State::advanceFreely(double time, double time_step) {
  if (scene.solver.integrator == Integrator::EULER) {
    if (couplers.areNone()) step.begin(time_step, motion);
    return step.advance(time, &motion);
  }
  return last_steps.advance(time, time_step, &step, &motion);
}

/// Two steps of half the length; returns false, with everything as it was, when one of them fails.
bool DeformableBody::State::advanceInHalves(double time, double time_step) {
  const StepMemory before = keepStep();
  const double half = time_step / 2;
  last_steps.forget();
  if (advance({half, 0, 0.5}, time) && advance({half, 0.5, 1}, time + half)) {
    last_steps.forget();
    return true;
  }
  recallStep(before);
  return false;
}

/// The tools are where their paths ended, and have done what they do on the way.
void DeformableBody::State::endTools() {
  for (const auto& tool : tools) {
    std::optional<CutResult> ended = tool->endStep(scene.solver.time_step, motion, &door);
    door.finish();
    if (ended) reports.cuts.push_back(withPieces(*ended));
  }
}

}  // namespace incision

#include "body_state.h"
#include "incision/base/input_error.h"
#include "incision/solver/step_in_parts.h"

namespace incision {

/// Cracks start and grow where the stress at the step's start asks for it. Nothing moves. Returns whether the body is
/// still what has been marked last.
bool DeformableBody::State::fracture() {
  if (fractured_steps > steps) return false;
  return allOrNothing([&] {
    fractured_steps = steps + 1;
    const double now = time();
    const std::vector<CrackResult> fused = growth->fuse(now, mesh, motion.x);
    reports.cracks.insert(reports.cracks.end(), fused.begin(), fused.end());
    const std::vector<CrackAdvance> advances =
        growth->advances(now, scene.solver.time_step, step.assembly(), motion.x, step.pieceOf());
    if (!advances.empty()) grow(advances);
    const bool is_unchanged = fused.empty() && advances.empty();
    if (is_unchanged) marked.fractured_steps = fractured_steps;
    return is_unchanged;
  });
}

void DeformableBody::State::grow(const std::vector<CrackAdvance>& advances) {
  const double now = time();
  for (const CrackAdvance& advance : advances) {
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

/// A step whose cracks have grown. Returns false with the motion and the mesh as they were; otherwise nothing is thrown
/// once the reports have been handed over.
bool DeformableBody::State::take(StepResult* result) {
  const double dt = scene.solver.time_step, t = time();
  for (const auto& tool : tools) tool->startStep(t, dt, motion.x);
  clamp_motions.startStep(t, dt);
  if (wants_wrenches) felt = noWrenches();
  times = StepTimes();
  couplers_ms = 0;
  solved = SolveStats();
  divided = false;
  if (!advance()) return false;
  ++steps;
  if (!solved.settled) ++unsettled_steps;
  if (growth) growth->stepTaken();
  if (wants_wrenches) turnWrenches();
  obstacle_motions.endStep();
  clamp_motions.endStep();
  const auto cutting = Clock::now();
  endTools();
  if (!tools.empty()) result->phase_ms.cut += 1e3 * secondsSince(cutting);
  fillResult(result);
  return true;
}

/// One step, in parts where it must be. Returns false with everything as it was.
bool DeformableBody::State::advance() {
  return advanceInParts(
      {scene.solver.time_step}, time(),
      [&](const StepSpan& span, double from, StepDemand demand) { return advance(span, from, demand); },
      [&] {
        markRotations();
        return keepStep();
      },
      [&](const StepMemory& before) { recallStep(before); });
}

/// A part of a step. Returns false with nothing changed.
bool DeformableBody::State::advance(const StepSpan& span, double time, StepDemand demand) {
  if (!span.isWhole()) last_steps.forget();
  const auto beginning = Clock::now();
  if (clamp_motions.any()) step.setClampEnds(clamp_motions.at(span.to));
  const bool coupled =
      !couplers.areNone() && couplers.begin({span, mesh, step.pieceOf(), motion, step.begin(span.time_step, motion),
                                             step.inertia(), step.pieceMass()});
  couplers_ms += 1e3 * secondsSince(beginning);
  const bool taken = coupled ? step.advance(time, &motion, &couplers, demand) : advanceFreely(time, span.time_step);
  times += step.times();
  solved.add(step.stats(), taken);
  if (!taken) {
    couplers.stepFailed();
    return false;
  }
  divided = divided || !span.isWhole();
  if (coupled || !span.isWhole()) last_steps.forget();
  if (wants_wrenches) feel(span, coupled);
  if (coupled) couplers.accept(step.moved(), motion, step.felt());
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

/// The tools are where their paths ended, and have done what they do on the way.
void DeformableBody::State::endTools() {
  for (const auto& tool : tools) {
    std::optional<CutResult> ended = tool->endStep(scene.solver.time_step, motion, &door);
    door.finish();
    if (ended) reports.cuts.push_back(withPieces(*ended));
  }
}

}  // namespace incision

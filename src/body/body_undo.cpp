// How a change of a body is undone that could not be finished, because memory ran out in it or for whatever reason.
//
// What is marked before a change takes no memory from the heap but where the body has grown, nor does undoing it: the
// mesh goes back by its journal, and the motion and the counts are put back at once. All else follows from these and
// from what was marked, and is found anew before it is next used. Should memory be short even then, that use fails in
// its turn, and the state is whole still.
#include "body_state.h"

namespace incision {

/// The body, fit for use.
DeformableBody::State& DeformableBody::State::sound() {
  if (is_sound) return *this;
  if (growth) growth->recall(*marked.growth);
  recallAll(marked.step);
  couplers.stepFailed();
  is_sound = true;
  return *this;
}

void DeformableBody::State::mark() {
  mesh.mark();
  marked.steps = steps;
  marked.unsettled_steps = unsettled_steps;
  marked.cuts_done = cuts_done;
  marked.fractured_steps = fractured_steps;
  marked.cuts = reports.cuts.size();
  marked.cracks = reports.cracks.size();
  markGrowth();
  marked.obstacles = obstacle_motions.inStep();
  marked.clamps = clamp_motions.keep();
  StepMemory& of_step = marked.step;
  of_step.motion = motion;
  step.keepIn(&of_step.step);
  last_steps.keepIn(&of_step.last_steps);
  couplers.keepIn(&of_step.couplers);
  of_step.tools.resize(tools.size());
  for (std::size_t i = 0; i < tools.size(); ++i) tools[i]->keepIn(&of_step.tools[i]);
  step.markRotations();
  marked.has_rotations = false;
}

/// Copying it takes a while, and memory, so it is only done after a change.
void DeformableBody::State::markGrowth() {
  if (!growth || marked.growth_version == growth->version()) return;
  marked.growth_version.reset();  // until it is whole
  marked.growth = growth->memory();
  marked.growth_version = growth->version();
}

/// As they are, for what changes them more than once. The first time counts.
void DeformableBody::State::markRotations() {
  if (marked.has_rotations) return;
  marked.step.step.rotations = step.assembly().rotations();
  marked.has_rotations = true;
}

void DeformableBody::State::undo() noexcept {
  mesh.undo();
  motion.x.swap(marked.step.motion.x);
  motion.v.swap(marked.step.motion.v);
  if (!marked.has_rotations) step.takeMarked(&marked.step.step.rotations);
  marked.has_rotations = true;
  steps = marked.steps;
  unsettled_steps = marked.unsettled_steps;
  cuts_done = marked.cuts_done;
  fractured_steps = marked.fractured_steps;
  reports.cuts.erase(reports.cuts.begin() + static_cast<std::ptrdiff_t>(marked.cuts), reports.cuts.end());
  reports.cracks.erase(reports.cracks.begin() + static_cast<std::ptrdiff_t>(marked.cracks), reports.cracks.end());
  obstacle_motions.recall(marked.obstacles);
  clamp_motions.recall(marked.clamps);
  door.forgetChanges();
  surface.changed();
  is_sound = false;
}

}  // namespace incision

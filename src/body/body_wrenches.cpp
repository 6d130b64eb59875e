// What a body does to what holds it, for those who ask.
#include "body_state.h"

namespace incision {

BodyWrenches DeformableBody::State::noWrenches() const {
  BodyWrenches none;
  none.clamps.resize(scene.boundary.size());
  none.obstacles.resize(obstacles.links.size());
  return none;
}

/// Adds what a part of the step has done, by its share of the whole, about the origin of the body's frame.
void DeformableBody::State::feel(const StepSpan& span, bool coupled) {
  const double share = span.to - span.from, whole_step = scene.solver.time_step;
  for (std::size_t i = 0; i < felt.clamps.size(); ++i) felt.clamps[i] += share * step.clampWrenches()[i];
  felt.points.clear();
  if (!coupled) return;
  if (body_contact)
    body_contact->addWrenches(couplers.ofCoupler(*body_contact, step.impulses()),
                              couplers.ofCoupler(*body_contact, step.levers()), whole_step, &felt.ground,
                              &felt.obstacles);
  const auto addPoints = [&](const Contact& contact, int tool) {
    contact.addPoints(couplers.ofCoupler(contact, step.moved()), couplers.ofCoupler(contact, step.impulses()),
                      span.time_step, tool, motion.x, &felt.points);
  };
  if (body_contact) addPoints(*body_contact, -1);
  for (std::size_t i = 0; i < tools.size(); ++i)
    for (const auto& contact : tools[i]->touching()) addPoints(*contact, static_cast<int>(i));
}

/// The step has been taken, but nothing has gone to where it ends yet.
void DeformableBody::State::turnWrenches() {
  for (std::size_t i = 0; i < felt.clamps.size(); ++i)
    felt.clamps[i] = about(clamp_motions.startOf(i).position, felt.clamps[i]);
  for (std::size_t i = 0; i < felt.obstacles.size(); ++i)
    felt.obstacles[i] = about(obstacle_motions.inStep()[i].from.position, felt.obstacles[i]);
}

/// Its held copies go there at once, without a velocity that the way would give them.
void DeformableBody::State::placeClamp(int clamp, const Pose& pose) {
  const Pose end = clamp_motions.place(static_cast<std::size_t>(clamp), pose);
  for (int c = 0; c < mesh.numCopies(); ++c) {
    if (step.held()[c] != clamp) continue;
    motion.x[c] = placed(mesh.mesh().nodes[mesh.copyNode(c)], end);
    motion.v[c].setZero();
  }
  last_steps.forget();
}

}  // namespace incision

#include "body_state.h"
#include "incision/base/input_error.h"

namespace incision {
namespace {

std::string missedReason(const Insertion& done) {
  if (done.out_of_bounds == 0) return "it crosses no part of the body that is not cut there already";
  return "its plane crosses " + std::to_string(done.out_of_bounds) +
         " parts but its bounds hold the centre of no section: smaller than the elements, or beside the body";
}

}  // namespace

/// A cut that may grow passes beside the nodes, by no more than the distance within which others go through them.
CrackField DeformableBody::State::fieldOf(const PlaneCut& plane) const {
  CrackField field = planeField(plane, mesh, motion.x);
  if (!growth) return field;
  for (int c = 0; c < mesh.numCopies(); ++c)
    if (field.phi[c] == 0) field.phi[c] = SNAP * mesh.shortestEdge(mesh.copyNode(c));
  return field;
}

CutResult DeformableBody::State::cut(const PlaneCut& plane) {
  const auto start_time = Clock::now();
  CutResult result;
  result.label = plane.label;
  result.reason = whyInvalid(plane);
  if (!result.reason.empty()) {
    result.status = CutStatus::REJECTED;
  } else {
    try {
      const CrackField field = fieldOf(plane);
      const Insertion done = mesh.insert(field);
      result.status = done.changed() ? CutStatus::APPLIED : CutStatus::MISSED;
      if (growth && done.changed()) growth->adopt(field, done, mesh);
      if (done.changed())
        topologyChanged(done.touched);
      else
        result.reason = missedReason(done);
      result.cracks = done.changed() ? 1 : 0;
      result.parts_split = done.parts_split;
      result.copies_added = done.copies_added;
    } catch (const InputError& limit) {
      result.status = CutStatus::REJECTED;
      result.reason = limit.what();
    }
  }
  result.pieces = pieces();
  result.duration = secondsSince(start_time);
  return result;
}

void DeformableBody::State::applyDue(StepResult* result) {
  while (!scheduled.empty() && scheduled.front().time <= time() + DUE_TOLERANCE) {
    const PlaneCut plane = scheduled.front().plane;
    scheduled.pop_front();
    result->cuts.push_back(cut(plane));
  }
  followScript();
}

}  // namespace incision

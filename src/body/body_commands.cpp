#include "body_state.h"
#include "incision/base/input_error.h"

namespace incision {
namespace {

/// Short enough for a string that takes nothing from the heap.
constexpr const char* OUT_OF_MEMORY = "memory ran out";

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

/// Where memory runs out the cut is refused, and nothing has changed.
CutResult DeformableBody::State::cut(const PlaneCut& plane) {
  try {
    return allOrNothing([&] { return cutNow(plane); });
  } catch (const std::bad_alloc&) {
    CutResult refused;
    refused.label = plane.label;
    refused.status = CutStatus::REJECTED;
    refused.reason = OUT_OF_MEMORY;
    return refused;
  }
}

CutResult DeformableBody::State::cutNow(const PlaneCut& plane) {
  const auto start_time = Clock::now();
  CutResult result;
  result.label = plane.label;
  result.reason = whyInvalid(plane);
  if (!result.reason.empty()) {
    result.status = CutStatus::REJECTED;
  } else {
    try {
      const CrackField field = fieldOf(plane);
      const Insertion done = door.insert(field);
      result.status = done.changed() ? CutStatus::APPLIED : CutStatus::MISSED;
      if (!done.changed()) result.reason = missedReason(done);
      if (growth && done.changed()) growth->adopt(field, done, mesh);
      door.finish();
      result.cracks = done.changed() ? 1 : 0;
      result.parts_split = done.parts_split;
      result.copies_added = done.copies_added;
    } catch (const InputError& limit) {
      result.status = CutStatus::REJECTED;
      result.reason = limit.what();
    }
  }
  result = withPieces(result);
  result.duration = secondsSince(start_time);
  return result;
}

CutResult DeformableBody::State::withPieces(CutResult cut) const {
  cut.pieces = pieces();
  return cut;
}

std::optional<CutResult> DeformableBody::State::ended(const std::optional<CutResult>& stroke) const {
  if (!stroke) return std::nullopt;
  return withPieces(*stroke);
}

void DeformableBody::State::endStrokes(std::vector<CutResult>* strokes) {
  for (const auto& tool : tools)
    if (const auto stroke = ended(tool->lift())) strokes->push_back(*stroke);
}

/// All that acts in a step, and all who have threads, take them over.
void DeformableBody::State::set(const LiveSettings& settings) {
  live = settings;
  step.setTolerance(live.tolerance);
  step.setGravity(live.gravity);
  step.setThreads(live.threads);
  mesh.setThreads(live.threads);
  skin.setThreads(live.threads);
  for (const auto& tool : tools) tool->scaleCuttingForce(live.cutting_force_factor);
}

void DeformableBody::State::applyDueCuts() {
  while (cuts_done < cuts.size() && cuts[cuts_done].time <= time() + DUE_TOLERANCE)
    allOrNothing([&] {
      reports.cuts.push_back(cutNow(cuts[cuts_done].plane));
      ++cuts_done;
    });
}

}  // namespace incision

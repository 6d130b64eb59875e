#include <algorithm>

#include "body_state.h"
#include "incision/mesh/input_error.h"

namespace incision {
namespace {

/// The tool's sweep is cut into pieces that turn by no more than this [rad], so that each is nearly flat.
constexpr double MAX_SWEEP_TURN = 0.1;

bool movedLess(const Edge& from, const Edge& to, double distance) {
  return (to[0] - from[0]).norm() < distance && (to[1] - from[1]).norm() < distance;
}

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
  result.pieces = step.pieces();
  result.duration = secondsSince(start_time);
  return result;
}

std::optional<CutResult> DeformableBody::State::moveTool(const Pose& pose) {
  if (tool_pose && movedLess(placed(edge, *tool_pose), placed(edge, pose), least_motion)) return std::nullopt;
  const std::optional<Pose> last = std::exchange(tool_pose, pose);
  if (!last) return std::nullopt;
  const auto start_time = Clock::now();
  const int sweeps = 1 + static_cast<int>(last->orientation.angularDistance(pose.orientation) / MAX_SWEEP_TURN);
  try {
    for (int k = 0; k < sweeps; ++k) {
      const Edge from = placed(edge, between(*last, pose, static_cast<double>(k) / sweeps));
      const Edge to = placed(edge, between(*last, pose, static_cast<double>(k + 1) / sweeps));
      const Insertion done = stroke.sweep(from, to, motion.x, &mesh);
      if (!done.changed()) continue;
      stroke_result.status = CutStatus::APPLIED;
      stroke_result.cracks = 1;
      stroke_result.parts_split += done.parts_split;
      stroke_result.copies_added += done.copies_added;
      topologyChanged(done.touched);
    }
  } catch (const InputError& limit) {
    stroke_result.status = CutStatus::REJECTED;
    stroke_result.reason = limit.what();
  }
  stroke_result.duration += secondsSince(start_time);
  if (!stroke.begun() || touches(placed(edge, pose), motion.x, mesh)) return std::nullopt;
  return endStroke();
}

std::optional<CutResult> DeformableBody::State::endStroke() {
  if (!stroke.begun()) return std::nullopt;
  CutResult result = std::exchange(stroke_result, CutResult());
  stroke = Stroke();
  if (result.status == CutStatus::MISSED) return std::nullopt;  // it grazed the body
  result.label = "tool";
  result.pieces = step.pieces();
  return result;
}

/// The scene's tool pose at the current time, if it gives one.
std::optional<Pose> DeformableBody::State::scenePose() const {
  if (!scene.tool || scene.tool->poses.empty()) return std::nullopt;
  const std::vector<TimedPose>& poses = scene.tool->poses;
  const double now = time();
  if (now < poses.front().time - DUE_TOLERANCE || now > poses.back().time + DUE_TOLERANCE) return std::nullopt;
  const auto after =
      std::lower_bound(poses.begin(), poses.end(), now, [](const TimedPose& pose, double t) { return pose.time < t; });
  if (after == poses.begin()) return poses.front().pose;
  if (after == poses.end()) return poses.back().pose;
  const auto previous = after - 1;
  return between(previous->pose, after->pose, (now - previous->time) / (after->time - previous->time));
}

void DeformableBody::State::applyDue(StepResult* result) {
  while (!scheduled.empty() && scheduled.front().time <= time() + DUE_TOLERANCE) {
    const PlaneCut plane = scheduled.front().plane;
    scheduled.pop_front();
    result->cuts.push_back(cut(plane));
  }
  if (const std::optional<Pose> pose = scenePose())
    if (const std::optional<CutResult> ended = moveTool(*pose)) result->cuts.push_back(*ended);
}

}  // namespace incision

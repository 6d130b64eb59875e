#include <algorithm>

#include "body_state.h"
#include "incision/base/input_error.h"

namespace incision {
namespace {

/// The tool's sweep is cut into pieces that turn by no more than this [rad], so that each is nearly flat.
constexpr double MAX_SWEEP_TURN = 0.1;

}  // namespace

/// The piece of each copy, and how many there are: what a blade has not swept yet holds together.
std::vector<int> DeformableBody::State::pieceOf(int* pieces) const {
  std::vector<int> piece_of = step.pieceOf();
  *pieces = ties && !ties->empty() ? ties->joinPieces(mesh, &piece_of) : step.pieces();
  return piece_of;
}

int DeformableBody::State::pieces() const {
  if (!ties || ties->empty()) return step.pieces();
  int count = 0;
  pieceOf(&count);
  return count;
}

void DeformableBody::State::guideTool(const std::vector<Pose>& path) {
  auto next = path.begin();
  if (!tool.pose && next != path.end()) tool.pose = *next++;
  tool.path.insert(tool.path.end(), next, path.end());
}

/// The pose that the scene gives for a time, if it gives one.
std::optional<Pose> DeformableBody::State::scriptedPose(double at) const {
  const std::vector<TimedPose>& poses = scene.tool->poses;
  if (poses.empty() || at < poses.front().time - DUE_TOLERANCE || at > poses.back().time + DUE_TOLERANCE)
    return std::nullopt;
  const auto after =
      std::lower_bound(poses.begin(), poses.end(), at, [](const TimedPose& pose, double t) { return pose.time < t; });
  if (after == poses.begin()) return poses.front().pose;
  if (after == poses.end()) return poses.back().pose;
  const auto previous = after - 1;
  return between(previous->pose, after->pose, (at - previous->time) / (after->time - previous->time));
}

/// The tool goes where the scene has it at the end of the step.
void DeformableBody::State::followScript() {
  if (!scene.tool) return;
  if (!tool.pose) tool.pose = scriptedPose(time());
  if (!tool.pose) return;
  if (const std::optional<Pose> pose = scriptedPose(time() + scene.solver.time_step)) tool.path.push_back(*pose);
}

/// Before a step: the tool goes from where it is to the end of its path.
void DeformableBody::State::startTool() {
  const int link = contact ? contact->obstacles().tool_link : -1;
  if (link >= 0) links.has_tool = tool.pose.has_value();
  if (!tool.pose) return;
  tool.from = *tool.pose;
  tool.to = tool.path.empty() ? tool.from : tool.path.back();
  stroke.start(placed(edge, tool.from), motion.x);
  if (link < 0) return;
  links.from[link] = tool.from;
  links.to[link] = tool.to;
  links.cuts = tool.active;
}

/// Where the copies stood at a share of the last step, of which they are at the end [m].
const std::vector<Vec3>& DeformableBody::State::positionsWithin(double share) {
  if (share == 1) return motion.x;
  x_within = motion.x;
  const double rest = (1 - share) * scene.solver.time_step;
  for (std::size_t c = 0; c < x_within.size(); ++c) x_within[c] -= rest * motion.v[c];
  return x_within;
}

/// After a step: cuts what the edge has crossed in it.
void DeformableBody::State::sweepTool(StepResult* result) {
  const Pose first = *tool.pose;
  if (!tool.path.empty()) tool.pose = tool.path.back();
  if (tool.active) sweepPath(first);
  tool.path.clear();
  if (!tool.active || !stroke.begun() || touches(placed(edge, *tool.pose), motion.x, mesh)) return;
  if (const std::optional<CutResult> ended = endStroke()) result->cuts.push_back(*ended);
}

/// Cuts along the tool's path, from where it was.
void DeformableBody::State::sweepPath(Pose last) {
  if (tool.path.empty()) cutAlong(placed(edge, last), motion.x);
  const double poses = static_cast<double>(tool.path.size());
  double done = 0;
  for (const Pose& pose : tool.path) {
    const int sweeps = 1 + static_cast<int>(last.orientation.angularDistance(pose.orientation) / MAX_SWEEP_TURN);
    for (int k = 0; k < sweeps; ++k) {
      const double end = static_cast<double>(k + 1) / sweeps;
      cutAlong(placed(edge, between(last, pose, end)), positionsWithin((done + end) / poses));
    }
    last = pose;
    ++done;
  }
}

void DeformableBody::State::cutAlong(const Edge& to, const std::vector<Vec3>& x) {
  const auto start_time = Clock::now();
  try {
    const Insertion done = stroke.sweep(to, x, &mesh, &*ties);
    if (done.changed()) {
      stroke_result.status = CutStatus::APPLIED;
      stroke_result.cracks = stroke.cracks();
      stroke_result.parts_split += done.parts_split;
      stroke_result.copies_added += done.copies_added;
      topologyChanged(done.touched);
    }
  } catch (const InputError& limit) {
    stroke_result.status = CutStatus::REJECTED;
    stroke_result.reason = limit.what();
  }
  stroke_result.duration += secondsSince(start_time);
}

ToolReport DeformableBody::State::toolReport() const {
  ToolReport report;
  if (!tool.pose) return report;
  report.force = on_tool.force;
  report.torque = on_tool.torque;
  report.touching = cutting->inTissue() || !on_tool.force.isZero(0);
  report.depth = cutting->depth();
  report.stroke_area = stroke_result.status != CutStatus::MISSED ? ties->area() - area_before : last_area;
  return report;
}

std::optional<CutResult> DeformableBody::State::endStroke() {
  if (!scene.tool) return std::nullopt;
  CutResult result = std::exchange(stroke_result, CutResult());
  if (result.status != CutStatus::MISSED) last_area = ties->area() - area_before;
  stroke = Stroke();
  cutting->leave();
  area_before = ties->area();
  if (result.status == CutStatus::MISSED) return std::nullopt;  // it grazed the body
  result.label = "tool";
  result.pieces = pieces();
  return result;
}

}  // namespace incision

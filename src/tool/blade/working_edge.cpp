#include "incision/tool/blade/working_edge.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "incision/base/input_error.h"

namespace incision {
namespace {

/// A sweep is cut into pieces that turn by no more than this [rad], so that each is nearly flat.
constexpr double MAX_SWEEP_TURN = 0.1;

using Clock = std::chrono::steady_clock;

/// Where the copies stood when this share [s] of the step's time was still to go, of which they are at the end [m].
const std::vector<Vec3>& positionsBefore(double rest, const Motion& motion, std::vector<Vec3>* x) {
  if (rest == 0) return motion.x;
  *x = motion.x;
  for (std::size_t c = 0; c < x->size(); ++c) (*x)[c] -= rest * motion.v[c];
  return *x;
}

}  // namespace

WorkingEdge::WorkingEdge(std::string label, const EdgeOfTool& edge, bool progressive, ToolInStep* tool, Ties* ties,
                         const Materials& materials, const CutMesh& mesh)
    : label_(std::move(label)),
      edge_(edge.edge),
      materials_(materials),
      ties_(*ties),
      stroke_(progressive),
      resistance_(edge, tool, *ties, stroke_, materials, mesh) {}

void WorkingEdge::recall(const WorkingEdgeMemory& memory) {
  strokes_ = memory.strokes;
  stroke_.recall(memory.stroke);
}

std::optional<CutResult> WorkingEdge::act(const std::vector<Pose>& way, double time_step, const Motion& motion,
                                          MeshDoor* door) {
  if (way.size() == 1) sweep(placed(edge_, way[0]), motion.x, door);
  for (std::size_t k = 1; k < way.size(); ++k) {
    const Pose &last = way[k - 1], &pose = way[k];
    const double done = static_cast<double>(k - 1), legs = static_cast<double>(way.size() - 1);
    const int sweeps = 1 + static_cast<int>(last.orientation.angularDistance(pose.orientation) / MAX_SWEEP_TURN);
    for (int s = 0; s < sweeps; ++s) {
      const double end = static_cast<double>(s + 1) / sweeps, share = (done + end) / legs;
      sweep(placed(edge_, between(last, pose, end)), positionsBefore((1 - share) * time_step, motion, &x_within_),
            door);
    }
  }
  const Edge from = placed(edge_, way[way.size() - std::min<std::size_t>(2, way.size())]),
             to = placed(edge_, way.back());
  if (!stroke_.begun() || touches(to, motion.x, door->mesh())) return std::nullopt;
  record([&] { return stroke_.leave({to[0] - from[0], to[1] - from[1]}, motion.x, materials_, door, &ties_); });
  return interrupt();
}

/// Cuts what the edge sweeps on its way to where it stands now, while the copies stand at `x`.
void WorkingEdge::sweep(const Edge& to, const std::vector<Vec3>& x, MeshDoor* door) {
  record([&] { return stroke_.sweep(to, x, materials_, door, &ties_); });
}

/// Keeps for the report what a cut of the stroke has done.
template <typename Cut>
void WorkingEdge::record(const Cut& cut) {
  const auto start = Clock::now();
  const double before = ties_.area();
  CutResult& result = strokes_.under_way;
  try {
    const Insertion done = cut();
    if (done.changed()) {
      result.status = CutStatus::APPLIED;
      result.cracks = stroke_.cracks();
      result.parts_split += done.parts_split;
      result.copies_added += done.copies_added;
    }
  } catch (const InputError& limit) {
    result.status = CutStatus::REJECTED;
    result.reason = limit.what();
  }
  strokes_.area += ties_.area() - before;
  result.duration += std::chrono::duration<double>(Clock::now() - start).count();
}

void WorkingEdge::addTo(ToolReport* report) const {
  report->touching = report->touching || resistance_.inTissue();
  report->depth = std::max(report->depth, resistance_.depth());
  report->stroke_area += strokes_.under_way.status != CutStatus::MISSED ? strokes_.area : strokes_.last_area;
}

/// It is told of where it cut anything: an edge that only grazed the body has made no stroke.
std::optional<CutResult> WorkingEdge::interrupt() {
  CutResult result = std::exchange(strokes_.under_way, CutResult());
  const bool has_cut = result.status != CutStatus::MISSED;
  if (has_cut) strokes_.last_area = strokes_.area;
  strokes_.area = 0;
  stroke_.restart();
  resistance_.leave();
  if (!has_cut) return std::nullopt;
  result.label = label_;
  return result;
}

}  // namespace incision

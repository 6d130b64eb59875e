#include "incision/tool/blade/working_edges.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "incision/base/input_error.h"

namespace incision {
namespace {

/// A sweep is cut into pieces that turn by no more than this [rad], so that each is nearly flat.
constexpr double MAX_SWEEP_TURN = 0.1;

/// Edges whose ends are this near, in elements, are at one place, but for rounding.
constexpr double AT_ONE_PLACE = 1e-6;

using Clock = std::chrono::steady_clock;

/// Where the copies stood when this share [s] of the step's time was still to go, of which they are at the end [m].
const std::vector<Vec3>& positionsBefore(double rest, const Motion& motion, std::vector<Vec3>* x) {
  if (rest == 0) return motion.x;
  *x = motion.x;
  for (std::size_t c = 0; c < x->size(); ++c) (*x)[c] -= rest * motion.v[c];
  return *x;
}

}  // namespace

WorkingEdges::WorkingEdges(std::string label, const std::vector<EdgeOfTool>& edges, bool progressive, ToolInStep* tool,
                           Ties* ties, NearParts* near, const Materials& materials, const CutMesh& mesh)
    : label_(std::move(label)),
      edges_(edges),
      tool_(tool),
      materials_(materials),
      ties_(*ties),
      near_(*near),
      stroke_(progressive, near) {
  for (const EdgeOfTool& edge : edges_) resistances_.emplace_back(edge, tool, *ties, stroke_, near, materials, mesh);
}

void WorkingEdges::addCouplers(std::vector<Coupler*>* list) {
  for (CuttingEdge& resistance : resistances_) list->push_back(&resistance);
}

void WorkingEdges::recall(const WorkingEdgesMemory& memory) {
  strokes_ = memory.strokes;
  stroke_.recall(memory.stroke);
}

void WorkingEdges::start(const std::vector<Vec3>& x) {
  starts_.clear();
  for (std::size_t i = 0; i < edges_.size(); ++i)
    starts_.push_back(at(i, tool_->groups[static_cast<std::size_t>(edges_[i].group)].from));
  stroke_.start(starts_, x);
}

std::optional<CutResult> WorkingEdges::act(const std::vector<std::vector<Pose>>& ways, double time_step,
                                           const Motion& motion, MeshDoor* door) {
  const auto wayOf = [&](std::size_t i) -> const std::vector<Pose>& {
    return ways[static_cast<std::size_t>(edges_[i].group)];
  };
  held_back_.clear();
  for (std::size_t i = 0; i < edges_.size(); ++i)
    held_back_.push_back(holdsBack(i, at(i, wayOf(i).back()), motion.x, door->mesh()));
  const std::size_t legs = wayOf(0).size() - 1;
  if (legs == 0)
    for (std::size_t i = 0; i < edges_.size(); ++i) sweep(i, at(i, wayOf(i)[0]), motion.x, door);
  for (std::size_t leg = 0; leg < legs; ++leg) {
    double turn = 0;  // the most
    for (std::size_t i = 0; i < edges_.size(); ++i)
      turn = std::max(turn, wayOf(i)[leg].orientation.angularDistance(wayOf(i)[leg + 1].orientation));
    const int sweeps = 1 + static_cast<int>(turn / MAX_SWEEP_TURN);
    for (int s = 0; s < sweeps; ++s) {
      const double end = static_cast<double>(s + 1) / sweeps;
      const double share = (static_cast<double>(leg) + end) / static_cast<double>(legs);
      // Each edge finds the copies that the one before it has added.
      for (std::size_t i = 0; i < edges_.size(); ++i)
        sweep(i, at(i, between(wayOf(i)[leg], wayOf(i)[leg + 1], end)),
              positionsBefore((1 - share) * time_step, motion, &x_within_), door);
    }
  }
  if (!stroke_.begun()) return std::nullopt;
  for (std::size_t i = 0; i < edges_.size(); ++i)
    if (touches(at(i, wayOf(i).back()), motion.x, door->mesh(), &near_)) return std::nullopt;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Edge from = at(i, wayOf(i)[legs - std::min<std::size_t>(1, legs)]), to = at(i, wayOf(i).back());
    record([&] { return stroke_.leave(i, {to[0] - from[0], to[1] - from[1]}, motion.x, materials_, door, &ties_); });
  }
  return interrupt();
}

/// Whether an edge that is now at `to` presses on what it has not begun to cut, or has come into it in this step: then
/// the step cuts nothing, and once it begins to cut it has swept all since it came. Where it met nothing although it is
/// in an element, as in the gap of an old cut, it lags one step at most.
bool WorkingEdges::holdsBack(std::size_t edge, const Edge& to, const std::vector<Vec3>& x, const CutMesh& mesh) const {
  const CuttingEdge& resistance = resistances_[edge];
  if (!resistance.waits()) return false;
  const Edge& from = starts_[edge];
  const Edge* last = stroke_.lastEdge(edge);
  const double off = last ? std::max(((*last)[0] - from[0]).norm(), ((*last)[1] - from[1]).norm()) : 0;
  const bool lags = off > AT_ONE_PLACE * materials_.meanSize();
  if (resistance.inTissue() ? !resistance.presses() : lags) return false;
  return touches(to, x, mesh, &near_);
}

/// Cuts what an edge sweeps on its way to where it stands now, while the copies stand at `x`.
void WorkingEdges::sweep(std::size_t edge, const Edge& to, const std::vector<Vec3>& x, MeshDoor* door) {
  if (held_back_[edge]) {
    stroke_.stand();
    return;
  }
  record([&] { return stroke_.sweep(edge, to, x, materials_, door, &ties_); });
}

/// Keeps for the report what a cut of the stroke has done.
template <typename Cut>
void WorkingEdges::record(const Cut& cut) {
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

void WorkingEdges::addTo(ToolReport* report) const {
  for (const CuttingEdge& resistance : resistances_) {
    report->touching = report->touching || resistance.inTissue();
    report->depth = std::max(report->depth, resistance.depth());
  }
  report->stroke_area += strokes_.under_way.status != CutStatus::MISSED ? strokes_.area : strokes_.last_area;
}

/// It is told of where it cut anything: an edge that only grazed the body has made no stroke.
std::optional<CutResult> WorkingEdges::interrupt() {
  CutResult result = std::exchange(strokes_.under_way, CutResult());
  const bool has_cut = result.status != CutStatus::MISSED;
  if (has_cut) strokes_.last_area = strokes_.area;
  strokes_.area = 0;
  stroke_.restart();
  for (CuttingEdge& resistance : resistances_) resistance.leave();
  if (!has_cut) return std::nullopt;
  result.label = label_;
  return result;
}

void WorkingEdges::scaleCuttingForce(double factor) {
  for (CuttingEdge& edge : resistances_) edge.scaleCuttingForce(factor);
}

}  // namespace incision

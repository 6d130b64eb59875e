#include "incision/tool/blade/blade.h"

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

Blade::Blade(const ToolSettings& settings, const Edge& edge, const std::array<double, 2>& fronts,
             const Materials& materials, const CutMesh& mesh, std::unique_ptr<ToolContact> touching)
    : Tool(settings, std::move(touching)),
      edge_(edge),
      materials_(materials),
      ties_(materials, settings.progressive),
      cutting_(settings, edge, fronts, &in_step_, ties_, stroke_, materials, mesh) {}

std::vector<Coupler*> Blade::couplers() {
  std::vector<Coupler*> list = Tool::couplers();
  list.push_back(&cutting_);
  list.push_back(&ties_);
  return list;
}

void Blade::recall(const std::any& kept) {
  const auto& memory = std::any_cast<const BladeMemory&>(kept);
  tool_ = memory.tool;
  strokes_ = memory.strokes;
  stroke_.recall(memory.stroke);
}

void Blade::start(const Pose& pose, const std::vector<Vec3>& x) { stroke_.start(placed(edge_, pose), x); }

std::optional<CutResult> Blade::act(const Pose& first, const std::vector<Pose>& way, double time_step,
                                    const Motion& motion, MeshDoor* door) {
  if (way.empty()) sweep(placed(edge_, first), motion.x, door);
  Pose last = first, before = first;
  double done = 0;
  for (const Pose& pose : way) {
    const int sweeps = 1 + static_cast<int>(last.orientation.angularDistance(pose.orientation) / MAX_SWEEP_TURN);
    for (int k = 0; k < sweeps; ++k) {
      const double end = static_cast<double>(k + 1) / sweeps, share = (done + end) / static_cast<double>(way.size());
      sweep(placed(edge_, between(last, pose, end)), positionsBefore((1 - share) * time_step, motion, &x_within_),
            door);
    }
    before = std::exchange(last, pose);
    ++done;
  }
  const Edge from = placed(edge_, before), to = placed(edge_, last);
  if (!stroke_.begun() || touches(to, motion.x, door->mesh())) return std::nullopt;
  record([&] { return stroke_.leave({to[0] - from[0], to[1] - from[1]}, motion.x, materials_, door, &ties_); });
  return interrupt();
}

/// Cuts what the edge sweeps on its way to where it stands now, while the copies stand at `x`.
void Blade::sweep(const Edge& to, const std::vector<Vec3>& x, MeshDoor* door) {
  record([&] { return stroke_.sweep(to, x, materials_, door, &ties_); });
}

/// Keeps for the report what a cut of the stroke has done.
template <typename Cut>
void Blade::record(const Cut& cut) {
  const auto start = Clock::now();
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
  result.duration += std::chrono::duration<double>(Clock::now() - start).count();
}

ToolReport Blade::report() const {
  ToolReport report = Tool::report();
  if (!pose()) return report;
  report.touching = report.touching || cutting_.inTissue();
  report.depth = cutting_.depth();
  const bool cuts = strokes_.under_way.status != CutStatus::MISSED;
  report.stroke_area = cuts ? ties_.area() - strokes_.area_before : strokes_.last_area;
  return report;
}

/// The stroke ends. It is told of where it cut anything: an edge that only grazed the body has made none.
std::optional<CutResult> Blade::interrupt() {
  CutResult result = std::exchange(strokes_.under_way, CutResult());
  const bool has_cut = result.status != CutStatus::MISSED;
  if (has_cut) strokes_.last_area = ties_.area() - strokes_.area_before;
  strokes_.area_before = ties_.area();
  stroke_ = Stroke();
  cutting_.leave();
  if (!has_cut) return std::nullopt;
  result.label = "tool";
  return result;
}

}  // namespace incision

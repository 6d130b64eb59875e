#include "incision/body/deformable_body.h"

#include <algorithm>
#include <utility>

#include "body_state.h"
#include "incision/base/input_error.h"
#include "incision/body/state_view.h"

namespace incision {
DeformableBody::DeformableBody(const Scene& scene, TetMesh mesh, const Descriptions& descriptions,
                               const MakeLinearSolver& make_solver)
    : state_(std::make_unique<State>(scene, std::move(mesh), descriptions, make_solver)) {}

DeformableBody::~DeformableBody() = default;

StepResult DeformableBody::step() {
  State& s = *state_;
  const auto start = Clock::now();
  StepResult result;
  s.applyDueCuts();
  result.phase_ms.cut = 1e3 * secondsSince(start);
  bool is_marked = false;
  if (s.growth) {
    const auto fracturing = Clock::now();
    is_marked = s.fracture();
    result.phase_ms.fracture = 1e3 * secondsSince(fracturing);
  }

  if (!s.allOrNothing([&] { return s.take(&result); }, is_marked)) {
    throw StepFailed("step " + std::to_string(s.steps) + " at " + std::to_string(s.time()) +
                     " s failed, also in shorter ones: the system is not positive definite or a value is not finite");
  }
  result.step_ms = 1e3 * secondsSince(start);
  return result;
}

void DeformableBody::State::fillResult(StepResult* result) {
  for (const Contact* contact : contacts) result->contact.add(contact->report());
  for (const auto& tool : tools) result->tools.push_back(tool->report());
  result->iterations = solved.iterations;
  result->residual = solved.residual;
  result->solves = solved.solves;
  result->settled = solved.settled;
  result->divided = divided;
  result->phase_ms.contact = couplers_ms;
  result->phase_ms.assembly = times.assembly;
  result->phase_ms.solve = times.solve;
  result->phase_ms.update = times.update;
  Reports taken = std::exchange(reports, Reports());
  result->cuts = std::move(taken.cuts);
  result->cracks = std::move(taken.cracks);
  if (wants_wrenches) std::swap(wrenches, felt);
}

Reports DeformableBody::takeReports() { return std::exchange(state_->reports, Reports()); }

CutResult DeformableBody::cut(const PlaneCut& plane) { return state_->cut(plane); }

std::size_t DeformableBody::tools() const { return state_->tools.size(); }

void DeformableBody::guideTool(const std::vector<Pose>& path, std::size_t tool) {
  state_->sound().tools.at(tool)->guide(path);
}

std::optional<CutResult> DeformableBody::placeTool(const Pose& pose, std::size_t tool) {
  Tool& of = *state_->tools.at(tool);
  return state_->allOrNothing([&] { return state_->ended(of.place(pose)); });
}

std::optional<CutResult> DeformableBody::liftTool(std::size_t tool) {
  Tool& of = *state_->tools.at(tool);
  return state_->allOrNothing([&] { return state_->ended(of.lift()); });
}

std::optional<CutResult> DeformableBody::activateTool(bool active, std::size_t tool) {
  Tool& of = *state_->tools.at(tool);
  return state_->allOrNothing([&] { return state_->ended(of.activate(active)); });
}

const std::optional<Pose>& DeformableBody::toolPose(std::size_t tool) const {
  return state_->sound().tools.at(tool)->pose();
}

void DeformableBody::guideJaw(double angle, std::size_t tool) { state_->sound().tools.at(tool)->guideJaw(angle); }

double DeformableBody::toolJaw(std::size_t tool) const { return state_->sound().tools.at(tool)->jaw(); }

ToolForm DeformableBody::toolForm(std::size_t tool) const { return state_->sound().tools.at(tool)->form(); }

std::vector<Pose> DeformableBody::toolGroups(std::size_t tool) const {
  const Tool& of = *state_->sound().tools.at(tool);
  std::vector<Pose> poses;
  if (!of.pose()) return poses;
  for (int g = 0; g < of.groups(); ++g) poses.push_back(composed(*of.pose(), of.groupPose(g, of.jaw())));
  return poses;
}

const Obstacles& DeformableBody::obstacles() const { return state_->obstacles; }

void DeformableBody::moveObstacle(int link, const Pose& pose) { state_->obstacle_motions.move(link, pose); }

void DeformableBody::placeObstacle(int link, const Pose& pose) { state_->obstacle_motions.place(link, pose); }

void DeformableBody::moveClamp(int clamp, const Pose& pose) { state_->clamp_motions.move(clamp, pose); }

void DeformableBody::placeClamp(int clamp, const Pose& pose) { state_->sound().placeClamp(clamp, pose); }

void DeformableBody::wantWrenches(bool wanted) {
  if (state_->wants_wrenches == wanted) return;
  state_->wrenches = wanted ? state_->noWrenches() : BodyWrenches();
  state_->wants_wrenches = wanted;
  state_->step.wantClampWrenches(wanted);
}

const BodyWrenches& DeformableBody::wrenches() const { return state_->wrenches; }

const LiveSettings& DeformableBody::live() const { return state_->live; }

void DeformableBody::set(const LiveSettings& settings) {
  if (const std::string why = whyInvalid(settings); !why.empty()) throw InputError(why);
  state_->sound().set(settings);
}

std::vector<CutResult> DeformableBody::reset() {
  std::vector<CutResult> strokes;
  state_->replace(state_->at_start, state_->live, &strokes);
  return strokes;
}

const Scene& DeformableBody::scene() const { return state_->scene; }
const CutMesh& DeformableBody::mesh() const { return state_->mesh; }
const Materials& DeformableBody::materials() const { return state_->materials; }
std::int64_t DeformableBody::steps() const { return state_->steps; }
std::int64_t DeformableBody::unsettledSteps() const { return state_->unsettled_steps; }
double DeformableBody::time() const { return state_->time(); }
const std::vector<Vec3>& DeformableBody::positions() const { return state_->motion.x; }
const std::vector<Vec3>& DeformableBody::velocities() const { return state_->motion.v; }

std::vector<Vec3> DeformableBody::nodePositions() const {
  std::vector<Vec3> positions = state_->mesh.mesh().nodes;
  for (std::size_t n = 0; n < positions.size(); ++n)
    if (const int own = state_->mesh.ownCopy(static_cast<int>(n)); own >= 0) positions[n] = state_->motion.x[own];
  return positions;
}

const RestBox& DeformableBody::bounds() const { return state_->bounds; }

BodyCounts DeformableBody::counts() const {
  const State& s = state_->sound();
  const CutMesh& mesh = s.mesh;
  BodyCounts counts;
  counts.nodes = static_cast<int>(mesh.mesh().nodes.size());
  const std::vector<int>& held = s.step.held();
  for (int n = 0; n < counts.nodes; ++n) counts.held_nodes += mesh.ownCopy(n) >= 0 && held[mesh.ownCopy(n)] >= 0;
  counts.elements = static_cast<int>(mesh.mesh().elements.size());
  counts.parts = static_cast<int>(mesh.parts().size());
  for (int e = 0; e < counts.elements; ++e) counts.crack_elements += mesh.parts()[e].next >= 0;
  counts.copies = mesh.numCopies();
  counts.dofs = 3 * counts.copies;
  counts.cracks = mesh.numCracks();
  counts.pieces = s.pieces();
  return counts;
}

BodyMotion DeformableBody::motion() const {
  const State& s = state_->sound();
  return motionOf(s.step.assembly(), s.motion, s.live.gravity);
}

std::vector<int> DeformableBody::heldCopies() const {
  std::vector<int> copies;
  const std::vector<int>& held = state_->sound().step.held();
  for (std::size_t c = 0; c < held.size(); ++c)
    if (held[c] >= 0) copies.push_back(static_cast<int>(c));
  return copies;
}

std::vector<Vec3> DeformableBody::loadForces() const {
  std::vector<Vec3> forces(state_->motion.x.size(), Vec3::Zero());
  state_->sound().step.loads().addTo(time(), state_->motion.x, &forces);
  return forces;
}

std::vector<double> DeformableBody::pieceVolumes() const {
  int pieces = 0;
  const std::vector<int> piece_of = state_->sound().pieceOf(&pieces);
  std::vector<double> volumes(pieces, 0);
  const std::vector<Part>& parts = state_->mesh.parts();
  for (std::size_t p = 0; p < parts.size(); ++p)
    volumes[piece_of[parts[p].copies[0]]] += state_->step.assembly().volume(static_cast<int>(p));
  std::sort(volumes.begin(), volumes.end());
  return volumes;
}

std::vector<double> DeformableBody::regionVolumes() const {
  const TetMesh& mesh = state_->mesh.mesh();
  const Regions& regions = state_->materials.regions();
  std::vector<double> volumes(regions.count(), 0);
  for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e) volumes[regions.of(e)] += elementVolume(mesh, e);
  return volumes;
}

std::vector<Mat3> DeformableBody::partStress() const {
  std::vector<Mat3> stress;
  state_->sound();
  for (std::size_t p = 0; p < state_->mesh.parts().size(); ++p)
    stress.push_back(state_->step.assembly().stress(static_cast<int>(p), state_->motion.x));
  return stress;
}

const Surface& DeformableBody::surface() const { return state_->surface.get(); }

std::uint64_t DeformableBody::topologyVersion() const { return state_->surface.version(); }

std::uint64_t DeformableBody::stateHash() const { return hashOf(state_->steps, state_->mesh, state_->motion); }

}  // namespace incision

#include "incision/body/deformable_body.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "body_state.h"
#include "incision/base/input_error.h"
#include "incision/base/parallel.h"

namespace incision {
namespace {

/// 64-bit FNV-1a.
class Hash {
 public:
  template <typename T>
  void add(const T* values, std::size_t count) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(values);
    for (std::size_t i = 0; i < count * sizeof(T); ++i) value_ = (value_ ^ bytes[i]) * 1099511628211ULL;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037ULL;
};

/// Largest |x − X| over the material [m]. Displacements are linear in each part, so its corners have the largest.
double largestDisplacement(const CutMesh& mesh, const std::vector<Vec3>& x) {
  std::vector<double> squares(mesh.parts().size());
  parallelFor(static_cast<int>(squares.size()), mesh.threads(), [&](int p) {
    const Part& part = mesh.parts()[p];
    std::array<Vec3, 4> u;
    for (int I = 0; I < 4; ++I) u[I] = x[part.copies[I]] - mesh.mesh().nodes[mesh.mesh().elements[part.element][I]];
    double largest = 0;
    for (const Barycentric& b : mesh.polytope(p).corners)
      largest = std::max(largest, (b[0] * u[0] + b[1] * u[1] + b[2] * u[2] + b[3] * u[3]).squaredNorm());
    squares[p] = largest;
  });
  return squares.empty() ? 0 : std::sqrt(*std::max_element(squares.begin(), squares.end()));
}

}  // namespace

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
  if (s.growth) {
    const auto fracturing = Clock::now();
    s.fracture();
    result.phase_ms.fracture = 1e3 * secondsSince(fracturing);
  }

  const double dt = s.scene.solver.time_step, t = s.time();
  for (const auto& tool : s.tools) tool->startStep(t, dt, s.motion.x);
  s.clamp_motions.startStep(t, dt);
  if (s.wants_wrenches) s.felt = s.noWrenches();
  s.times = StepTimes();
  s.couplers_ms = 0;
  s.solved = SolveStats();
  s.divided = false;
  if (!s.advance()) {
    throw StepFailed("step " + std::to_string(s.steps) + " at " + std::to_string(t) +
                     " s failed, also in shorter ones: the system is not positive definite or a value is not finite");
  }
  ++s.steps;
  if (!s.solved.settled) ++s.unsettled_steps;
  if (s.growth) s.growth->stepTaken();
  if (s.wants_wrenches) s.tellWrenches();
  s.obstacle_motions.endStep();
  s.clamp_motions.endStep();
  const auto cutting = Clock::now();
  s.endTools();
  if (!s.tools.empty()) result.phase_ms.cut += 1e3 * secondsSince(cutting);
  s.fillResult(&result);
  result.step_ms = 1e3 * secondsSince(start);
  return result;
}

void DeformableBody::State::fillResult(StepResult* result) {
  Reports taken = std::exchange(reports, Reports());
  result->cuts = std::move(taken.cuts);
  result->cracks = std::move(taken.cracks);
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
}

Reports DeformableBody::takeReports() { return std::exchange(state_->reports, Reports()); }

CutResult DeformableBody::cut(const PlaneCut& plane) { return state_->cut(plane); }

std::size_t DeformableBody::tools() const { return state_->tools.size(); }

void DeformableBody::guideTool(const std::vector<Pose>& path, std::size_t tool) { state_->tools.at(tool)->guide(path); }

std::optional<CutResult> DeformableBody::placeTool(const Pose& pose, std::size_t tool) {
  return state_->ended(state_->tools.at(tool)->place(pose));
}

std::optional<CutResult> DeformableBody::liftTool(std::size_t tool) {
  return state_->ended(state_->tools.at(tool)->lift());
}

std::optional<CutResult> DeformableBody::activateTool(bool active, std::size_t tool) {
  return state_->ended(state_->tools.at(tool)->activate(active));
}

const std::optional<Pose>& DeformableBody::toolPose(std::size_t tool) const { return state_->tools.at(tool)->pose(); }

void DeformableBody::guideJaw(double angle, std::size_t tool) { state_->tools.at(tool)->guideJaw(angle); }

double DeformableBody::toolJaw(std::size_t tool) const { return state_->tools.at(tool)->jaw(); }

ToolForm DeformableBody::toolForm(std::size_t tool) const { return state_->tools.at(tool)->form(); }

std::vector<Pose> DeformableBody::toolGroups(std::size_t tool) const {
  const Tool& of = *state_->tools.at(tool);
  std::vector<Pose> poses;
  if (!of.pose()) return poses;
  for (int g = 0; g < of.groups(); ++g) poses.push_back(composed(*of.pose(), of.groupPose(g, of.jaw())));
  return poses;
}

const Obstacles& DeformableBody::obstacles() const { return state_->obstacles; }

void DeformableBody::moveObstacle(int link, const Pose& pose) { state_->obstacle_motions.move(link, pose); }

void DeformableBody::placeObstacle(int link, const Pose& pose) { state_->obstacle_motions.place(link, pose); }

void DeformableBody::moveClamp(int clamp, const Pose& pose) { state_->clamp_motions.move(clamp, pose); }

void DeformableBody::placeClamp(int clamp, const Pose& pose) { state_->placeClamp(clamp, pose); }

void DeformableBody::wantWrenches(bool wanted) {
  if (state_->wants_wrenches == wanted) return;
  state_->wants_wrenches = wanted;
  state_->step.wantClampWrenches(wanted);
  state_->wrenches = wanted ? state_->noWrenches() : BodyWrenches();
}

const BodyWrenches& DeformableBody::wrenches() const { return state_->wrenches; }

const LiveSettings& DeformableBody::live() const { return state_->live; }

void DeformableBody::set(const LiveSettings& settings) {
  if (const std::string why = whyInvalid(settings); !why.empty()) throw InputError(why);
  state_->set(settings);
}

void DeformableBody::reset() { state_->recall(state_->at_start); }

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
  const CutMesh& mesh = state_->mesh;
  BodyCounts counts;
  counts.nodes = static_cast<int>(mesh.mesh().nodes.size());
  const std::vector<int>& held = state_->step.held();
  for (int n = 0; n < counts.nodes; ++n) counts.held_nodes += mesh.ownCopy(n) >= 0 && held[mesh.ownCopy(n)] >= 0;
  counts.elements = static_cast<int>(mesh.mesh().elements.size());
  counts.parts = static_cast<int>(mesh.parts().size());
  for (int e = 0; e < counts.elements; ++e) counts.crack_elements += mesh.parts()[e].next >= 0;
  counts.copies = mesh.numCopies();
  counts.dofs = 3 * counts.copies;
  counts.cracks = mesh.numCracks();
  counts.pieces = state_->pieces();
  return counts;
}

BodyMotion DeformableBody::motion() const {
  const State& s = *state_;
  const Assembly& assembly = s.step.assembly();
  BodyMotion motion;
  std::vector<Vec3> Mv;
  assembly.multiplyMass(s.motion.v, &Mv);
  for (int c = 0; c < s.mesh.numCopies(); ++c) {
    motion.mass += assembly.masses()[c];
    motion.momentum += Mv[c];
    motion.kinetic_energy += 0.5 * s.motion.v[c].dot(Mv[c]);
    motion.potential_energy -= assembly.masses()[c] * s.live.gravity.dot(s.motion.x[c]);
  }
  motion.max_displacement = largestDisplacement(s.mesh, s.motion.x);
  motion.elastic_energy = assembly.elasticEnergy(s.motion.x);
  return motion;
}

std::vector<int> DeformableBody::heldCopies() const {
  std::vector<int> copies;
  const std::vector<int>& held = state_->step.held();
  for (std::size_t c = 0; c < held.size(); ++c)
    if (held[c] >= 0) copies.push_back(static_cast<int>(c));
  return copies;
}

std::vector<Vec3> DeformableBody::loadForces() const {
  std::vector<Vec3> forces(state_->motion.x.size(), Vec3::Zero());
  state_->step.loads().addTo(time(), state_->motion.x, &forces);
  return forces;
}

std::vector<double> DeformableBody::pieceVolumes() const {
  int pieces = 0;
  const std::vector<int> piece_of = state_->pieceOf(&pieces);
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
  for (std::size_t p = 0; p < state_->mesh.parts().size(); ++p)
    stress.push_back(state_->step.assembly().stress(static_cast<int>(p), state_->motion.x));
  return stress;
}

const Surface& DeformableBody::surface() const { return state_->surface.get(); }

std::uint64_t DeformableBody::topologyVersion() const { return state_->surface.version(); }

std::uint64_t DeformableBody::stateHash() const {
  const State& s = *state_;
  Hash hash;
  hash.add(&s.steps, 1);
  for (const Part& part : s.mesh.parts()) hash.add(part.copies.data(), part.copies.size());
  for (const auto* values : {&s.motion.x, &s.motion.v})
    for (const Vec3& value : *values) hash.add(value.data(), 3);
  return hash.value();
}

}  // namespace incision

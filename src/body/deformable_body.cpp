#include "incision/body/deformable_body.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <limits>

#include "incision/mesh/input_error.h"
#include "incision/mesh/node_order.h"
#include "incision/solver/implicit_step.h"
#include "incision/tool/stroke.h"

namespace incision {
namespace {

using Clock = std::chrono::steady_clock;

/// A command due within this [s] of a step's start takes effect before it.
constexpr double DUE_TOLERANCE = 1e-9;

/// The tool's sweep is cut into pieces that turn by no more than this [rad], so that each is nearly flat.
constexpr double MAX_SWEEP_TURN = 0.1;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

bool movedLess(const Edge& from, const Edge& to, double distance) {
  return (to[0] - from[0]).norm() < distance && (to[1] - from[1]).norm() < distance;
}

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

TetMesh withOrderedElements(TetMesh mesh) {
  orderElements(&mesh);
  return mesh;
}

std::string missedReason(const Insertion& done) {
  if (done.out_of_bounds == 0) return "it crosses no part of the body that is not cut there already";
  return "its plane crosses " + std::to_string(done.out_of_bounds) +
         " parts but its bounds hold the centre of no section: smaller than the elements, or beside the body";
}

}  // namespace

struct DeformableBody::State {
  State(const Scene& s, TetMesh rest, const Descriptions& descriptions)
      : scene(s),
        mesh(withOrderedElements(std::move(rest)), s.solver.threads),
        step(mesh, s.body.material, s.body.mass, s.body.warping, {s.gravity, s.boundary, s.loads}, s.solver) {
    if (scene.tool) edge = bladeEdge(*scene.tool, descriptions.tool, scene.tool->description);
    if (scene.contact)
      contact.emplace(*scene.contact, loadObstacles(*scene.contact, descriptions.obstacles, scene.contact->obstacles),
                      scene.body.material.young_modulus, scene.solver.threads);
    for (std::size_t n = 0; n < mesh.mesh().nodes.size(); ++n)
      least_motion = std::min(least_motion, SNAP * mesh.shortestEdge(static_cast<int>(n)));
    start();
  }

  void start();
  void placeNewCopies();
  void topologyChanged(const std::vector<int>& touched = {});
  CrackField fieldOf(const PlaneCut& plane) const;
  CutResult cut(const PlaneCut& plane);
  std::optional<CutResult> moveTool(const Pose& pose);
  std::optional<CutResult> endStroke();
  void applyDue(StepResult* result);
  void fracture(StepResult* result);
  const Surface& currentSurface() const;
  bool advance(double time, double time_step);
  bool advanceInHalves(double time, double time_step);
  std::optional<Pose> scenePose() const;
  double time() const { return static_cast<double>(steps) * scene.solver.time_step; }

  Scene scene;
  CutMesh mesh;
  ImplicitStep step;
  Motion motion;
  std::int64_t steps = 0;
  std::deque<ScheduledCut> scheduled;                             // by time; equal times in the order they came
  Edge edge;                                                      // of the blade, in its link's frame
  double least_motion = std::numeric_limits<double>::infinity();  // of the edge [m], below which it has not moved
  std::optional<Pose> tool_pose;
  std::optional<CrackGrowth> growth;  // where the scene lets the body break
  std::optional<Cohesion> cohesion;   // where opening a crack takes energy
  std::optional<Contact> contact;     // where the scene lets the body touch
  LinkMotion links;                   // of the obstacles, from the step's start to its end
  ContactReport touching;
  Stroke stroke;
  CutResult stroke_result;
  std::uint64_t topology_version = 0;
  std::uint64_t contact_version = 0;
  mutable Surface surface;
  mutable std::uint64_t surface_version = 0;
};

void DeformableBody::State::start() {
  motion.x.clear();
  for (int c = 0; c < mesh.numCopies(); ++c) motion.x.push_back(mesh.mesh().nodes[mesh.copyNode(c)]);
  motion.v.assign(motion.x.size(), Vec3::Zero());
  steps = 0;
  scheduled.assign(scene.cuts.begin(), scene.cuts.end());
  std::stable_sort(scheduled.begin(), scheduled.end(),
                   [](const ScheduledCut& a, const ScheduledCut& b) { return a.time < b.time; });
  tool_pose.reset();
  stroke = Stroke();
  stroke_result = CutResult();
  if (scene.fracture) growth.emplace(*scene.fracture);
  if (scene.fracture && scene.fracture->fracture_energy)
    cohesion.emplace(*scene.fracture, scene.body.material.young_modulus);
  if (contact) {
    contact->reset();
    links = LinkMotion();
    for (const ObstacleLink& link : contact->obstacles().links) links.to.push_back(link.pose);
    links.from = links.to;
  }
  topologyChanged();
}

/// New copies start where their parent is, and move as it does.
void DeformableBody::State::placeNewCopies() {
  for (int c = static_cast<int>(motion.x.size()); c < mesh.numCopies(); ++c) {
    motion.x.push_back(motion.x[mesh.copyParent(c)]);
    motion.v.push_back(motion.v[mesh.copyParent(c)]);
  }
}

void DeformableBody::State::topologyChanged(const std::vector<int>& touched) {
  placeNewCopies();
  step.topologyChanged(motion, touched);
  if (growth) growth->topologyChanged(step.assembly(), touched);
  if (cohesion) cohesion->topologyChanged(mesh);
  ++topology_version;
}

/// A cut that may grow passes beside the nodes, by no more than the distance within which others go through them.
CrackField DeformableBody::State::fieldOf(const PlaneCut& plane) const {
  CrackField field = planeField(plane, mesh, motion.x);
  if (!growth) return field;
  for (int c = 0; c < mesh.numCopies(); ++c)
    if (field.phi[c] == 0) field.phi[c] = SNAP * mesh.shortestEdge(mesh.copyNode(c));
  return field;
}

/// Cracks start and grow where the stress at the step's start asks for it. Nothing moves.
void DeformableBody::State::fracture(StepResult* result) {
  const double now = time();
  result->cracks = growth->fuse(now, mesh, motion.x);
  std::vector<int> touched;
  for (const CrackAdvance& advance :
       growth->advances(now, scene.solver.time_step, step.assembly(), motion.x, step.pieceOf())) {
    const std::optional<CrackField> field = growth->field(advance, mesh);
    if (!field) continue;
    try {
      const Insertion done = mesh.insert(*field);
      if (!done.changed()) {
        growth->refused(now, advance);
        continue;
      }
      placeNewCopies();
      result->cracks.push_back(growth->inserted(now, advance, *field, done, mesh, motion.x));
      if (cohesion) cohesion->add(done, mesh, motion.x);
      touched.insert(touched.end(), done.touched.begin(), done.touched.end());
    } catch (const InputError& limit) {
      result->cracks.push_back(growth->refused(now, advance));
    }
  }
  if (!touched.empty()) topologyChanged(touched);
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

const Surface& DeformableBody::State::currentSurface() const {
  if (surface_version != topology_version) {
    surface = buildSurface(mesh);
    surface_version = topology_version;
  }
  return surface;
}

/// One step of `time_step`, in which the obstacles move from links.from to links.to. Returns false with nothing
/// changed.
bool DeformableBody::State::advance(double time, double time_step) {
  const bool holds = cohesion && !cohesion->empty();
  if (!contact && !holds) return step.advance(time, time_step, &motion);
  if (contact) {
    if (contact_version != topology_version) contact->surfaceChanged(currentSurface(), mesh, step.pieceOf());
    contact_version = topology_version;
    contact->begin(motion, time_step, links);
  }
  if (holds) cohesion->begin(mesh, motion.x);
  const auto couple = [&](double dt, const std::vector<Vec3>& v_end, std::vector<Coupling>* couplings) {
    couplings->clear();
    const bool touch_changes = contact && contact->update(dt, v_end, couplings);
    const bool hold_changes = holds && cohesion->update(dt, v_end, couplings);
    return touch_changes || hold_changes;
  };
  if (!step.advance(time, time_step, &motion, couple)) return false;
  if (holds) cohesion->accept(motion.x);
  if (!contact) return true;
  touching = contact->accept(time_step, motion.v);
  links.from = links.to;
  return true;
}

/// Two steps of half the length; returns false, with the state as it was, when one of them fails.
bool DeformableBody::State::advanceInHalves(double time, double time_step) {
  const Motion before = motion;
  const LinkMotion whole = links;
  const std::optional<Contact> contact_before = contact;
  const std::optional<Cohesion> cohesion_before = cohesion;
  const double half = time_step / 2;
  for (std::size_t i = 0; i < links.to.size(); ++i) links.to[i] = between(whole.from[i], whole.to[i], 0.5);
  if (advance(time, half)) {
    links.to = whole.to;
    if (advance(time + half, half)) return true;
  }
  motion = before;
  links = whole;
  contact = contact_before;
  cohesion = cohesion_before;
  return false;
}

DeformableBody::DeformableBody(const Scene& scene, TetMesh mesh, const Descriptions& descriptions)
    : state_(std::make_unique<State>(scene, std::move(mesh), descriptions)) {}

DeformableBody::~DeformableBody() = default;

StepResult DeformableBody::step() {
  State& s = *state_;
  const auto start = Clock::now();
  StepResult result;
  s.applyDue(&result);
  result.phase_ms.cut = 1e3 * secondsSince(start);
  if (s.growth) {
    const auto fracturing = Clock::now();
    s.fracture(&result);
    result.phase_ms.fracture = 1e3 * secondsSince(fracturing);
  }

  const double dt = s.scene.solver.time_step, t = s.time();
  if (!s.advance(t, dt) && !s.advanceInHalves(t, dt)) {
    throw StepFailed("step " + std::to_string(s.steps) + " at " + std::to_string(t) +
                     " s failed, also in two halves: the system is not positive definite or a value is not finite");
  }
  ++s.steps;
  if (s.growth) s.growth->stepTaken();
  result.contact = s.touching;
  result.iterations = s.step.stats().iterations;
  result.residual = s.step.stats().residual;
  result.phase_ms.assembly = s.step.times().assembly;
  result.phase_ms.solve = s.step.times().solve;
  result.phase_ms.update = s.step.times().update;
  result.step_ms = 1e3 * secondsSince(start);
  return result;
}

CutResult DeformableBody::cut(const PlaneCut& plane) { return state_->cut(plane); }

void DeformableBody::schedule(const ScheduledCut& cut) {
  auto& scheduled = state_->scheduled;
  const auto later = std::upper_bound(scheduled.begin(), scheduled.end(), cut.time,
                                      [](double t, const ScheduledCut& other) { return t < other.time; });
  scheduled.insert(later, cut);
}

std::optional<CutResult> DeformableBody::moveTool(const Pose& pose) { return state_->moveTool(pose); }

std::optional<CutResult> DeformableBody::liftTool() {
  state_->tool_pose.reset();
  return state_->endStroke();
}

const Obstacles& DeformableBody::obstacles() const {
  static const Obstacles none;
  return state_->contact ? state_->contact->obstacles() : none;
}

void DeformableBody::moveObstacle(int link, const Pose& pose) { state_->links.to[link] = pose; }

void DeformableBody::placeObstacle(int link, const Pose& pose) {
  state_->links.from[link] = state_->links.to[link] = pose;
}

void DeformableBody::reset() {
  state_->mesh = CutMesh(state_->mesh.mesh(), state_->mesh.threads());
  state_->step.reset();
  state_->start();
}

const Scene& DeformableBody::scene() const { return state_->scene; }
const CutMesh& DeformableBody::mesh() const { return state_->mesh; }
std::int64_t DeformableBody::steps() const { return state_->steps; }
double DeformableBody::time() const { return state_->time(); }
const std::vector<Vec3>& DeformableBody::positions() const { return state_->motion.x; }
const std::vector<Vec3>& DeformableBody::velocities() const { return state_->motion.v; }

std::vector<Vec3> DeformableBody::nodePositions() const {
  std::vector<Vec3> positions = state_->mesh.mesh().nodes;
  for (std::size_t n = 0; n < positions.size(); ++n)
    if (const int own = state_->mesh.ownCopy(static_cast<int>(n)); own >= 0) positions[n] = state_->motion.x[own];
  return positions;
}

BodyCounts DeformableBody::counts() const {
  const CutMesh& mesh = state_->mesh;
  BodyCounts counts;
  counts.nodes = static_cast<int>(mesh.mesh().nodes.size());
  counts.elements = static_cast<int>(mesh.mesh().elements.size());
  counts.parts = static_cast<int>(mesh.parts().size());
  for (int e = 0; e < counts.elements; ++e) counts.crack_elements += mesh.parts()[e].next >= 0;
  counts.copies = mesh.numCopies();
  counts.dofs = 3 * counts.copies;
  counts.cracks = mesh.numCracks();
  counts.pieces = state_->step.pieces();
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
    motion.max_displacement =
        std::max(motion.max_displacement, (s.motion.x[c] - s.mesh.mesh().nodes[s.mesh.copyNode(c)]).norm());
  }
  motion.elastic_energy = assembly.elasticEnergy(s.motion.x);
  return motion;
}

std::vector<double> DeformableBody::pieceVolumes() const {
  std::vector<double> volumes(state_->step.pieces(), 0);
  const std::vector<Part>& parts = state_->mesh.parts();
  for (std::size_t p = 0; p < parts.size(); ++p)
    volumes[state_->step.pieceOf()[parts[p].copies[0]]] += state_->step.assembly().volume(static_cast<int>(p));
  std::sort(volumes.begin(), volumes.end());
  return volumes;
}

std::vector<Mat3> DeformableBody::partStress() const {
  std::vector<Mat3> stress;
  for (std::size_t p = 0; p < state_->mesh.parts().size(); ++p)
    stress.push_back(state_->step.assembly().stress(static_cast<int>(p), state_->motion.x));
  return stress;
}

const Surface& DeformableBody::surface() const { return state_->currentSurface(); }

std::uint64_t DeformableBody::topologyVersion() const { return state_->topology_version; }

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

#include <algorithm>

#include "body_state.h"
#include "incision/base/input_error.h"
#include "incision/mesh/node_order.h"

namespace incision {
namespace {

TetMesh withOrderedElements(TetMesh mesh) {
  orderElements(&mesh);
  return mesh;
}

}  // namespace

DeformableBody::State::State(const Scene& s, TetMesh rest, const Descriptions& descriptions)
    : scene(s),
      mesh(withOrderedElements(std::move(rest)), s.solver.threads),
      step(mesh, s.body.material, s.body.mass, s.body.pressure, s.body.warping, {s.gravity, s.boundary, s.loads},
           s.solver) {
  if (scene.tool) edge = bladeEdge(*scene.tool, descriptions.tool, scene.tool->description);
  if (scene.contact) {
    Obstacles obstacles = loadObstacles(*scene.contact, descriptions.obstacles, scene.contact->obstacles);
    if (scene.tool && !scene.tool->link.empty() && !descriptions.tool.empty())
      addTool({scene.tool->link, scene.tool->friction, edge}, descriptions.tool, scene.tool->description, &obstacles);
    contact.emplace(*scene.contact, std::move(obstacles), scene.body.material.young_modulus, scene.solver.threads);
  }
  start();
}

void DeformableBody::State::start() {
  motion.x.clear();
  for (int c = 0; c < mesh.numCopies(); ++c) motion.x.push_back(mesh.mesh().nodes[mesh.copyNode(c)]);
  motion.v.assign(motion.x.size(), Vec3::Zero());
  steps = 0;
  scheduled.assign(scene.cuts.begin(), scene.cuts.end());
  std::stable_sort(scheduled.begin(), scheduled.end(),
                   [](const ScheduledCut& a, const ScheduledCut& b) { return a.time < b.time; });
  tool = ToolMotion();
  stroke = Stroke();
  stroke_result = CutResult();
  area_before = last_area = 0;
  on_tool = Wrench();
  if (scene.tool) {
    ties.emplace(scene.body.material.young_modulus, scene.tool->progressive);
    cutting.emplace(*scene.tool, scene.body.material.young_modulus, mesh);
  }
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
  past.forget();
  if (growth) growth->topologyChanged(step.assembly(), touched);
  if (cohesion) cohesion->topologyChanged(mesh);
  if (ties) ties->topologyChanged(mesh);
  ++topology_version;
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

const Surface& DeformableBody::State::currentSurface() const {
  if (surface_version != topology_version) {
    surface = buildSurface(mesh);
    surface_version = topology_version;
  }
  return surface;
}

/// Finds what may act in a step from here; returns whether anything may.
bool DeformableBody::State::beginCouplings(double time_step) {
  if (contact) {
    const auto start = Clock::now();
    if (contact_version != topology_version) contact->surfaceChanged(currentSurface(), mesh, step.pieceOf());
    contact_version = topology_version;
    contact->begin(motion, time_step, links);
    contact_ms = 1e3 * secondsSince(start);
  }
  if (tool.pose && tool.active) cutting->begin(placed(edge, tool.from), placed(edge, tool.to), mesh, motion.x, *ties);
  acting.contact = contact && contact->mayTouch();
  acting.cohesion = cohesion && !cohesion->empty();
  acting.ties = ties && !ties->empty();
  acting.edge = cutting && cutting->held();
  if (acting.cohesion) cohesion->begin(mesh, motion.x);
  if (acting.ties) ties->begin(mesh, motion.x);
  return acting.contact || acting.cohesion || acting.ties || acting.edge;
}

/// As Couple says.
bool DeformableBody::State::updateCouplings(double time_step, const std::vector<Vec3>& v_end,
                                            std::vector<Coupling>* couplings) {
  couplings->clear();
  const bool touch_changes = acting.contact && contact->update(time_step, v_end, couplings);
  const bool hold_changes = acting.cohesion && cohesion->update(time_step, v_end, couplings);
  const bool edge_changes = acting.edge && cutting->update(time_step, v_end, couplings);
  if (acting.ties) ties->append(couplings);
  return touch_changes || hold_changes || edge_changes;
}

/// The step has been taken.
void DeformableBody::State::acceptCouplings(double time_step) {
  if (acting.cohesion) cohesion->accept(motion.x);
  if (acting.edge) cutting->accept(time_step, motion.v);
  tool.from = tool.to;
  if (!contact) return;
  touching = contact->accept(time_step, motion.v);
  links.from = links.to;
}

/// One step of `time_step`, in which the obstacles and the tool move from where they are to where they go. Returns
/// false with nothing changed.
bool DeformableBody::State::advance(double time, double time_step) {
  const bool coupled = beginCouplings(time_step);
  if (coupled) past.forget();
  const auto couple = [&](double dt, const std::vector<Vec3>& v_end, std::vector<Coupling>* couplings) {
    return updateCouplings(dt, v_end, couplings);
  };
  if (!(coupled ? step.advance(time, time_step, &motion, couple) : advanceFreely(time, time_step))) return false;
  on_tool = seenFrom(tool.from, step.onTool());
  acceptCouplings(time_step);
  return true;
}

/// One step in which nothing is touched.
bool DeformableBody::State::advanceFreely(double time, double time_step) {
  if (scene.solver.integrator == Integrator::EULER) return step.advance(time, time_step, &motion);
  return past.advance(time, time_step, &step, &motion);
}

/// Two steps of half the length; returns false, with the state as it was, when one of them fails.
bool DeformableBody::State::advanceInHalves(double time, double time_step) {
  const Motion before = motion;
  const LinkMotion whole = links;
  const ToolMotion whole_tool = tool;
  const std::optional<Contact> contact_before = contact;
  const std::optional<Cohesion> cohesion_before = cohesion;
  const std::optional<CuttingEdge> cutting_before = cutting;
  const double half = time_step / 2;
  past.forget();
  for (std::size_t i = 0; i < links.to.size(); ++i) links.to[i] = between(whole.from[i], whole.to[i], 0.5);
  tool.to = between(tool.from, tool.to, 0.5);
  if (advance(time, half)) {
    links.to = whole.to;
    tool.to = whole_tool.to;
    const Wrench first = on_tool;
    const bool done = advance(time + half, half);
    past.forget();
    if (done) {
      on_tool = between(first, on_tool, 0.5);
      return true;
    }
  }
  motion = before;
  links = whole;
  tool = whole_tool;
  contact = contact_before;
  cohesion = cohesion_before;
  cutting = cutting_before;
  return false;
}

}  // namespace incision

#include "body_state.h"

#include <algorithm>
#include <utility>

#include "incision/mesh/node_order.h"
#include "incision/tool/kinds.h"

namespace incision {
namespace {

TetMesh withOrderedElements(TetMesh mesh) {
  orderElements(&mesh);
  return mesh;
}

std::vector<ScheduledCut> byTime(std::vector<ScheduledCut> cuts) {
  std::stable_sort(cuts.begin(), cuts.end(),
                   [](const ScheduledCut& a, const ScheduledCut& b) { return a.time < b.time; });
  return cuts;
}

Obstacles obstaclesOf(const Scene& scene, const Descriptions& descriptions) {
  if (!scene.contact) return {};
  return loadObstacles(*scene.contact, descriptions.obstacles, scene.contact->obstacles);
}

/// Whether opening a crack takes energy anywhere.
bool takesEnergy(const Scene& scene) {
  const auto& regions = scene.body.regions;
  return scene.fracture && (scene.fracture->fracture_energy ||
                            std::any_of(regions.begin(), regions.end(), [](const RegionSettings& region) {
                              return region.fracture_energy.has_value();
                            }));
}

Motion atRest(const CutMesh& mesh) {
  Motion motion;
  for (int c = 0; c < mesh.numCopies(); ++c) motion.x.push_back(mesh.mesh().nodes[mesh.copyNode(c)]);
  motion.v.assign(motion.x.size(), Vec3::Zero());
  return motion;
}

}  // namespace

DeformableBody::State::State(const Scene& s, TetMesh rest, const Descriptions& descriptions,
                             const MakeLinearSolver& make_solver)
    : scene(s),
      live(liveSettingsOf(s)),
      cuts(byTime(s.cuts)),
      mesh(withOrderedElements(std::move(rest)), s.solver.threads),
      bounds(boundsOf(mesh.mesh())),
      materials(mesh.mesh(), s.body.material, s.body.regions),
      step(mesh, materials, s.body.mass, s.body.pressure, s.body.warping, {s.gravity, s.boundary, s.loads}, s.solver,
           make_solver ? make_solver : makeLinearSolver),
      motion(atRest(mesh)),
      surface(mesh),
      obstacles(obstaclesOf(s, descriptions)),
      obstacle_motions(obstacles),
      clamp_motions(scene.boundary),
      skin(surface, materials, s.solver.threads),
      near_parts(mesh, materials.meanSize()),
      door(&mesh, &motion, &step, &last_steps, &growth, &couplers, &near_parts, &surface) {
  if (scene.fracture) growth.emplace(*scene.fracture);
  makeTools(descriptions);
  makeCouplers();
  door.meshReplaced();
  at_start = keep();
  at_start.step.step.rotations = std::vector<Mat3>();  // found again from the body at rest
}

void DeformableBody::State::makeTools(const Descriptions& descriptions) {
  if (scene.tools.empty()) return;
  ties.emplace(materials);
  for (std::size_t i = 0; i < scene.tools.size(); ++i) {
    const std::string urdf = i < descriptions.tools.size() ? descriptions.tools[i] : "";
    tools.push_back(
        makeTool(scene.tools[i], urdf, {mesh, materials, *ties, near_parts, scene.contact ? &skin : nullptr}));
  }
}

/// Whatever couples the body to itself or to something else is an entry here.
void DeformableBody::State::makeCouplers() {
  std::vector<Coupler*> list;
  if (scene.contact) {
    own_couplers.push_back(std::make_unique<BodyContact>(*scene.contact, obstacles, obstacle_motions.inStep(), &skin));
    body_contact = static_cast<BodyContact*>(own_couplers.back().get());
    contacts.push_back(body_contact);
  }
  if (takesEnergy(scene)) {
    own_couplers.push_back(std::make_unique<Cohesion>(*scene.fracture, materials));
    cohesion = static_cast<Cohesion*>(own_couplers.back().get());
  }
  for (const auto& coupler : own_couplers) list.push_back(coupler.get());
  for (const auto& tool : tools) {
    for (Coupler* coupler : tool->couplers()) list.push_back(coupler);
    for (const auto& contact : tool->touching()) contacts.push_back(contact.get());
  }
  if (ties) list.push_back(&*ties);
  couplers = Couplers(list);
}

/// The piece of each copy, and how many there are: what couplers tie counts as one.
std::vector<int> DeformableBody::State::pieceOf(int* pieces) const {
  std::vector<int> piece_of = step.pieceOf();
  *pieces = couplers.joinPieces(mesh, step.pieces(), &piece_of);
  return piece_of;
}

int DeformableBody::State::pieces() const {
  int count = 0;
  pieceOf(&count);
  return count;
}

StepMemory DeformableBody::State::keepStep() const {
  StepMemory memory{motion, step.keep(), last_steps.keep(), couplers.keep(), {}};
  for (const auto& tool : tools) memory.tools.push_back(tool->keep());
  return memory;
}

/// The mesh must be the one that the memory was kept of.
void DeformableBody::State::recallStep(const StepMemory& memory) {
  motion = memory.motion;
  step.recall(memory.step);
  last_steps.recall(memory.last_steps);
  couplers.recall(memory.couplers);
  for (std::size_t i = 0; i < tools.size(); ++i) tools[i]->recall(memory.tools[i]);
}

/// Finds all anew that depends on the mesh, for which the motion and the growth of cracks hold already.
void DeformableBody::State::recallAll(const StepMemory& memory) {
  door.forgetChanges();
  couplers.recall(memory.couplers);  // theirs must be of the mesh when they are told of it
  door.meshReplaced();
  step.recall(memory.step);
  last_steps.recall(memory.last_steps);
  couplers.recall(memory.couplers);
  for (std::size_t i = 0; i < tools.size(); ++i) tools[i]->recall(memory.tools[i]);
}

BodyMemory DeformableBody::State::keep() const {
  BodyMemory memory{steps,
                    unsettled_steps,
                    cuts_done,
                    fractured_steps,
                    live,
                    mesh.keep(),
                    {},
                    obstacle_motions.inStep(),
                    clamp_motions.keep(),
                    keepStep()};
  if (growth) memory.growth = growth->memory();
  return memory;
}

/// Another state in place of the one there is. Where somebody asks for the strokes under way they are ended before.
void DeformableBody::State::replace(const BodyMemory& memory, const LiveSettings& settings,
                                    std::vector<CutResult>* strokes) {
  CutMesh::Memory other = memory.mesh;
  BodyWrenches none = wants_wrenches ? noWrenches() : BodyWrenches();
  allOrNothing([&] {
    if (strokes != nullptr) endStrokes(strokes);
    markRotations();
    mesh.exchange(&other);
    try {
      steps = memory.steps;
      unsettled_steps = memory.unsettled_steps;
      cuts_done = memory.cuts_done;
      fractured_steps = memory.fractured_steps;
      obstacle_motions.recall(memory.obstacles);
      clamp_motions.recall(memory.clamps);
      motion = memory.step.motion;
      if (growth) growth->recall(*memory.growth);
      recallAll(memory.step);
      set(settings);
    } catch (...) {
      mesh.exchange(&other);
      throw;
    }
  });
  reports = Reports();
  std::swap(wrenches, none);
}

}  // namespace incision

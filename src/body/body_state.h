#pragma once

#include <any>
#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "body_door.h"
#include "clamp_motions.h"
#include "incision/body/deformable_body.h"
#include "incision/contact/body_contact.h"
#include "incision/fracture/cohesion.h"
#include "incision/tool/blade/ties.h"
#include "incision/tool/near_parts.h"
#include "incision/tool/tool.h"
#include "obstacle_motions.h"

namespace incision {

using Clock = std::chrono::steady_clock;

inline double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// What of a body a step that fails may have changed: all but the mesh, and what depends on the mesh alone.
struct StepMemory {
  Motion motion;
  ImplicitStep::Memory step;
  BackwardDifference::Memory last_steps;
  std::vector<std::any> couplers;
  std::vector<std::any> tools;
};

/// All but what couplers and tools write themselves.
template <class Archive>
void serialize(Archive& archive, StepMemory& memory) {
  auto& [motion, step, last_steps, couplers, tools] = memory;
  archive(motion, step, last_steps);
}

/// What of a body outlasts a step.
struct BodyMemory {
  std::int64_t steps = 0, unsettled_steps = 0;
  std::size_t cuts_done = 0;
  std::int64_t fractured_steps = 0;
  LiveSettings live;
  CutMesh::Memory mesh;
  std::optional<CrackGrowth::Memory> growth;
  std::vector<RigidMotion> obstacles;
  std::vector<ClampMotion> clamps;
  StepMemory step;
};

template <class Archive>
void serialize(Archive& archive, BodyMemory& memory) {
  auto& [steps, unsettled_steps, cuts_done, fractured_steps, live, mesh, growth, obstacles, clamps, step] = memory;
  archive(steps, unsettled_steps, cuts_done, fractured_steps, live, mesh, growth, obstacles, clamps, step);
}

/// What a call found that may have to be undone, in room that it keeps. The mesh has a journal of its own, and the
/// rotations are only taken over when they are needed.
struct BodyMark {
  std::int64_t steps = 0, unsettled_steps = 0;
  std::size_t cuts_done = 0;
  std::int64_t fractured_steps = 0;
  std::size_t cuts = 0, cracks = 0;  // told in the reports
  std::optional<CrackGrowth::Memory> growth;
  std::optional<std::uint64_t> growth_version;  // of which that is
  std::vector<RigidMotion> obstacles;
  std::vector<ClampMotion> clamps;
  StepMemory step;
  bool has_rotations = false;  // in the memory of the step
};

/// What a body is made of. Commands change the mesh, steps the motion.
struct DeformableBody::State {
  State(const Scene& s, TetMesh rest, const Descriptions& descriptions, const MakeLinearSolver& make_solver);

  void makeTools(const Descriptions& descriptions);
  void makeCouplers();

  // Undoing, in body_undo.cpp.
  State& sound();
  void mark();
  void markGrowth();
  void markRotations();
  void undo() noexcept;
  template <class Change>
  auto allOrNothing(const Change& change, bool is_marked = false);

  // Commands.
  CutResult cut(const PlaneCut& plane);
  CutResult cutNow(const PlaneCut& plane);
  CrackField fieldOf(const PlaneCut& plane) const;
  void applyDueCuts();
  CutResult withPieces(CutResult cut) const;
  std::optional<CutResult> ended(const std::optional<CutResult>& stroke) const;
  void endStrokes(std::vector<CutResult>* strokes);
  void set(const LiveSettings& settings);

  // A step.
  bool fracture();
  void grow(const std::vector<CrackAdvance>& advances);
  bool take(StepResult* result);
  bool advance();
  bool advance(const StepSpan& span, double time, StepDemand demand);
  bool advanceFreely(double time, double time_step);
  void endTools();
  void placeClamp(int clamp, const Pose& pose);
  void feel(const StepSpan& span, bool coupled);
  BodyWrenches noWrenches() const;
  void turnWrenches();
  void fillResult(StepResult* result);

  // The memory.
  StepMemory keepStep() const;
  void recallStep(const StepMemory& memory);
  void recallAll(const StepMemory& memory);
  BodyMemory keep() const;
  void replace(const BodyMemory& memory, const LiveSettings& settings, std::vector<CutResult>* strokes = nullptr);
  void write(const BodyMemory& memory, ArchiveWriter* archive) const;
  BodyMemory read(ArchiveReader* archive) const;
  void check(const BodyMemory& memory, const MemoryLimits& limits) const;
  std::array<std::int64_t, 7> outline() const;

  std::vector<int> pieceOf(int* pieces) const;
  int pieces() const;
  double time() const { return static_cast<double>(steps) * scene.solver.time_step; }

  Scene scene;
  LiveSettings live;
  std::vector<ScheduledCut> cuts;  // of the scene, by time
  CutMesh mesh;
  const RestBox bounds;  // of the mesh
  Materials materials;
  ImplicitStep step;
  BackwardDifference last_steps;  // for steps of second order
  Motion motion;
  std::int64_t steps = 0, unsettled_steps = 0;
  std::size_t cuts_done = 0;         // of the scene's
  std::int64_t fractured_steps = 0;  // for which cracks have grown: a step that is tried again grows none
  CurrentSurface surface;
  Obstacles obstacles;
  ObstacleMotions obstacle_motions;
  ClampMotions clamp_motions;
  ContactSkin skin;
  std::optional<CrackGrowth> growth;  // where the scene lets the body break
  NearParts near_parts;
  std::optional<Ties> ties;  // of what tools' edges have not swept yet, where there are tools
  std::vector<std::unique_ptr<Tool>> tools;
  std::vector<std::unique_ptr<Coupler>> own_couplers;  // those that are not a tool's
  BodyContact* body_contact = nullptr;                 // where the scene has contact
  Cohesion* cohesion = nullptr;                        // where opening a crack takes energy
  std::vector<const Contact*> contacts;                // all of them, for the report
  Couplers couplers;
  BodyDoor door;
  Reports reports;  // of what has happened and nobody has taken yet
  // Of the step, all its parts and those tried in vain included:
  double couplers_ms = 0;  // to find what may act in it
  StepTimes times;
  SolveStats solved;
  bool divided = false;
  // What the body does to clamps and obstacles, where it is wanted: in the step so far, and in the one taken last.
  bool wants_wrenches = false;
  BodyWrenches felt, wrenches;
  BodyMemory at_start;
  BodyMark marked;
  bool is_sound = true;  // otherwise all but the mesh and the motion are to be found anew from what was marked
};

/// Makes a change that either takes place as a whole, or leaves the body as it was and throws what stopped it. `change`
/// must not move on what the reports tell of, nor throw where it has done so. `is_marked`: what is there is what has
/// been marked last.
template <class Change>
auto DeformableBody::State::allOrNothing(const Change& change, bool is_marked) {
  sound();
  if (!is_marked) mark();
  try {
    return change();
  } catch (...) {
    undo();
    throw;
  }
}

}  // namespace incision

#pragma once

#include <chrono>
#include <deque>

#include "incision/body/deformable_body.h"
#include "incision/solver/backward_difference.h"
#include "incision/tool/blade/cutting_edge.h"
#include "incision/tool/blade/stroke.h"

namespace incision {

/// A command due within this [s] of a step's start takes effect before it.
inline constexpr double DUE_TOLERANCE = 1e-9;

using Clock = std::chrono::steady_clock;

inline double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Where the tool is, and where it goes in the next step.
struct ToolMotion {
  std::optional<Pose> pose;  // none: there is no tool in place
  std::vector<Pose> path;    // evenly in time; empty: it stays
  Pose from, to;             // of the step being taken
  bool active = true;        // the blade cuts
};

/// What acts in a step beside the body's own stiffness.
struct Acting {
  bool contact = false, cohesion = false, ties = false, edge = false;
};

/// What a body is made of. Commands change the mesh, steps the motion.
struct DeformableBody::State {
  State(const Scene& s, TetMesh rest, const Descriptions& descriptions);

  void start();
  void placeNewCopies();
  void topologyChanged(const std::vector<int>& touched = {});
  CrackField fieldOf(const PlaneCut& plane) const;
  CutResult cut(const PlaneCut& plane);
  void guideTool(const std::vector<Pose>& path);
  void followScript();
  void startTool();
  void sweepTool(StepResult* result);
  ToolReport toolReport() const;
  void sweepPath(Pose last);
  const std::vector<Vec3>& positionsWithin(double share);
  void cutAlong(const Edge& to, const std::vector<Vec3>& x);
  std::optional<CutResult> endStroke();
  void applyDue(StepResult* result);
  void fracture(StepResult* result);
  const Surface& currentSurface() const;
  bool advance(double time, double time_step);
  bool beginCouplings(double time_step);
  bool updateCouplings(double time_step, const std::vector<Vec3>& v_end, std::vector<Coupling>* couplings);
  void acceptCouplings(double time_step);
  bool advanceFreely(double time, double time_step);
  bool advanceInHalves(double time, double time_step);
  std::optional<Pose> scriptedPose(double at) const;
  std::vector<int> pieceOf(int* pieces) const;
  int pieces() const;
  double time() const { return static_cast<double>(steps) * scene.solver.time_step; }

  Scene scene;
  CutMesh mesh;
  ImplicitStep step;
  BackwardDifference past;  // for steps of second order
  Motion motion;
  std::int64_t steps = 0;
  std::deque<ScheduledCut> scheduled;  // by time; equal times in the order they came
  Edge edge;                           // of the blade, in its link's frame
  ToolMotion tool;
  std::optional<CrackGrowth> growth;  // where the scene lets the body break
  std::optional<Cohesion> cohesion;   // where opening a crack takes energy
  std::optional<Contact> contact;     // where the scene lets the body touch
  LinkMotion links;                   // of the obstacles, from the step's start to its end
  ContactReport touching;
  double contact_ms = 0;  // to find what may touch in the step
  Stroke stroke;
  CutResult stroke_result;
  double area_before = 0;  // cut before the stroke [m²]
  double last_area = 0;    // by the last stroke that ended [m²]
  // Where there is a tool:
  std::optional<Ties> ties;
  std::optional<CuttingEdge> cutting;
  Wrench on_tool;  // in the last step, in the frame of its link, with the levers of the start as all forces have
  Acting acting;
  std::vector<Vec3> x_within;  // positionsWithin a step, kept for its memory
  std::uint64_t topology_version = 0;
  std::uint64_t contact_version = 0;
  mutable Surface surface;
  mutable std::uint64_t surface_version = 0;
};

}  // namespace incision

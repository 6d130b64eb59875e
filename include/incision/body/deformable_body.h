#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "incision/base/short_list.h"
#include "incision/contact/contact_point.h"
#include "incision/contact/contact_report.h"
#include "incision/contact/obstacles.h"
#include "incision/cut/cut_result.h"
#include "incision/fem/materials.h"
#include "incision/fracture/growth.h"
#include "incision/rigid/wrench.h"
#include "incision/scene/live_settings.h"
#include "incision/scene/scene.h"
#include "incision/solver/linear_solver.h"
#include "incision/surface/surface.h"
#include "incision/tool/tool_form.h"
#include "incision/tool/tool_report.h"

namespace incision {

/// Sizes of the body; `dofs` = 3 × copies. Of the nodes, held are those that a clamp has and an element uses.
struct BodyCounts {
  int nodes = 0, held_nodes = 0, elements = 0, crack_elements = 0, parts = 0, copies = 0, dofs = 0, cracks = 0,
      pieces = 0;
};

/// Sums over the body at the current state.
struct BodyMotion {
  double mass = 0;                                ///< [kg]
  Vec3 momentum = Vec3::Zero();                   ///< [kg m/s]
  double kinetic_energy = 0, elastic_energy = 0;  ///< [J]
  double potential_energy = 0;                    ///< of its weight: zero at the origin of the frame [J]
  double max_displacement = 0;                    ///< largest |x − X| over the points of the material [m]
};

/// Wall time of one step's phases [ms].
struct PhaseTimes {
  double cut = 0, fracture = 0, contact = 0, assembly = 0, solve = 0, update = 0;

  PhaseTimes& operator+=(const PhaseTimes& other) {
    cut += other.cut;
    fracture += other.fracture;
    contact += other.contact;
    assembly += other.assembly;
    solve += other.solve;
    update += other.update;
    return *this;
  }
};

/// What has happened to the body's topology.
struct Reports {
  std::vector<CutResult> cuts;      ///< that took effect, and strokes that ended
  std::vector<CrackResult> cracks;  ///< what cracks did
};

struct StepResult {
  std::vector<CutResult> cuts;      ///< those that took effect before this step, and strokes that ended in it
  std::vector<CrackResult> cracks;  ///< what cracks did in this step
  ContactReport contact;
  ShortList<ToolReport, 4> tools;  ///< of each tool
  int iterations = 0;              ///< of the linear solve; 0 when direct
  double residual = 0;             ///< relative
  int solves = 0;                  ///< Newton steps for what touches, tears or cuts; 0 where nothing was to solve
  bool settled = true;             ///< one more would hardly have changed a force
  bool divided = false;            ///< it was taken as two halves, or shorter parts
  double step_ms = 0;              ///< wall time of the whole step
  PhaseTimes phase_ms;
};

/// What a body does to what holds it, in the axes of the body's frame.
struct BodyWrenches {
  std::vector<Wrench> clamps;  ///< of each entry of `boundary`, about its frame's origin when the step started; about
                               ///< the origin of the body's frame where it has none or nothing is known of it
  std::vector<Wrench> obstacles;     ///< of each link of the obstacles, about the link's origin when the step started
  Wrench ground;                     ///< about the origin of the body's frame
  std::vector<ContactPoint> points;  ///< what pressed on the body, in the last part of the step where it was divided
};

/// A step could not be taken, nor two of half its length. The state is the one before it.
class StepFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One soft body: owns the state and calls the stages. Not thread-safe.
///
/// Any function may throw std::bad_alloc. What it was to change is then as it was before the call, but for what a step
/// says, and the body goes on as if there had been no such call. Where memory stays so short that it cannot be put in
/// order again, all functions but those that tell of the mesh, of positions and of counted steps throw so until it can.
class DeformableBody {
 public:
  /// `make_solver` makes the linear solvers; left out, they are those that the scene asks for. Throws InputError when
  /// the scene, the mesh and the descriptions do not go together.
  DeformableBody(const Scene& scene, TetMesh mesh, const Descriptions& descriptions = {},
                 const MakeLinearSolver& make_solver = {});
  ~DeformableBody();

  /// Applies what is due, then takes one step of Δt. Throws StepFailed, or std::bad_alloc: the body is then as it was
  /// after what was due has been applied (with std::bad_alloc, after as much of it as there was memory for; the next
  /// step applies the rest), tools still have the paths before them that they were given, and the reports wait to be
  /// taken.
  StepResult step();

  /// What has happened and no step's result has told, because the step failed. Returns each report once.
  Reports takeReports();

  /// Cuts at once, in the current configuration. Never throws for what the plane says: it is REJECTED with the reason,
  /// as it is where memory runs out.
  CutResult cut(const PlaneCut& plane);

  /// How many tools there are. The functions below throw std::out_of_range for a tool that there is not.
  std::size_t tools() const;

  /// In the next step the tool goes evenly along these poses of its link in the body's frame to the last, where it
  /// stays, and cuts what its edge crosses. When it is not in place the first one only places it.
  void guideTool(const std::vector<Pose>& path, std::size_t tool = 0);

  /// Puts the tool there at once: it sweeps nothing on its way. Ends the stroke under way, and returns its result where
  /// it cut something, as do the next two functions.
  std::optional<CutResult> placeTool(const Pose& pose, std::size_t tool = 0);

  /// Takes the tool away until the next pose.
  std::optional<CutResult> liftTool(std::size_t tool = 0);

  /// Whether the blade cuts, as it does at first and after a reset. One that does not only touches.
  std::optional<CutResult> activateTool(bool active, std::size_t tool = 0);

  /// Where the tool's link is, if the tool is in place.
  const std::optional<Pose>& toolPose(std::size_t tool = 0) const;
  /// In the next step the tool's joint turns evenly to this angle [rad], where it stays.
  void guideJaw(double angle, std::size_t tool = 0);
  /// Angle of its joint [rad]; 0 where it has none.
  double toolJaw(std::size_t tool = 0) const;
  /// What it is made of. Without contact a tool that has no jaw tells no shapes.
  ToolForm toolForm(std::size_t tool = 0) const;
  /// Where each of its groups stands in the body's frame; none while the tool is not in place.
  std::vector<Pose> toolGroups(std::size_t tool = 0) const;

  /// The obstacles; none without contact. A link moves evenly to `pose` in the body's frame during the next step, and
  /// stays there; or it is put there, and sweeps nothing on its way. Throws std::out_of_range without such a link.
  const Obstacles& obstacles() const;
  void moveObstacle(int link, const Pose& pose);
  void placeObstacle(int link, const Pose& pose);

  /// Clamps, by their index in the scene's `boundary`. The frame of one moves evenly to `pose` in the body's frame
  /// during the next step, and stays there; or it is put there at once, and the nodes with it. The first pose since the
  /// construction or a reset only tells where the frame is: the nodes then go rigidly with it. Where the scene has
  /// poses of the clamp, steps follow these from the first of them on. Throws std::out_of_range for a clamp that there
  /// is not, or that has neither frame nor poses.
  void moveClamp(int clamp, const Pose& pose);
  void placeClamp(int clamp, const Pose& pose);

  /// Whether steps also find what the body does to clamps and obstacles; at first they do not.
  void wantWrenches(bool wanted);
  /// Of the step taken last: the mean over it, of just the impulses with which its equations balance. Zero where none
  /// has been taken since they were wanted, or since a reset.
  const BodyWrenches& wrenches() const;

  /// What holds from the next step on; at first as the scene says. A reset keeps it, and a saved body takes it along
  /// but for the threads. `set` throws InputError for what the scene could not say.
  const LiveSettings& live() const;
  void set(const LiveSettings& settings);

  /// Back to the state after construction: no cuts, and those of the scene are still to come. Returns the results of
  /// the strokes under way, which end so, where they cut something.
  std::vector<CutResult> reset();

  /// Writes all that outlasts a step, but no reports. The bytes are for bodies of the same scene and the same build.
  /// Throws std::runtime_error where the stream takes no more.
  void save(std::ostream& out) const;

  /// Goes on where the body stood that was saved, as if it had never been saved, down to the last digit. Reports that
  /// wait to be taken are lost. Throws InputError, with nothing changed, when the bytes end early or are those of a
  /// body of another mesh or with other parts.
  void restore(std::string_view bytes);

  const Scene& scene() const;
  const CutMesh& mesh() const;
  const Materials& materials() const;
  std::int64_t steps() const;
  /// Of these, those in which the forces of couplers did not settle.
  std::int64_t unsettledSteps() const;
  double time() const;  ///< steps × Δt [s]

  const std::vector<Vec3>& positions() const;   ///< x of every copy [m]
  const std::vector<Vec3>& velocities() const;  ///< v of every copy [m/s]
  std::vector<Vec3> nodePositions() const;      ///< of every node's own copy, in mesh order; X where no element uses it

  BodyCounts counts() const;
  const RestBox& bounds() const;  ///< of the uncut body at rest, [m]
  BodyMotion motion() const;
  std::vector<int> heldCopies() const;        ///< those that clamps hold
  std::vector<Vec3> loadForces() const;       ///< of the loads on every copy, now [N]
  std::vector<double> pieceVolumes() const;   ///< rest volumes [m³], ascending
  std::vector<double> regionVolumes() const;  ///< rest volume of each region [m³]
  std::vector<Mat3> partStress() const;       ///< Cauchy stress [Pa] of every part, in the body's frame

  /// The closed surface; rebuilt only after its topology changed.
  const Surface& surface() const;
  /// Grows whenever a cut changes the topology, and at a reset.
  std::uint64_t topologyVersion() const;

  /// Of step count, topology, positions and velocities; equal for equal commands whatever the thread count.
  std::uint64_t stateHash() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace incision

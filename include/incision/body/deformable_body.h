#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "incision/contact/contact.h"
#include "incision/fracture/cohesion.h"
#include "incision/fracture/growth.h"
#include "incision/scene/scene.h"
#include "incision/surface/surface.h"

namespace incision {

enum class CutStatus : std::uint8_t { APPLIED = 0, MISSED = 1, REJECTED = 2 };

/// What became of one cut.
struct CutResult {
  std::string label;
  CutStatus status = CutStatus::MISSED;
  std::string reason;  ///< why it was missed or rejected
  int cracks = 0;      ///< cracks it made: 0 or 1, more only by a stroke that crosses itself or turns a corner
  int parts_split = 0, copies_added = 0;
  int pieces = 0;       ///< of the body now
  double duration = 0;  ///< of the computation [s]
};

/// Sizes of the body; `dofs` = 3 × copies.
struct BodyCounts {
  int nodes = 0, elements = 0, crack_elements = 0, parts = 0, copies = 0, dofs = 0, cracks = 0, pieces = 0;
};

/// Sums over the body at the current state.
struct BodyMotion {
  double mass = 0;                                ///< [kg]
  Vec3 momentum = Vec3::Zero();                   ///< [kg m/s]
  double kinetic_energy = 0, elastic_energy = 0;  ///< [J]
  double max_displacement = 0;                    ///< largest |x − X| over the copies [m]
};

/// Wall time of one step's phases [ms].
struct PhaseTimes {
  double cut = 0, fracture = 0, contact = 0, assembly = 0, solve = 0, update = 0;
};

/// What tool and tissue did to each other in a step.
struct ToolReport {
  bool touching = false;       ///< they acted on each other, or the edge is in the tissue
  Vec3 force = Vec3::Zero();   ///< of the tissue on the tool, in the frame of the tool's link [N]
  Vec3 torque = Vec3::Zero();  ///< the same about the link's origin [N m]
  double depth = 0;            ///< how far the edge has come below the skin, at rest [m]; 0 outside
  double stroke_area = 0;      ///< that the stroke under way, or the last one, has cut, at rest [m²]
};

struct StepResult {
  std::vector<CutResult> cuts;      ///< those that took effect before this step, and strokes that ended in it
  std::vector<CrackResult> cracks;  ///< what cracks did in this step
  ContactReport contact;
  ToolReport tool;
  int iterations = 0;   ///< of the linear solve; 0 when direct
  double residual = 0;  ///< relative
  double step_ms = 0;   ///< wall time of the whole step
  PhaseTimes phase_ms;
};

/// A step could not be taken, nor two of half its length. The state is the one before it.
class StepFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One soft body: owns the state and calls the stages. Not thread-safe.
class DeformableBody {
 public:
  /// Throws InputError when the scene, the mesh and the descriptions do not go together.
  DeformableBody(const Scene& scene, TetMesh mesh, const Descriptions& descriptions = {});
  ~DeformableBody();

  /// Applies what is due, then takes one step of Δt. Throws StepFailed with the state restored.
  StepResult step();

  /// Cuts at once, in the current configuration. Never throws for what the plane says: it is REJECTED with the reason.
  CutResult cut(const PlaneCut& plane);

  /// Cuts before the step that starts at the first k Δt ≥ time.
  void schedule(const ScheduledCut& cut);

  /// In the next step the tool goes evenly along these poses of its link in the body's frame to the last, where it
  /// stays, and cuts what its edge crosses. Without a tool in place the first one only places it. Needs a scene with a
  /// tool, as the next three do.
  void guideTool(const std::vector<Pose>& path);

  /// Puts the tool there at once: it sweeps nothing on its way. Ends the stroke under way, and returns its result where
  /// it cut something, as the next two do.
  std::optional<CutResult> placeTool(const Pose& pose);

  /// Takes the tool away until the next pose.
  std::optional<CutResult> liftTool();

  /// Whether the blade cuts, as it does at first and after a reset. One that does not only touches.
  std::optional<CutResult> activateTool(bool active);

  /// Where the tool's link is, if there is a tool in place.
  const std::optional<Pose>& toolPose() const;

  /// The obstacles; none without contact. A link moves evenly to `pose` in the body's frame during the next step, and
  /// stays there; or it is put there, and sweeps nothing on its way.
  const Obstacles& obstacles() const;
  void moveObstacle(int link, const Pose& pose);
  void placeObstacle(int link, const Pose& pose);

  /// Back to the state after construction: no cuts but the scene's, which are scheduled again.
  void reset();

  const Scene& scene() const;
  const CutMesh& mesh() const;
  std::int64_t steps() const;
  double time() const;  ///< steps × Δt [s]

  const std::vector<Vec3>& positions() const;   ///< x of every copy [m]
  const std::vector<Vec3>& velocities() const;  ///< v of every copy [m/s]
  std::vector<Vec3> nodePositions() const;      ///< of every node's own copy, in mesh order; X where no element uses it

  BodyCounts counts() const;
  BodyMotion motion() const;
  std::vector<double> pieceVolumes() const;  ///< rest volumes [m³], ascending
  std::vector<Mat3> partStress() const;      ///< Cauchy stress [Pa] of every part, in the body's frame

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

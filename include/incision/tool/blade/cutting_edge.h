#pragma once

#include <optional>
#include <vector>

#include "incision/base/memory_limits.h"
#include "incision/fem/materials.h"
#include "incision/mesh/skin_depth.h"
#include "incision/tool/blade/cutting_resistance.h"
#include "incision/tool/blade/stroke.h"
#include "incision/tool/blade/ties.h"
#include "incision/tool/tool_in_step.h"

namespace incision {

/// What of a station of the edge outlasts a step.
struct StationMemory {
  Vec3 slip = Vec3::Zero();     ///< [m]
  Vec3 forward = Vec3::Zero();  ///< where it has cut last, unit; zero: nowhere yet
  bool entered = false;         ///< it is in a cut, or has reached what that takes; false where there is no onset
};

template <class Archive>
void serialize(Archive& archive, StationMemory& memory) {
  auto& [slip, forward, entered] = memory;
  archive(slip, forward, entered);
}

void check(const std::vector<StationMemory>& memory, const MemoryLimits& limits);

/// An edge of a tool.
struct EdgeOfTool {
  int group;                     ///< of the tool, with which it moves
  Edge edge;                     ///< in the group's frame
  std::array<double, 2> fronts;  ///< of the blade where it is pushed along the edge, at either end [m]
  CuttingResistance resistance;  ///< where regions have none of their own
  double friction;               ///< Coulomb's coefficient, along itself
};

/// Stations an element: what the force is off where the edge comes out of the tissue is half a station.
inline constexpr int STATIONS_PER_ELEMENT = 8;

/// What a blade's edge and the tissue that it has not cut yet do to each other. The edge meets the tissue at
/// its stations, points spread evenly over it. At each the tissue is carried along by a spring with the slip s, the way
/// of the edge through the material less what has been cut, until the force across the edge reaches F_c ΔL, with the
/// cutting force F_c and the station's share ΔL of the edge: then the blade advances against just this force, so that
/// cutting an area A takes the work F_c A. Along the edge it is Coulomb friction, by the force across. The tissue is
/// pushed, never pulled: going back, the edge is free until it comes to where it stood.
///
/// With a viscosity η it advances at a speed v against (F_c + η v) ΔL. With an onset F_o it begins to cut where the
/// stations of an element bear F_c + F_o a metre together, and enters all that hangs together before it at once; until
/// then nothing that it sweeps is cut. What it has entered takes F_c as long as the edge stays in its cut, whose gap
/// belongs to it where an element spans it.
///
/// Along itself the edge has a front at its ends alone, as long as the blade is thick there: at each of these two more
/// stations, its tips, the tissue is carried along likewise until the force along the edge reaches F_c times the front.
class CuttingEdge : public WithMemory<Coupler, std::vector<StationMemory>> {
 public:
  /// All but the edge must outlive this.
  CuttingEdge(const EdgeOfTool& edge, ToolInStep* tool, const Ties& ties, const Stroke& stroke, NearParts* near,
              const Materials& materials, const CutMesh& mesh);

  /// The edge is no longer in the tissue that it was in.
  void leave();

  /// As Tool::scaleCuttingForce. Where cutting takes no force, the edge holds nothing.
  void scaleCuttingForce(double factor);

  void changed(const CutMesh& /*mesh*/) override {}
  bool begin(const StepStart& start, std::vector<Spring>* springs) override;
  void takeBounds(Span<const Vec3> moved, Span<const double> share) override;
  void update(Span<const Vec3> moved, Span<Spring> springs) override;
  void accept(const StepSpan& span, Span<const Vec3> moved, const Motion& end, const Wrench& felt) override;
  bool hasOtherEnd() const override { return true; }
  std::any read(ArchiveReader* archive) const override;

  /// Whether the edge has not yet reached anywhere what it takes to begin to cut.
  bool waits() const;
  /// Whether something resisted it in the last step.
  bool presses() const { return presses_; }

  /// Whether a part of the edge was in the tissue when the last step started, and how far that came below the skin, at
  /// rest [m].
  bool inTissue() const { return in_tissue_; }
  double depth() const { return depth_; }

 private:
  /// A station in this step.
  struct Station {
    StationMemory start;
    Spring tissue;              // the material at the station; count 0: none resists
    Vec3 drift = Vec3::Zero();  // of the edge in the step [m]
    double front = 0;           // what of the blade cuts there [m]
    double most = 0;            // force that cuts [N],
    double onset = 0;           // what it takes beyond that where nothing is cut yet [N],
    double viscous = 0;         // and by what is cut in the step [N/m]
    double outward = 0;         // of a tip: along the edge, 1, or against it, −1; 0: it is none
    double stiffest = 0;        // the most stiffness it can have [N/m]
    double force = 0;           // against what cuts, at the step's end [N]
    double most_along = 0;      // bound on the friction along the edge [N]
    bool is_free = false;       // the edge goes back, and nothing resists that
    bool waits = false;         // it has not begun to cut
  };
  /// A station's state at a trial.
  struct Trial {
    Vec3 cuts, beside;                        // slip that cuts, and what is at right angles to it [m]
    double cuts_stiffness, beside_stiffness;  // force over slip [N/m]
    double steepness = 0;                     // of the force where it cuts, by the slip [N/m]
    bool yields, slides;                      // where it cuts, and beside
  };
  /// What is where a point is: the material that resists there, nothing in a slit, the sides of a tied section alike;
  /// and how far below the skin, at rest [m].
  struct Found {
    Spring tissue;
    int element;
    double depth = 0;
  };
  struct Near {
    int part;
    PartFrame frame;
  };
  /// Two directions in the body, along the edge and across, of the surface that it sweeps; across is zero while it
  /// stands still [m].
  using Swept = std::array<Vec3, 2>;

  void findNear(const Edge& edge, const StepStart& start);
  void beginStation(const Vec3& point, const StepStart& start, Station* station);
  Vec3 cutting(const Station& station, const Vec3& slip) const;
  std::optional<Found> findTissue(const Vec3& point, const Swept& swept, const CutMesh& mesh);
  bool isInElement(const Vec3& point) const;
  void takeResistance(int element, double time_step, Station* station) const;
  void enterTogether();
  void enterWhereReached();
  bool isInSlit(const Vec3& point, const Swept& swept, const Near& near, const CutMesh& mesh) const;
  Trial tryAt(const Station& station, const Vec3& moved) const;
  void takeBound(const Vec3& moved, double share, Station* station) const;

  std::vector<CuttingResistance> resistances_;  // in each region
  bool resists_ = false, has_onset_ = false;    // any of them does, or has one
  double force_factor_ = 1;                     // by which these are multiplied
  double friction_;
  int group_;
  Edge edge_;
  ToolInStep* tool_;
  const Ties& ties_;
  const Stroke& stroke_;
  NearParts* near_parts_;
  const Materials& materials_;
  double size_;  // of the elements, the mean [m]
  SkinDepth skin_;
  double share_;                  // of a station, ΔL [m]
  std::array<double, 2> fronts_;  // of the tips [m]
  // Of this step:
  std::vector<Station> stations_;  // the last two are the tips
  std::vector<Near> near_;         // the parts that the edge may be in
  Vec3 direction_ = Vec3::Zero();  // of the edge, unit
  bool in_tissue_ = false, presses_ = false;
  double depth_ = 0;
};

}  // namespace incision

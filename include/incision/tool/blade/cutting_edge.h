#pragma once

#include <optional>
#include <vector>

#include "incision/mesh/skin_depth.h"
#include "incision/tool/blade/ties.h"

namespace incision {

/// What a blade's edge and the tissue that it has not cut yet do to each other. The edge is held by its stations,
/// points spread evenly over it. At each the tissue is carried along by a spring with the slip s, the way of the edge
/// through the material less what has been cut, until the force across the edge reaches F_c ΔL, with the cutting force
/// F_c and the station's share ΔL of the edge: then the blade advances against just this force, so that cutting an area
/// A takes the work F_c A. Along the edge it is Coulomb friction, by the force across. The tissue is pushed, never
/// pulled: going back, the edge is free until it comes to where it stood.
class CuttingEdge {
 public:
  /// `young_modulus` [Pa].
  CuttingEdge(const ToolSettings& settings, double young_modulus, const CutMesh& mesh);

  /// A step starts with the copies at `x` [m], in which the edge goes evenly from `from` to `to`.
  void begin(const Edge& from, const Edge& to, const CutMesh& mesh, const std::vector<Vec3>& x, const Ties& ties);

  /// The edge is no longer there, until the next step that begins with it.
  void leave();

  /// As Couple says, but appends.
  bool update(double time_step, const std::vector<Vec3>& v_end, std::vector<Coupling>* couplings);

  /// Takes the step as done, with these velocities at its end.
  void accept(double time_step, const std::vector<Vec3>& v_end);

  /// Whether any tissue resists.
  bool held() const { return held_; }
  /// Whether a part of the edge is in the tissue, and how far that comes below the skin, at rest [m].
  bool inTissue() const { return in_tissue_; }
  double depth() const { return depth_; }

 private:
  struct Station {
    Vec3 slip = Vec3::Zero();      // at the step's start [m]
    Vec3 forward = Vec3::Zero();   // where it has cut last, unit; zero: nowhere yet
    Coupling held;                 // the material at the station; count 0: none resists
    Vec3 drift = Vec3::Zero();     // of the edge in the step [m]
    double across = 0, along = 0;  // stiffness that the last couplings have [N/m]
  };
  /// A station's state at a trial.
  struct Trial {
    Vec3 slip;             // [m]
    double across, along;  // stiffness [N/m]; 0: it is free
    bool yields;
  };
  Trial tryAt(const Station& station, double time_step, const std::vector<Vec3>& v_end) const;
  /// What is where a point is: the material that resists there, nothing in a slit, the sides of a tied section alike;
  /// and how far below the skin, at rest [m].
  struct Found {
    Coupling held;
    double depth = 0;
  };
  struct Near {
    int part;
    PartFrame frame;
  };
  std::optional<Found> findTissue(const Vec3& point, const std::vector<Near>& near, const CutMesh& mesh,
                                  const Ties& ties);

  double cutting_force_, friction_;  // [N/m], –
  double young_modulus_;             // [Pa]
  double size_;                      // of the elements, the mean [m]
  SkinDepth skin_;
  std::vector<Station> stations_;
  Vec3 direction_ = Vec3::Zero();  // of the edge, unit
  double share_ = 0;               // of a station, ΔL [m]
  bool held_ = false, in_tissue_ = false;
  double depth_ = 0;
};

}  // namespace incision

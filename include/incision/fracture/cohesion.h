#pragma once

#include <vector>

#include "incision/cut/section.h"
#include "incision/fracture/settings.h"
#include "incision/solver/coupling.h"

namespace incision {

/// What still holds together the two faces of a crack that opens. The traction follows the opening y, against it and
/// by its size δ = |y| alone: it rises steeply to the tensile strength σ_t, falls linearly to nothing at δ_c = 2G/σ_t,
/// and on closing goes back straight to zero. So opening a square metre takes the fracture energy G, on any mesh. Faces
/// that would cross are pushed apart as steeply as they were held, as long as they hold at all.
class Cohesion {
 public:
  /// Needs a fracture energy. `young_modulus` [Pa].
  Cohesion(const FractureSettings& settings, double young_modulus);

  /// A crack has just split these parts, and the copies stand at `x` [m].
  void add(const Insertion& done, const CutMesh& mesh, const std::vector<Vec3>& x);

  /// After every change of the mesh: finds the parts at which the faces hold now.
  void topologyChanged(const CutMesh& mesh);

  /// A step starts with the copies at `x` [m].
  void begin(const CutMesh& mesh, const std::vector<Vec3>& x);

  /// As Couple says, but appends.
  bool update(double time_step, const std::vector<Vec3>& v_end, std::vector<Coupling>* couplings);

  /// The step has been taken and left the copies at `x` [m].
  void accept(const std::vector<Vec3>& x);

  bool empty() const { return held_.empty(); }

  /// Energy that opening cracks has taken for good [J].
  double dissipated() const;

 private:
  /// The section of one part, held at its centroid.
  struct Held {
    Section section;
    double area;        // [m²]
    double steepest;    // κ [Pa/m], the slope up to σ_t
    double opened = 0;  // the largest δ in a step that was taken [m]
    std::array<int, 8> copies{};
    std::array<double, 8> weights{};
    bool parted = false;         // whether the sides have any copies of their own yet
    Vec3 start = Vec3::Zero();   // y at the step's start [m]
    Vec3 normal = Vec3::Zero();  // unit, there
    double used = 0;             // the slope that the last couplings have [Pa/m]
  };

  double slope(const Held& held, double opening) const;
  Vec3 openingAt(const Held& held, const std::vector<Vec3>& values) const;
  double energyOf(const Held& held) const;

  double strength_, energy_, young_modulus_;
  std::vector<Held> held_;  // that still hold, in the order in which they opened
  double spent_ = 0;        // in those that hold no more [J]
};

}  // namespace incision

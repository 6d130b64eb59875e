#pragma once

#include <vector>

#include "incision/base/memory_limits.h"
#include "incision/cut/section.h"
#include "incision/fem/materials.h"
#include "incision/fracture/settings.h"
#include "incision/solver/coupler.h"

namespace incision {

/// The section of one part that a crack has opened, bonded at its centroid.
struct Bond {
  Section section;
  int region;         ///< of the part
  double area;        ///< [m²]
  double steepest;    ///< κ [Pa/m], the slope up to σ_t
  double opened = 0;  ///< the largest δ in a step that was taken [m]
};

template <class Archive>
void serialize(Archive& archive, Bond& bond) {
  auto& [section, region, area, steepest, opened] = bond;
  archive(section, region, area, steepest, opened);
}

/// What of the cohesion outlasts a step.
struct CohesionMemory {
  std::vector<Bond> bonds;  ///< in the order in which they opened
  double spent = 0;         ///< in those that are gone [J]
};

template <class Archive>
void serialize(Archive& archive, CohesionMemory& memory) {
  auto& [bonds, spent] = memory;
  archive(bonds, spent);
}

void check(const CohesionMemory& memory, const MemoryLimits& limits);

/// What still bonds the two faces of a crack that opens. The traction follows the opening y, against it and
/// by its size δ = |y| alone: it rises steeply to the tensile strength σ_t, falls linearly to nothing at δ_c = 2G/σ_t,
/// and on closing goes back straight to zero. So opening a square metre takes the fracture energy G, on any mesh. Faces
/// that would cross are pushed apart as steeply as they were bonded, as long as they are bonded at all.
class Cohesion : public WithMemory<Coupler, CohesionMemory> {
 public:
  /// Needs a fracture energy, of the body or of a region. `materials` must outlive this.
  Cohesion(const FractureSettings& settings, const Materials& materials);

  /// A crack has just split these parts, and the copies stand at `x` [m].
  void add(const Insertion& done, const CutMesh& mesh, const std::vector<Vec3>& x);

  void changed(const CutMesh& mesh) override;
  bool begin(const StepStart& start, std::vector<Spring>* springs) override;
  void takeBounds(Span<const Vec3> moved, Span<const double> share) override;
  void update(Span<const Vec3> moved, Span<Spring> springs) override;
  void accept(const StepSpan& span, Span<const Vec3> moved, const Motion& end, const Wrench& felt) override;
  /// Tractions change little from solve to solve: by about a tenth of what they changed by before.
  double looseness() const override { return 0.1; }

  /// Energy that opening cracks has taken for good [J].
  double dissipated() const;

 private:
  /// A bond in this step.
  struct Stretch {
    Spring bonded;        // y = plus − minus; its stiffness and force are for update()
    bool parted = false;  // whether the two sides have any copies of their own yet
    Vec3 start;           // y at the step's start [m]
    Vec3 normal;          // unit, there
    double slope;         // of the line on which the section opens again as far as it has been [Pa/m]
    double limit;         // of the traction in this step [Pa]
  };

  /// How a region's tissue tears: σ_t [Pa], G [J/m²] and δ_c [m].
  struct Law {
    double strength = 0, energy = 0, last_opening = 0;
  };

  const Law& lawOf(const Bond& bond) const { return laws_[bond.region]; }
  double traction(const Bond& bond, double opening) const;
  double energyOf(const Bond& bond) const;

  const Materials& materials_;
  std::vector<Law> laws_;           // of each region; without energy, nothing bonds
  std::vector<Stretch> stretches_;  // of each bond
};

}  // namespace incision

#pragma once

#include <vector>

#include "incision/body/deformable_body.h"
#include "incision/fem/assembly.h"

namespace incision {

/// What a region bears.
struct RegionStress {
  double mean = 0;     ///< von Mises' stress, the mean by volume [Pa]
  double largest = 0;  ///< of any part [Pa]
};

/// A copy of a body's mesh as it is cut now, from which another thread finds the stress of its parts.
class StressView {
 public:
  explicit StressView(const DeformableBody& body);
  StressView(const StressView&) = delete;  // the assembly refers to the mesh
  StressView& operator=(const StressView&) = delete;

  const CutMesh& mesh() const { return mesh_; }
  const Materials& materials() const { return materials_; }

  /// Von Mises' stress [Pa] of every part, the copies being at `x` [m].
  std::vector<double> vonMises(const std::vector<Vec3>& x);

  /// Of each region, from the stress of the parts.
  std::vector<RegionStress> ofRegions(const std::vector<double>& of_parts) const;

 private:
  CutMesh mesh_;
  Materials materials_;
  Assembly assembly_;
};

}  // namespace incision

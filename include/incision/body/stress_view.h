#pragma once

#include <memory>
#include <vector>

#include "incision/fem/assembly.h"
#include "incision/fem/body_settings.h"

namespace incision {

/// What a region bears.
struct RegionStress {
  double mean = 0;     ///< von Mises' stress, the mean by volume [Pa]
  double largest = 0;  ///< of any part [Pa]
};

/// Finds the stress of a body's parts from a copy of its mesh, on any thread.
class StressView {
 public:
  /// `materials`, which must outlive this, and `settings` are the body's; `x` is where the copies are [m].
  StressView(std::shared_ptr<const CutMesh> mesh, const Materials& materials, const BodySettings& settings,
             const std::vector<Vec3>& x);

  const CutMesh& mesh() const { return *mesh_; }

  /// Von Mises' stress [Pa] of every part, the copies being at `x` [m].
  std::vector<double> vonMises(const std::vector<Vec3>& x);

  /// Of each region, from the stress of the parts.
  std::vector<RegionStress> ofRegions(const std::vector<double>& of_parts) const;

 private:
  std::shared_ptr<const CutMesh> mesh_;
  Assembly assembly_;
};

}  // namespace incision

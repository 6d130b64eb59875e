#pragma once

#include <vector>

#include "incision/base/lists.h"
#include "incision/fem/assembly.h"

namespace incision {

/// Stress of the parts, smoothed: the mean by volume of a part's and of those of its region that hang together with it
/// across a face.
/// Nothing is averaged across a crack, nor across the face at which one ends: it relieves what lies behind, and ahead
/// is where the stress must be seen.
class SmoothedStress {
 public:
  /// Before the first use and after every change of the mesh: finds what hangs together.
  void topologyChanged(const Assembly& assembly);

  /// Takes the stress at the copies' positions `x` [m].
  void update(const Assembly& assembly, const std::vector<Vec3>& x);

  /// Cauchy stress [Pa] of every part in the body's frame.
  const std::vector<Mat3>& smoothed() const { return smoothed_; }

 private:
  Lists<int> neighbours_;  // of each part
  std::vector<Mat3> raw_, smoothed_;
};

}  // namespace incision

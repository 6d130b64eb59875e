#pragma once

#include <vector>

#include "incision/base/lists.h"
#include "incision/fem/assembly.h"
#include "incision/fracture/rankine.h"

namespace incision {

/// Stress of the parts, smoothed: the mean by volume of a part's and of those of its region that hang together with it
/// across a face.
/// Nothing is averaged across a crack, nor across the face at which one ends: it relieves what lies behind, and ahead
/// is where the stress must be seen.
class SmoothedStress {
 public:
  /// Before the first use and after every change of the mesh: finds what hangs together.
  void topologyChanged(const Assembly& assembly);

  /// Marks the parts whose stress at the copies' positions `x` [m] may be beyond their strength, of which there is one
  /// for each region: all that are, and few others. Returns whether there are any.
  bool findSuspects(const Assembly& assembly, const std::vector<Vec3>& x, const std::vector<Strength>& strengths,
                    std::vector<char>* suspects);

  /// Takes the stress at the copies' positions `x` [m].
  void update(const Assembly& assembly, const std::vector<Vec3>& x);
  /// Takes the stress of the parts that are `wanted` alone, at the copies' positions `x` [m].
  void update(const Assembly& assembly, const std::vector<Vec3>& x, const std::vector<char>& wanted);

  /// Cauchy stress [Pa] of every part in the body's frame.
  const std::vector<Mat3>& smoothed() const { return smoothed_; }

 private:
  template <typename Value>
  Value mean(const Assembly& assembly, const std::vector<Value>& values, int part) const;

  Lists<int> neighbours_;  // of each part
  std::vector<Mat3> raw_, smoothed_;
  std::vector<PrincipalBounds> bounds_;  // of raw_
  std::vector<char> marks_;              // of each part, while marks are handed on to its neighbours
};

}  // namespace incision

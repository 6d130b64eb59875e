#pragma once

#include <cstdint>
#include <vector>

#include "incision/base/lists.h"
#include "incision/base/vec.h"
#include "incision/cut/cut_part.h"

namespace incision {

/// Sums over copies of what the corners of parts bring. Parts lie in the order in which they are near each other, so
/// they are summed in runs first, whose copies are few enough for the processor's nearest memory; then a copy has few
/// runs. The order of the sums is the same with any count of threads.
class RunSums {
 public:
  /// Parts in a run.
  static constexpr int RUN = 256;

  /// Takes over parts, whose copies are numbered from 0 to `copies` − 1.
  void topologyChanged(const std::vector<Part>& parts, int copies);

  int runs() const { return copies_.count(); }
  /// Sets the sums of a run to zero. Runs may be filled at the same time.
  void clear(int run) {
    for (int k = copies_.start(run); k < copies_.start(run + 1); ++k) sums_[k].setZero();
  }
  /// The sum of a corner's copy in the run of its part.
  Vec3& at(int part, int node) {
    return sums_[copies_.start(part / RUN) + slots_[4 * static_cast<std::size_t>(part) + node]];
  }
  /// Adds up the runs of every copy.
  void gather(std::vector<Vec3>* result, int threads) const;

 private:
  static_assert(4 * RUN <= 65536, "a slot counts the copies of a run");

  Lists<int> copies_;                 // of each run
  std::vector<std::uint16_t> slots_;  // which of its run's copies each corner has; four of each part
  Lists<int> places_;                 // in sums_, of each copy, by ascending run
  std::vector<Vec3> sums_;            // of every copy of every run
};

}  // namespace incision

#include "incision/fem/run_sums.h"

#include <algorithm>

#include "incision/base/parallel.h"

namespace incision {

void RunSums::topologyChanged(const std::vector<Part>& parts, int copies) {
  const std::size_t count = parts.size();
  const int runs = (static_cast<int>(count) + RUN - 1) / RUN;
  if (slots_.capacity() < 4 * count) slots_.reserve(4 * (count + count / 4));  // room for the next cuts
  slots_.resize(4 * count);
  copies_.clear();
  std::vector<int> last_run(static_cast<std::size_t>(copies), -1);
  std::vector<std::uint16_t> slot(static_cast<std::size_t>(copies));
  for (int run = 0; run < runs; ++run) {
    const std::size_t end = std::min(count, static_cast<std::size_t>(RUN) * (run + 1));
    for (std::size_t p = static_cast<std::size_t>(RUN) * run; p < end; ++p)
      for (int I = 0; I < 4; ++I) {
        const int c = parts[p].copies[I];
        if (last_run[c] != run) {
          last_run[c] = run;
          slot[c] = static_cast<std::uint16_t>(copies_.unfinished().size());
          copies_.append(c);
        }
        slots_[4 * p + I] = slot[c];
      }
    copies_.finish();
  }
  places_ = sortedByList(copies_.values(), copies);
  sums_.resize(copies_.values().size());
}

void RunSums::gather(std::vector<Vec3>* result, int threads) const {
  result->resize(static_cast<std::size_t>(places_.count()));
  parallelFor(places_.count(), threads, [&](int c) {
    Vec3 sum = Vec3::Zero();
    for (int place : places_[c]) sum += sums_[place];
    (*result)[c] = sum;
  });
}

}  // namespace incision

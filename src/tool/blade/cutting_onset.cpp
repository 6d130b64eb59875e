// Where an edge begins to cut.
#include <algorithm>

#include "incision/tool/blade/cutting_edge.h"

namespace incision {

bool CuttingEdge::waits() const {
  return has_onset_ && force_factor_ > 0 &&
         std::none_of(memory_.begin(), memory_.end(), [](const StationMemory& station) { return station.entered; });
}

/// What hangs together before the edge, from one tip to the other, has been entered where any of it has.
void CuttingEdge::enterTogether() {
  if (!has_onset_) return;
  const std::size_t evenly = stations_.size() - 2;
  const auto along = [&](std::size_t k) -> Station& {
    return stations_[k == 0 ? evenly : k > evenly ? evenly + 1 : k - 1];
  };
  for (std::size_t first = 0, end = 0; first < stations_.size(); first = end + 1) {
    bool entered = false;
    for (end = first; end < stations_.size() && along(end).tissue.count > 0; ++end)
      entered = entered || along(end).start.entered;
    for (std::size_t k = first; k < end; ++k) {
      along(k).start.entered = entered;
      along(k).waits = !entered;
    }
  }
}

/// Enters where a tip, or the stations of an element together, have borne what it takes. How an element's force is
/// shared among its stations says nothing, as it has fewer nodes than these; so what is narrower than an element takes
/// as much as an element of it.
void CuttingEdge::enterWhereReached() {
  const std::size_t evenly = stations_.size() - 2, width = std::min(evenly, std::size_t{STATIONS_PER_ELEMENT});
  double takes = 0;  // any of these, the most [N]
  for (std::size_t i = 0; i < evenly; ++i)
    if (stations_[i].waits) takes = std::max(takes, stations_[i].most + stations_[i].onset);
  for (std::size_t first = 0; first + width <= evenly; ++first) {
    double missing = 0;
    for (std::size_t i = first; i < first + width; ++i) {
      const Station& station = stations_[i];
      missing += station.waits ? station.most + station.onset - station.force : takes;
    }
    if (missing > 0) continue;
    for (std::size_t i = first; i < first + width; ++i) memory_[i].entered = memory_[i].entered || stations_[i].waits;
  }
  for (const std::size_t tip : {evenly, evenly + 1}) {
    const Station& station = stations_[tip];
    if (station.waits) memory_[tip].entered = station.force >= station.most + station.onset;
  }
}

}  // namespace incision

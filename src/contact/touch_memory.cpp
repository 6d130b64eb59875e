// What memories of contact must be.
#include "incision/contact/candidate.h"

namespace incision {

/// Samples and what they touch are found again by their vertices.
void check(const std::vector<Touch>& touches, const MemoryLimits& limits) {
  // More than a vertex of the surface has samples and edges, as each is of a copy's part or of a facet.
  const int most = 4 * limits.parts() + limits.copies + 4096;
  for (const Touch& touch : touches) {
    require(touch.partner >= Candidate::EDGES, "what is touched is nothing");
    require(isOneOf(touch.sample_of_vertex, most) && isOneOf(touch.edge_of_other, most), "what touches is nowhere");
    require(touch.stiffness >= 0 && touch.tangential >= 0, "a contact's stiffness is below 0");
  }
}

}  // namespace incision

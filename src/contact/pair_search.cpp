#include "incision/contact/pair_search.h"

#include <algorithm>

namespace incision {

void PairSearch::begin(const Piece& a, const Piece& b, double margin) {
  from_a_ = a.frames[0];
  from_b_ = b.frames[0];
  worn_ = a.worn + b.worn;
  off_ = a.off[0] + b.off[0];
  margin_ = margin + needed(a, b);
}

double PairSearch::needed(const Piece& a, const Piece& b) const {
  double most = 0;
  for (int end = 0; end < 2; ++end) {
    const double rigid = &a == &b ? 0 : movedApart(a, b, from_a_, from_b_, end);
    most = std::max(most, rigid + a.off[end] + b.off[end]);
  }
  return most + usedUp(a, b);
}

}  // namespace incision

#include "incision/contact/legacy.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace incision {
namespace {

/// The two pieces of a candidate or touch of the body, the lower first.
template <typename T>
std::pair<int, int> piecesOf(const ContactSurface& surface, const T& contact) {
  const bool edges = contact.partner == Candidate::EDGES;
  const int one = edges ? surface.edges[contact.sample].from : surface.samples[contact.sample].vertex;
  const int other = edges ? surface.edges[contact.other].from : contact.other;
  return std::minmax(surface.vertex_piece[one], surface.vertex_piece[other]);
}

}  // namespace

void Legacy::begin(const std::vector<Touch>& touches) {
  touches_ = &touches;
  ended_.assign(touches.size(), true);
}

void Legacy::share(const ContactSurface& surface, std::vector<Candidate>* candidates) {
  left_.clear();
  for (const Touch& touch : *touches_) {
    if (touch.partner >= 0 || touch.gap >= 0 || !ended_[&touch - touches_->data()]) continue;
    const auto [one, other] = piecesOf(surface, touch);
    left_.push_back({one, other, 0.5 * touch.stiffness * touch.gap * touch.gap});
  }
  if (left_.empty()) return;
  const auto by_pieces = [](const Left& a, const Left& b) {
    return std::tie(a.one, a.other) < std::tie(b.one, b.other);
  };
  std::stable_sort(left_.begin(), left_.end(), by_pieces);
  for (Candidate& candidate : *candidates) {
    if (!candidate.isOfBody() || !(candidate.ignored > 0)) continue;
    const auto [one, other] = piecesOf(surface, candidate);
    const auto range = std::equal_range(left_.begin(), left_.end(), Left{one, other, 0}, by_pieces);
    for (auto left = range.first; left != range.second && candidate.ignored > 0; ++left) {
      const double depth = -candidate.gap, pressed = depth - candidate.ignored, half = 0.5 * candidate.stiffness;
      const double now = std::min(depth, std::sqrt(pressed * pressed + left->energy / half));
      left->energy = std::max(0.0, left->energy - half * (now * now - pressed * pressed));
      candidate.ignored = depth - now;
    }
  }
}

}  // namespace incision

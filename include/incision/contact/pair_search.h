#pragma once

#include <utility>

#include "incision/contact/piece_frames.h"

namespace incision {

/// From where two pieces, or one and itself, were searched for what is near, and how long that holds.
class PairSearch {
 public:
  using Piece = PieceFrames::Piece;

  /// Searches from where they are now, so that it holds for this step, and as long after it as points of the two have
  /// moved relative to each other by less than `margin` [m].
  void begin(const Piece& a, const Piece& b, double margin);

  /// How far points of the two can have moved relative to each other since then, by the end of the step [m].
  double needed(const Piece& a, const Piece& b) const;

  /// What of that stays however they move back [m].
  double usedUp(const Piece& a, const Piece& b) const { return off_ + a.worn + b.worn - worn_; }

  bool holds(const Piece& a, const Piece& b) const { return needed(a, b) < margin_; }

  /// By how much it looked further than to its reach [m].
  double margin() const { return margin_; }
  void lose(double margin) { margin_ -= margin; }

  /// The pieces are named the other way round.
  void swapPieces() { std::swap(from_a_, from_b_); }

 private:
  PieceFrames::Frame from_a_, from_b_;  // where they were
  double worn_ = 0;                     // of both then [m]
  double off_ = 0;                      // of both from their shapes then [m]
  double margin_ = 0;                   // [m]
};

}  // namespace incision

#pragma once

#include <cmath>

namespace incision {

/// Looks for the share of a way at which a convex function no longer falls along it, by Newton's method within an
/// interval that closes in on it. The whole way has gone too far to begin with.
class LineSearch {
 public:
  /// Trials at most.
  static constexpr int MOST = 20;

  double share() const { return share_; }

  /// Goes on from the share, where the function still falls by `slope` (it rises where that is negative), and the slope
  /// by `bend` along the way.
  void goOn(double slope, double bend) {
    (slope > 0 ? near_ : far_) = share_;
    const double newton = share_ + slope / bend;
    share_ = newton > near_ && newton < far_ ? newton : (near_ + far_) / 2;
  }

  /// Whether so little is left of the slope that there was at the start.
  static bool isNear(double slope, double at_start) { return !(std::abs(slope) > TOLERANCE * at_start); }

 private:
  static constexpr double TOLERANCE = 0.05;
  double share_ = 1, near_ = 0, far_ = 1;
};

}  // namespace incision

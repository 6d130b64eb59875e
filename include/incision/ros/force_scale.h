#pragma once

namespace incision {

/// How long the arrows of forces are drawn, in steps of 1, 2 and 5 times a power of ten m/N: the largest force of late
/// has an arrow of a third of the body's size at most, and of a thirtieth at least. So it is to be seen whatever the
/// body's size and the tissue, and the scale changes seldom.
class ForceScale {
 public:
  /// `size`: of the body [m]; `least`: a force [N] below which nothing is to be seen. Both above 0.
  ForceScale(double size, double least);

  /// The scale [m/N] at some simulated time [s], which may have gone back, of `force`, the largest [N] now.
  double at(double time, double force);

 private:
  const double size_, least_;
  double peak_;  ///< the largest force [N] of late: it fades
  double time_ = 0, scale_ = 0;
};

}  // namespace incision

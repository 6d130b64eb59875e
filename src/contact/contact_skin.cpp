#include "incision/contact/contact_skin.h"

#include <algorithm>
#include <cmath>

#include "incision/contact/candidate.h"

namespace incision {

void ContactSkin::begin(const StepStart& start) {
  if (placed_for_ == start.serial) return;
  placed_for_ = start.serial;
  if (version_ != current_.version())
    surface_ = makeContactSurface(current_.get(), start.mesh, materials_, start.piece);
  version_ = current_.version();
  interpolate(*surface_.surface, start.motion.x, threads_, &x_);
  interpolate(*surface_.surface, start.ahead, threads_, &ahead_);
  box_.setEmpty();
  double farthest = 0, largest = 0;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    box_.extend(x_[i]);
    farthest = std::max(farthest, ahead_[i].squaredNorm());
    largest = std::max(largest, surface_.size[i]);
  }
  room_ = std::sqrt(farthest) + MARGIN * largest;
}

}  // namespace incision

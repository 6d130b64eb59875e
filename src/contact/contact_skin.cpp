#include "incision/contact/contact_skin.h"

#include <algorithm>

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
  largest_room_ = 0;
  room_.resize(x_.size());
  for (std::size_t i = 0; i < x_.size(); ++i) {
    box_.extend(x_[i]);
    room_[i] = MARGIN * surface_.size[i] + ahead_[i].norm();
    largest_room_ = std::max(largest_room_, room_[i]);
  }
}

}  // namespace incision

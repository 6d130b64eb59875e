#include "incision/contact/contact_skin.h"

namespace incision {

void ContactSkin::begin(const StepStart& start) {
  if (version_ != current_.version())
    surface_ = makeContactSurface(current_.get(), start.mesh, materials_, start.piece);
  version_ = current_.version();
  interpolate(*surface_.surface, start.motion.x, threads_, &x_);
  interpolate(*surface_.surface, start.ahead, threads_, &ahead_);
}

}  // namespace incision

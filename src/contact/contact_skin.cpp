#include "incision/contact/contact_skin.h"

namespace incision {

void ContactSkin::begin(const StepStart& start) {
  if (version_ != current_.version()) {
    surface_ = makeContactSurface(current_.get(), start.mesh, start.piece);
    surface_.young_modulus = materials_.youngModulus(0);
  }
  version_ = current_.version();
  interpolate(*surface_.surface, start.motion.x, threads_, &x_);
  interpolate(*surface_.surface, start.motion.v, threads_, &v_);
}

}  // namespace incision

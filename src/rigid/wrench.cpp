#include "incision/rigid/wrench.h"

namespace incision {

Wrench between(const Wrench& a, const Wrench& b, double s) {
  return {(1 - s) * a.force + s * b.force, (1 - s) * a.torque + s * b.torque};
}

}  // namespace incision

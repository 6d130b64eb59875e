#include "incision/contact/pose.h"

namespace incision {

Pose composed(const Pose& outer, const Pose& inner) {
  return {outer.position + outer.orientation * inner.position, (outer.orientation * inner.orientation).normalized()};
}

Pose between(const Pose& a, const Pose& b, double s) {
  return {(1 - s) * a.position + s * b.position, a.orientation.slerp(s, b.orientation)};
}

}  // namespace incision

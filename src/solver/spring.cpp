#include "incision/solver/spring.h"

#include <Eigen/Geometry>

namespace incision {

Wrench wrenchOf(const Vec3& force, const Vec3& y) { return {-force, -y.cross(force)}; }

}  // namespace incision

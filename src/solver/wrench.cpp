#include "incision/solver/wrench.h"

#include <Eigen/Geometry>

namespace incision {

Wrench between(const Wrench& a, const Wrench& b, double s) {
  return {(1 - s) * a.force + s * b.force, (1 - s) * a.torque + s * b.torque};
}

Wrench toolWrench(const std::vector<Coupling>& couplings, double time_step, const std::vector<Vec3>& x,
                  const std::vector<Vec3>& v_end) {
  Wrench sum;
  for (const Coupling& coupling : couplings) {
    if (!coupling.tool) continue;
    Vec3 y = Vec3::Zero();
    for (int i = 0; i < coupling.count; ++i) y += coupling.weights[i] * x[coupling.copies[i]];
    const Vec3 force = -impulseOf(coupling, time_step, v_end) / time_step;
    sum.force += force;
    sum.torque += y.cross(force);
  }
  return sum;
}

}  // namespace incision

#include "incision/solver/coupling.h"

#include <Eigen/Geometry>

namespace incision {

Vec3 impulseOf(const Coupling& coupling, double time_step, const std::vector<Vec3>& v_end) {
  Vec3 rate = Vec3::Zero();  // ẏ
  for (int i = 0; i < coupling.count; ++i) rate += coupling.weights[i] * v_end[coupling.copies[i]];
  return time_step * (coupling.force - time_step * (coupling.stiffness * rate));
}

void addImpulses(const std::vector<Coupling>& couplings, double time_step, const std::vector<Vec3>& v_end,
                 std::vector<Vec3>* impulses) {
  for (const Coupling& coupling : couplings) {
    const Vec3 impulse = impulseOf(coupling, time_step, v_end);
    for (int i = 0; i < coupling.count; ++i) (*impulses)[coupling.copies[i]] += coupling.weights[i] * impulse;
  }
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

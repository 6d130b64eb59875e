#include "incision/solver/coupling.h"

#include <Eigen/Geometry>

namespace incision {

Vec3 impulseOf(const Coupling& coupling, double time_step, const std::vector<Vec3>& v_end) {
  return time_step * (coupling.force - time_step * (coupling.stiffness * weightedSum(coupling, v_end)));
}

void addImpulses(const std::vector<Coupling>& couplings, double time_step, const std::vector<Vec3>& v_end,
                 std::vector<Vec3>* impulses) {
  for (const Coupling& coupling : couplings) {
    const Vec3 impulse = impulseOf(coupling, time_step, v_end);
    for (int i = 0; i < coupling.count; ++i) (*impulses)[coupling.copies[i]] += coupling.weights[i] * impulse;
  }
}

Wrench wrenchOf(const Coupling& coupling, double time_step, const std::vector<Vec3>& x,
                const std::vector<Vec3>& v_end) {
  const Vec3 force = -impulseOf(coupling, time_step, v_end) / time_step;
  return {force, weightedSum(coupling, x).cross(force)};
}

}  // namespace incision

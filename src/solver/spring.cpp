#include "incision/solver/spring.h"

#include <Eigen/Geometry>

namespace incision {

Vec3 impulseOf(const Spring& spring, double time_step, const std::vector<Vec3>& v_end) {
  return time_step * (spring.force - time_step * (spring.stiffness * weightedSum(spring, v_end)));
}

void addImpulses(const std::vector<Spring>& springs, double time_step, const std::vector<Vec3>& v_end,
                 std::vector<Vec3>* impulses) {
  for (const Spring& spring : springs) {
    const Vec3 impulse = impulseOf(spring, time_step, v_end);
    for (int i = 0; i < spring.count; ++i) (*impulses)[spring.copies[i]] += spring.weights[i] * impulse;
  }
}

Wrench wrenchOf(const Spring& spring, double time_step, const std::vector<Vec3>& x, const std::vector<Vec3>& v_end) {
  const Vec3 force = -impulseOf(spring, time_step, v_end) / time_step;
  return {force, weightedSum(spring, x).cross(force)};
}

}  // namespace incision

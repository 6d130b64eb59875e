#pragma once

#include <memory>
#include <vector>

#include "incision/body/scene.h"

namespace incision::bench {

/// A body without cuts, loads and damping as Bullet's deformable world steps it: linear elasticity, warped, implicit.
///
/// Its step is ours but for the rotations: Bullet takes them at x + Δt (v + Δt g), where free fall would lead, ours at
/// x, and it stops extracting them at 0.01. So positions agree to some thousandths of the bar's length only. Its
/// conjugate gradients start from zero with the masses as preconditioner and stop at √ε of float, 3e-4 of the first
/// residual.
class BulletBody {
 public:
  BulletBody(const Scene& scene, const TetMesh& mesh);
  ~BulletBody();

  void step();
  std::vector<Vec3> nodePositions() const;

 private:
  struct World;
  std::unique_ptr<World> world_;
};

}  // namespace incision::bench

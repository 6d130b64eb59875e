#pragma once

#include <memory>
#include <vector>

#include "incision/scene/scene.h"

namespace incision::bench {

/// A body without cuts, loads and damping as Bullet's deformable world steps it: linear elasticity, warped, implicit.
///
/// Its step is ours but for the rotations: Bullet takes them at x + Δt v, ours at x, and it stops extracting them when
/// an iteration turns by less than 0.01 rad. The plain reference with these two changes gives the tip of Bullet's build
/// in double precision to all digits printed; without them the tips are 0.7 mm apart. The linear solve is conjugate
/// gradients on one thread, from zero, with the masses as preconditioner, down to √ε of float: 3e-4 of what it began
/// with.
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

#include "report/locking/problem.h"

#include "support/rig.h"

namespace incision::report {

TetMesh Problem::grid(int refinement) const {
  return gridMesh({{refinement * cells[0], refinement * cells[1], refinement * cells[2]}, size, origin});
}

Problem cantilever() {
  Problem p{"cantilever", Vec3(1, 0.25, 0.25), Vec3(0, -0.125, 0), {8, 2, 2}, {false, true, false}, 0, {}, {}};
  p.holds = {{slab(0, 0), Vec3::Zero()}};
  p.loads = {{slab(0, 1), Vec3(0, 0, -10), 0}};
  return p;
}

Problem heldBlock() {
  Problem p{"held block", Vec3(1, 1, 0.5), Vec3(-0.5, -0.5, 0), {4, 4, 2}, {true, true, false}, 2, {}, {}};
  p.holds = {{slab(2, 0), Vec3::Zero()}, {slab(2, 0.5), Vec3(0, 0, -0.005)}};
  return p;
}

Problem pressedBlock() {
  Problem p{"pressed block", Vec3(1, 1, 0.5), Vec3(-0.5, -0.5, 0), {4, 4, 2}, {true, true, false}, 2, {}, {}};
  p.holds = {{slab(2, 0), Vec3::Zero()}};
  const double half = 0.25 + 1e-9;
  p.loads = {{{Vec3(-half, -half, 0.5 - 1e-9), Vec3(half, half, 1)}, Vec3(0, 0, -1000), 0}};
  return p;
}

}  // namespace incision::report

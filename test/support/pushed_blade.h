#pragma once

#include <algorithm>
#include <cmath>

#include "support/blade.h"

namespace incision {

inline constexpr double BLOCK_HEIGHT = 0.1;  // along the edge [m]

/// A block of 0.2 × 0.1 × 0.1 m, held at its far end, and an edge along z through it that comes along x.
inline Scene blockAndEdge(int cells, double force) {
  Scene scene;
  scene.body.grid = GridSettings{{2 * cells, cells, cells}, Vec3(0.2, 0.1, BLOCK_HEIGHT), Vec3(0, -0.05, 0)};
  scene.body.material = {1e5, 0.3, 1000, 20, 0};
  scene.gravity = Vec3::Zero();
  scene.boundary = {{{Vec3(0.2 - 1e-6, -1, -1), Vec3(1, 1, 1)}, Vec3::Zero()}};
  scene.solver.method = Method::DIRECT;
  scene.tools = {bladeTool(Edge{Vec3(0, 0, -0.05), Vec3(0, 0, 0.15)})};
  bladeOf(&scene.tools[0]).cutting.resistance.force = force;
  return scene;
}

inline constexpr double PUSHED_AT = 0.004;  // [m], off the planes of nodes

/// A body whose blade is pushed along x, with what that took.
struct Pushed {
  explicit Pushed(const Scene& scene, double from = -0.02) : body(scene, loadMesh(scene)), x(from) {
    body.placeTool(poseAt(x, PUSHED_AT));
  }
  void to(double end, double speed) {
    const double dt = body.scene().solver.time_step;
    const int steps = static_cast<int>(std::ceil(std::abs(end - x) / (speed * dt) - 1e-9));
    const double move = (end - x) / steps;
    for (int k = 0; k < steps; ++k) {
      x += move;
      body.guideTool({poseAt(x, PUSHED_AT)});
      report = body.step().tools[0];
      work -= report.force.x() * move;
      most = std::max(most, report.force.norm());
      momentum += dt * report.force;
    }
  }
  double energy() const { return body.motion().elastic_energy + body.motion().kinetic_energy; }

  DeformableBody body;
  double x, work = 0, most = 0;
  Vec3 momentum = Vec3::Zero();  // that the tool has got
  ToolReport report;
};

}  // namespace incision

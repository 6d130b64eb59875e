#include "report/tool/push.h"

#include <cmath>

#include "support/rig.h"
#include "support/tool.h"

namespace incision::report {
namespace {

// A blade of some mm a second, in a body whose lowest mode takes a fraction of a second.
constexpr double TIME_STEP = 0.05;   // [s]
constexpr double MASS_DAMPING = 10;  // [1/s]
constexpr double REACH = 0.02;       // of the edge beyond the block's sides [m]
constexpr double RUN_UP = 5e-3;      // before the face [m]
constexpr int SETTLING_STEPS = 60;   // under the pull, before the blade comes
constexpr double LONG_STEP = 1;      // [s], in which inertia counts for nothing: a step of Newton's method
constexpr int NEWTON_STEPS = 12;

Scene blockOf(int cells, double pull) {
  Scene scene;
  const auto count = [&](double length) { return static_cast<int>(std::lround(length / cellSize(cells))); };
  scene.body.grid = GridSettings{{count(BLOCK.x()), cells, count(BLOCK.z())}, BLOCK, Vec3(0, -BLOCK.y() / 2, 0)};
  scene.body.material = {YOUNG_MODULUS, 0.3, 1000, MASS_DAMPING, 0};
  scene.gravity = Vec3::Zero();
  scene.boundary = {{slab(0, BLOCK.x()), Vec3::Zero()}};
  for (const int side : {-1, 1}) scene.loads.push_back({slab(1, side * BLOCK.y() / 2), Vec3(0, side * pull, 0), 0});
  scene.solver.time_step = TIME_STEP;
  scene.solver.method = Method::DIRECT;
  scene.solver.threads = 1;
  return scene;
}

double openingOf(const DeformableBody& body) {
  const std::vector<Vec3>& X = body.mesh().mesh().nodes;
  const std::vector<Vec3> x = body.nodePositions();
  double sum[2] = {0, 0};  // of the lower edge and the upper one
  int count = 0;           // of nodes on both
  for (std::size_t n = 0; n < X.size(); ++n) {
    if (X[n].x() > 1e-9 || std::abs(X[n].y()) < BLOCK.y() / 2 - 1e-9) continue;
    sum[X[n].y() > 0] += x[n].y() - X[n].y();
    ++count;
  }
  return 2 * (sum[1] - sum[0]) / count;
}

}  // namespace

double cellSize(int cells) { return BLOCK.y() / cells; }

Trace push(const Push& setting) {
  Scene scene = blockOf(setting.cells, setting.pull);
  scene.tools = {bladeTool(std::nullopt)};
  bladeOf(&scene.tools[0]).edge = Edge{Vec3(0, 0, -REACH), Vec3(0, 0, BLOCK.z() + REACH)};
  bladeOf(&scene.tools[0]).cutting.resistance.force = setting.cutting_force;
  bladeOf(&scene.tools[0]).cutting.progressive = setting.progressive;
  DeformableBody body(scene, loadMesh(scene));
  for (int k = 0; k < SETTLING_STEPS; ++k) body.step();

  Trace trace;
  Pose pose;
  pose.position.x() = -RUN_UP;
  body.placeTool(pose);
  while (pose.position.x() < setting.depth) {
    pose.position.x() += setting.stride;
    body.guideTool({pose});
    const StepResult result = body.step();
    trace.depth.push_back(pose.position.x());
    trace.force.push_back(-result.tools[0].force.x());
    trace.area.push_back(result.tools[0].stroke_area);
    trace.opening.push_back(openingOf(body));
  }
  return trace;
}

double openingAtRest(int cells, double pull, double depth) {
  Scene scene = blockOf(cells, pull);
  scene.solver.time_step = LONG_STEP;
  DeformableBody body(scene, loadMesh(scene));
  PlaneCut cut;
  cut.point = Vec3((depth - REACH) / 2, 0, BLOCK.z() / 2);
  cut.normal = Vec3::UnitY();
  cut.tangent = Vec3::UnitX();
  cut.length = depth + REACH;
  cut.width = BLOCK.z() + 2 * REACH;
  if (depth > 0) body.cut(cut);
  for (int k = 0; k < NEWTON_STEPS; ++k) body.step();
  return openingOf(body);
}

}  // namespace incision::report

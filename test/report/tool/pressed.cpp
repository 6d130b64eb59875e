#include "report/tool/pressed.h"

#include <algorithm>
#include <cmath>

#include "incision/mesh/grid_mesh.h"
#include "support/tool.h"

namespace incision::report {
namespace {

constexpr double RUN_UP = 1e-3;  // above the body [m]
constexpr double REACH = 5e-3;   // of the edge beyond the body's sides [m]

}  // namespace

Felt press(const Pressed& pressed) {
  Scene scene;
  scene.body.material = pressed.material;
  scene.gravity = Vec3::Zero();
  scene.boundary = {{Place(Vec3(-1, -1, -1), Vec3(1, 1, pressed.held + 1e-9)), Vec3::Zero()}};
  scene.solver.time_step = pressed.stride / pressed.speed;
  scene.solver.threads = 1;
  double side = REACH;
  for (const Vec3& X : pressed.mesh.nodes) side = std::max(side, X.y() + REACH);
  scene.tools = {bladeTool(Edge{Vec3(0, -side, 0), Vec3(0, side, 0)})};
  bladeOf(&scene.tools[0]).cutting.resistance.force = pressed.force;
  bladeOf(&scene.tools[0]).cutting.resistance.onset = pressed.onset;
  DeformableBody body(scene, pressed.mesh);

  Pose pose;
  pose.position = Vec3(pressed.beside, 0, pressed.height + RUN_UP);
  body.placeTool(pose);
  Felt felt;
  while (pressed.height - pose.position.z() < pressed.travel) {
    pose.position.z() -= pressed.stride;
    body.guideTool({pose});
    const StepResult result = body.step();
    felt.depth.push_back(pressed.height - pose.position.z());
    felt.force.push_back(result.tools[0].force.z());
    felt.area.push_back(result.tools[0].stroke_area);
  }
  return felt;
}

TetMesh prism(const Vec3& size, double cell) {
  GridSettings grid;
  for (int axis = 0; axis < 3; ++axis) grid.cells[axis] = static_cast<int>(std::lround(size[axis] / cell));
  grid.size = size;
  grid.origin = Vec3(-size.x() / 2, -size.y() / 2, 0);
  return gridMesh(grid);
}

TetMesh cylinder(double length, double diameter, double cell) {
  TetMesh mesh = prism(Vec3(length, diameter, diameter), cell);
  const double radius = diameter / 2;
  for (Vec3& X : mesh.nodes) {
    // From a square to a disc, smoothly.
    const double u = X.y() / radius, v = X.z() / radius - 1;
    X.y() = radius * u * std::sqrt(1 - v * v / 2);
    X.z() = radius * (1 + v * std::sqrt(1 - u * u / 2));
  }
  return mesh;
}

}  // namespace incision::report

#include "benchmark/scenes.h"

namespace incision::bench {
namespace {

ScheduledCut plane(double time, const Vec3& point, const Vec3& normal) {
  ScheduledCut cut;
  cut.time = time;
  cut.plane.point = point;
  cut.plane.normal = normal;
  return cut;
}

/// A square plane with sides along y.
ScheduledCut square(double time, const Vec3& centre, const Vec3& normal, double size) {
  ScheduledCut cut = plane(time, centre, normal);
  cut.plane.tangent = Vec3::UnitY();
  cut.plane.length = cut.plane.width = size;
  return cut;
}

}  // namespace

std::string nameOf(const Cells& cells) {
  return std::to_string(cells[0]) + "x" + std::to_string(cells[1]) + "x" + std::to_string(cells[2]);
}

Scene bar(const Cells& cells, double young_modulus) {
  Scene scene;
  scene.body.grid = GridSettings{cells, Vec3(1, 0.25, 0.25), Vec3::Zero()};
  scene.body.material.young_modulus = young_modulus;
  scene.boundary = {{{Vec3(-1, -1, -1), Vec3(1e-6, 1, 1)}, Vec3::Zero()}};
  scene.solver.tolerance = 1e-4;
  return scene;
}

Scene cutBar(const Cells& cells) {
  Scene scene = bar(cells);
  // A section askew to the fine grid meets as large a share of its elements as one across the coarse grid.
  const Vec3 normal = cells == MIDDLE ? Vec3(1, 0.05, 0.06) : Vec3(1, 0.8, 0.4);
  scene.cuts = {plane(0.3, Vec3(0.507, 0.125, 0), normal)};
  return scene;
}

Scene cutPlate() {
  Scene scene = bar({19, 25, 2});
  scene.body.grid->size = Vec3(0.38, 0.5, 0.04);
  scene.cuts = {plane(0.6, Vec3(0.307, 0.247, 0), Vec3(1, 0.01, 0.008)),
                plane(0.7, Vec3(0.197, 0.097, 0), Vec3(0.012, 1, 0.006)),
                plane(0.8, Vec3(0.197, 0.367, 0), Vec3(-0.01, 1, 0.008)),
                plane(0.9, Vec3(0.207, 0.247, 0), Vec3(1, -0.008, 0.01)),
                plane(1.0, Vec3(0.097, 0.247, 0), Vec3(1, 0.014, 0.004))};
  return scene;
}

Scene cutOrgan() {
  Scene scene =
      loadScene(INCISION_SOURCE_DIR "/config/scenes/demo.yaml", {"solver.time_step=0.005", "solver.tolerance=1e-4"});
  scene.tools.clear();
  scene.cuts = {square(0.4, Vec3(0.07, 0.05, -0.01), Vec3(1, 0, -0.2), 0.09),
                plane(0.6, Vec3(0.135, 0, -0.07), Vec3(0.7, 0.2, -0.7)),
                square(0.8, Vec3(0.11, -0.045, -0.04), Vec3(0.8, 0, -0.6), 0.09)};
  return scene;
}

Scene wall(const Cells& cells, bool in_pieces) {
  Scene scene = bar(cells);
  scene.body.grid->size = Vec3(1, 0.5, 1);
  scene.body.material.stiffness_damping = 1e-3;
  scene.boundary.clear();
  scene.contact = ContactSettings();
  scene.contact->ground = 0;
  if (!in_pieces) return scene;
  for (const auto& [point, normal] : {std::pair{Vec3(0.5, 0.25, 0.26), Vec3(0.02, 0, 1)},
                                      {Vec3(0.5, 0.25, 0.51), Vec3(0, 0.02, 1)},
                                      {Vec3(0.5, 0.25, 0.76), Vec3(0, 0, 1)},
                                      {Vec3(0.51, 0.25, 0.5), Vec3(1, 0, 0)}}) {
    ScheduledCut cut;
    cut.plane.point = point;
    cut.plane.normal = normal;
    scene.cuts.push_back(cut);
  }
  return scene;
}

}  // namespace incision::bench

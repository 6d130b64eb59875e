#pragma once

#include <Eigen/Geometry>
#include <random>

#include "incision/cut/crack.h"
#include "incision/mesh/grid_mesh.h"

namespace incision::test {

/// Seeded draws, so that every run sees the same.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  int index(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }
  Vec3 vector(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }
  Mat3 rotation() {
    Eigen::Quaterniond q(Eigen::Vector4d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(0.1, 1)));
    return q.normalized().toRotationMatrix();
  }
  Vec3 direction() { return rotation().col(0); }
  Barycentric inElement() {
    Barycentric b(uniform(0, 1), uniform(0, 1), uniform(0, 1), uniform(0, 1));
    b = -b.array().log();
    return b / b.sum();
  }
  /// Through a point well within the box of `grid`.
  PlaneCut plane(const GridSettings& grid) {
    PlaneCut plane;
    plane.point = grid.origin + grid.size.cwiseProduct(Vec3::Constant(0.5) + vector(0.4));
    plane.normal = direction();
    return plane;
  }
  /// A rectangle whose sides are these shares of the grid's longest side.
  PlaneCut rectangle(const GridSettings& grid, double least, double most) {
    PlaneCut rectangle = plane(grid);
    rectangle.tangent = rectangle.normal.cross(direction());
    rectangle.length = uniform(least, most) * grid.size.maxCoeff();
    rectangle.width = uniform(least, most) * grid.size.maxCoeff();
    return rectangle;
  }

 private:
  std::mt19937 engine_;
};

/// The grid with every node moved by up to `amount` of a cell, such that the body stays the same box, and with elements
/// and their nodes listed in random order.
inline TetMesh jitteredGrid(const GridSettings& grid, double amount, Random* random) {
  TetMesh mesh = gridMesh(grid);
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const Vec3 before = mesh.nodes[n];
    for (int d = 0; d < 3; ++d) {
      const double share = (before[d] - grid.origin[d]) / grid.size[d];
      if (share > 1e-9 && share < 1 - 1e-9)
        mesh.nodes[n][d] += random->uniform(-amount, amount) * grid.size[d] / grid.cells[d];
    }
  }
  for (std::size_t e = mesh.elements.size(); e-- > 0;) {
    std::swap(mesh.elements[e], mesh.elements[random->index(static_cast<int>(e) + 1)]);
    for (int turn = random->index(3); turn > 0; --turn)  // an even permutation keeps the volume's sign
      mesh.elements[e] = {mesh.elements[e][1], mesh.elements[e][2], mesh.elements[e][0], mesh.elements[e][3]};
  }
  return mesh;
}

}  // namespace incision::test

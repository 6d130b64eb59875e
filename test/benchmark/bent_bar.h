#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "incision/mesh/grid_mesh.h"
#include "incision/solver/aggregates.h"
#include "incision/solver/implicit_step.h"

namespace incision::bench {

inline constexpr int THREADS = 2;
inline constexpr double TIME_STEP = 0.01;  // [s]

/// The bar bent into an arc about y; `angle` [rad] is how far its end turns.
inline std::vector<Vec3> bent(const TetMesh& mesh, double angle) {
  std::vector<Vec3> x;
  for (const Vec3& X : mesh.nodes) {
    const double turn = angle * X.x(), radius = 1 / angle + X.z();
    x.emplace_back(radius * std::sin(turn), X.y(), radius * std::cos(turn) - 1 / angle);
  }
  return x;
}

/// The bar of one size, held at x = 0, with what the kernels need of it.
struct Bar {
  explicit Bar(const std::array<int, 3>& cells)
      : mesh(gridMesh({cells, Vec3(1, 0.25, 0.25), Vec3::Zero()}), THREADS),
        x(bent(mesh.mesh(), 0.5)),
        conditions{Vec3(0, 0, -9.81), {{{Vec3(-1, -1, -1), Vec3(1e-6, 1, 1)}, Vec3::Zero()}}, {}},
        materials(mesh.mesh(), Material()),
        assembly(mesh, materials, Mass::LUMPED, Pressure::ELEMENT, true, THREADS),
        piece(x.size(), 0) {
    for (const Vec3& X : mesh.mesh().nodes) held.push_back(conditions.clamps[0].place.box.contains(X));
    assembly.topologyChanged(x);
    assembly.rotate(x);
  }
  Bar(const Bar&) = delete;  // the assembly refers to the mesh

  double elements() const { return static_cast<double>(mesh.mesh().elements.size()); }
  double copies() const { return static_cast<double>(x.size()); }

  CutMesh mesh;
  std::vector<Vec3> x;
  BoundaryConditions conditions;
  Materials materials;
  Assembly assembly;
  std::vector<bool> held;
  std::vector<int> piece;
  SystemFactors factors{1, TIME_STEP* TIME_STEP};
};

/// The float matrix of a bar as the iteration has it.
struct Matrix {
  explicit Matrix(const Bar& bar) {
    const NodeOrder order = orderNodes(bar.mesh.mesh(), leafSize(static_cast<int>(bar.mesh.mesh().nodes.size())));
    findPattern(bar.assembly, orderCopies(bar.mesh, order, bar.held), &pattern);
    aggregates = aggregate(bar.mesh, order, pattern);
    for (int copy : pattern.copies) scale.push_back(1 / std::sqrt(diagonalOf(bar.assembly, bar.factors, copy)));
    assembler.assemble(bar.assembly, pattern, bar.factors, scale, &blocks);
  }

  BlockPattern pattern;
  Aggregates aggregates;
  std::vector<double> scale;
  BlockAssembler<float> assembler;
  std::vector<float> blocks;
};

}  // namespace incision::bench

#pragma once

#include <gtest/gtest.h>

#include <map>

#include "incision/fem/linear_tet.h"
#include "incision/surface/surface.h"

namespace incision::test {

/// Every edge of a triangle is run as often one way as the other. (More than once each way only inside a crack that has
/// not opened there, between two points of its fringe.)
inline void expectClosed(const Surface& surface) {
  std::map<std::pair<int, int>, int> runs;
  for (const auto& t : surface.triangles)
    for (int i = 0; i < 3; ++i) {
      ++runs[{t[i], t[(i + 1) % 3]}];
      --runs[{t[(i + 1) % 3], t[i]}];
    }
  int open = 0;
  for (const auto& [edge, balance] : runs) open += balance != 0;
  EXPECT_EQ(open, 0) << "of " << runs.size() << " edges";
}

/// Σ_p V_p det F_p [m³]: what the parts fill where the copies stand at `x`.
inline double filledVolume(const CutMesh& mesh, const std::vector<Vec3>& x) {
  const std::vector<RestElement> rest = restElements(mesh.mesh());
  double volume = 0;
  for (const Part& part : mesh.parts()) {
    const RestElement& element = rest[part.element];
    const auto& c = part.copies;
    volume += part.fraction * element.volume * gradient(x[c[0]], x[c[1]], x[c[2]], x[c[3]], element).determinant();
  }
  return volume;
}

inline void expectSurfaceEnclosesTheParts(const CutMesh& mesh, const std::vector<Vec3>& x, double tolerance) {
  const Surface surface = buildSurface(mesh);
  expectClosed(surface);
  EXPECT_NEAR(enclosedVolume(surface, surfacePositions(surface, x)), filledVolume(mesh, x), tolerance);
}

}  // namespace incision::test

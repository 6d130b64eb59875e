#include "incision/surface/rounding.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "incision/cut/cut_mesh.h"
#include "incision/mesh/grid_mesh.h"
#include "support/cuts.h"

namespace incision {
namespace {

/// A cube [-1, 1]³.
TetMesh cube() { return gridMesh({{4, 4, 4}, Vec3::Constant(2), Vec3::Constant(-1)}); }

/// The cube made round: its layers become spheres, the outermost of radius 1.
TetMesh ball() {
  TetMesh mesh = cube();
  for (Vec3& X : mesh.nodes)
    if (X.norm() > 0) X *= X.cwiseAbs().maxCoeff() / X.norm();
  return mesh;
}

struct Drawn {
  explicit Drawn(const TetMesh& of, bool is_cut = false) : mesh(of) {
    if (is_cut) mesh.insert(planeField(plane(Vec3(0.13, 0, 0), Vec3(1, 0.2, 0.1)), mesh, mesh.mesh().nodes));
    surface = buildSurface(mesh);
    std::vector<Vec3> copies;
    for (int c = 0; c < mesh.numCopies(); ++c) copies.push_back(mesh.mesh().nodes[mesh.copyNode(c)]);
    x = surfacePositions(surface, copies);
  }

  /// Calls f(triangle, ends of a side, what is drawn between them).
  template <class F>
  void forEachSide(const std::vector<Vec3>& now, const F& f) const {
    const Rounding rounding(surface, x);
    const std::vector<Vec3> middles = rounding.middles(surface, now);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
      for (int i = 0; i < 3; ++i)
        f(t, now[surface.triangles[t][i]], now[surface.triangles[t][(i + 1) % 3]], middles[rounding.sides()[t][i]]);
  }

  CutMesh mesh;
  Surface surface;
  std::vector<Vec3> x;  ///< of the vertices at rest
};

TEST(Rounding, LeavesABoxAsItIs) {
  const Drawn box(cube());
  box.forEachSide(box.x, [](std::size_t, const Vec3& a, const Vec3& b, const Vec3& middle) {
    EXPECT_LT((middle - (a + b) / 2).norm(), 1e-15);
  });
}

TEST(Rounding, BringsTheSidesOfABallOutToItsSphere) {
  const Drawn round(ball());
  double straight = 0, drawn = 0;
  round.forEachSide(round.x, [&](std::size_t, const Vec3& a, const Vec3& b, const Vec3& middle) {
    straight = std::max(straight, 1 - ((a + b) / 2).norm());
    drawn = std::max(drawn, std::abs(1 - middle.norm()));
  });
  EXPECT_GT(straight, 0.04);
  EXPECT_LT(drawn, straight / 3);
}

TEST(Rounding, LeavesCutFacesAndTheirRimsStraight) {
  const Drawn halves(ball(), true);
  int straight = 0, bent = 0;
  halves.forEachSide(halves.x, [&](std::size_t t, const Vec3& a, const Vec3& b, const Vec3& middle) {
    const bool is_straight = (middle - (a + b) / 2).norm() < 1e-15;
    if (halves.surface.cut_face[t]) {
      EXPECT_TRUE(is_straight);
    }
    ++(is_straight ? straight : bent);
  });
  EXPECT_GT(straight, 100);
  EXPECT_GT(bent, 100);
}

TEST(Rounding, HasOnePointForASideOfTwoTriangles) {
  const Drawn halves(ball(), true);
  std::map<std::pair<int, int>, int> sides;
  const Rounding rounding(halves.surface, halves.x);
  for (std::size_t t = 0; t < halves.surface.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const std::pair<int, int> ends =
          std::minmax(halves.surface.triangles[t][i], halves.surface.triangles[t][(i + 1) % 3]);
      EXPECT_EQ(sides.emplace(ends, rounding.sides()[t][i]).first->second, rounding.sides()[t][i]);
    }
}

TEST(Rounding, TurnsWithTheBody) {
  const Drawn round(ball());
  const Eigen::AngleAxisd turn(1, Vec3(1, 2, 3).normalized());
  std::vector<Vec3> turned, middles, of_turned;
  for (const Vec3& x : round.x) turned.push_back(turn * x + Vec3(1, 0, 5));
  round.forEachSide(round.x, [&](std::size_t, const Vec3&, const Vec3&, const Vec3& m) { middles.push_back(m); });
  round.forEachSide(turned, [&](std::size_t, const Vec3&, const Vec3&, const Vec3& m) { of_turned.push_back(m); });
  for (std::size_t i = 0; i < middles.size(); ++i)
    EXPECT_LT((turn * middles[i] + Vec3(1, 0, 5) - of_turned[i]).norm(), 1e-13);
}

TEST(Rounding, LeavesASharpFoldStraight) {
  const Drawn box(cube());
  std::vector<Vec3> folded = box.x;  // the upper face becomes a roof, with a right angle along y
  for (Vec3& x : folded)
    if (x.z() > 1 - 1e-9) x.z() = 3 - std::abs(x.x());
  box.forEachSide(folded, [](std::size_t, const Vec3& a, const Vec3& b, const Vec3& middle) {
    const bool on_ridge = std::min(a.z(), b.z()) > 3 - 1e-9;
    if (on_ridge) {
      EXPECT_LT((middle - (a + b) / 2).norm(), 1e-15);
    }
  });
}

TEST(Rounding, OfACollapsedSurfaceIsFinite) {
  const Drawn round(ball());
  const double largest = std::sqrt(std::numeric_limits<double>::max());
  for (const double size : {0.0, 1e-300, 1e-20, 1e20, 1e-3 * largest}) {
    std::vector<Vec3> x = round.x;
    for (Vec3& point : x) point *= size;
    round.forEachSide(x, [](std::size_t, const Vec3&, const Vec3&, const Vec3& m) { EXPECT_TRUE(m.allFinite()); });
  }
}

}  // namespace
}  // namespace incision

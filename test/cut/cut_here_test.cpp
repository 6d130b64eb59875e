#include "incision/cut/cut_here.h"

#include <gtest/gtest.h>

#include <cmath>

#include "incision/cut/section.h"
#include "support/cuts.h"
#include "support/deformed_mesh.h"
#include "support/random.h"
#include "support/scenes.h"

namespace incision {
namespace {

using test::DeformedMesh;
using test::plane;
using test::rectangle;

constexpr double FACES = 0.5;    // a plane of the cube's mesh faces [m]
constexpr double THROUGH = 0.6;  // a plane through its elements [m]
constexpr double DISTANCE = 0.05;

CutSought near(const Vec3& point, const Vec3& normal = Vec3::Zero()) {
  CutSought sought;
  sought.point = point;
  sought.normal = normal;
  sought.distance = DISTANCE;
  sought.cosine = 0.8;
  return sought;
}

/// Calls f(part, point) for points spread over the parts.
template <typename Function>
void forPoints(const CutMesh& mesh, const Function& f) {
  test::Random random(5);
  for (int p = 0; p < static_cast<int>(mesh.parts().size()); ++p) {
    const Polytope& polytope = mesh.polytope(p);
    for (int k = 0; k < 20; ++k) {
      Barycentric point = Barycentric::Zero();
      double sum = 0;
      for (const Barycentric& corner : polytope.corners) {
        const double weight = -std::log(random.uniform(0, 1));
        point += weight * corner;
        sum += weight;
      }
      f(p, atRest(mesh, mesh.parts()[p].element, point / sum));
    }
  }
}

TEST(CutHere, ThereIsNoneInAnUncutBody) {
  const DeformedMesh cube(gridMesh(CUBE));
  forPoints(cube.mesh, [&](int p, const Vec3& point) { EXPECT_FALSE(isCutHere(cube.mesh, p, near(point))); });
}

TEST(CutHere, IsWhereItIsNearWhateverPartOneAsksFrom) {
  for (const double height : {FACES, THROUGH}) {
    DeformedMesh cube(gridMesh(CUBE));
    cube.cut(plane(Vec3(0, 0, height), Vec3::UnitZ()));
    int there = 0;
    forPoints(cube.mesh, [&](int p, const Vec3& point) {
      const bool is_near = std::abs(point.z() - height) < DISTANCE;
      EXPECT_EQ(isCutHere(cube.mesh, p, near(point)), is_near) << height << " " << point.transpose();
      there += is_near;
    });
    EXPECT_GT(there, 500);
  }
}

TEST(CutHere, IsNotWhereItIsTurnedByMore) {
  for (const double height : {FACES, THROUGH}) {
    DeformedMesh cube(gridMesh(CUBE));
    cube.cut(plane(Vec3(0, 0, height), Vec3::UnitZ()));
    forPoints(cube.mesh, [&](int p, const Vec3& point) {
      const bool is_near = std::abs(point.z() - height) < DISTANCE;
      for (const double sign : {-1, 1}) {
        EXPECT_EQ(isCutHere(cube.mesh, p, near(point, sign * Vec3(0, std::sin(0.6), std::cos(0.6)))), is_near);
        EXPECT_FALSE(isCutHere(cube.mesh, p, near(point, sign * Vec3(0, std::sin(0.7), std::cos(0.7)))));
      }
    });
  }
}

TEST(CutHere, EndsWithItsRim) {
  for (const double height : {FACES, THROUGH}) {
    DeformedMesh cube(gridMesh(CUBE));
    cube.cut(rectangle(Vec3(0, 0.5, height), Vec3::UnitZ(), Vec3::UnitX(), 1, 2));  // to x = 0.5
    forPoints(cube.mesh, [&](int p, const Vec3& point) {
      // A part that the rectangle takes is cut over all of it.
      if (facetOf(cube.mesh.polytope(p), 0)) return;
      const double across = std::abs(point.z() - height), beyond = point.x() - 0.5;
      if (across >= DISTANCE || beyond > across + 1e-9) {
        EXPECT_FALSE(isCutHere(cube.mesh, p, near(point)));
      }
      if (across < DISTANCE && beyond < 0) {
        EXPECT_TRUE(isCutHere(cube.mesh, p, near(point)));
      }
    });
  }
}

// Above the faces every element is cut in two where the rectangle ends, below none is.
TEST(CutHere, EndsWithinAFaceOfTheMesh) {
  DeformedMesh cube(gridMesh(CUBE));
  const double end = 0.6;
  cube.cut(rectangle(Vec3(end, 0.5, 0.75), Vec3::UnitX(), Vec3::UnitY(), 2, 0.5));
  cube.cut(rectangle(Vec3(0, 0.5, FACES), Vec3::UnitZ(), Vec3::UnitX(), 2 * end, 2));
  int below = 0;
  forPoints(cube.mesh, [&](int p, const Vec3& point) {
    const double across = std::abs(point.z() - FACES), beyond = point.x() - end;
    const bool is_near = across < DISTANCE && beyond <= across;
    EXPECT_EQ(isCutHere(cube.mesh, p, near(point, Vec3::UnitZ())), is_near) << p << " at " << point.transpose();
    below += across < DISTANCE && point.z() < FACES && std::abs(beyond) < 0.1;
  });
  EXPECT_GT(below, 50);
}

TEST(CutHere, WhileItGrowsItIsNotInThePartsBesideIt) {
  DeformedMesh cube(gridMesh(CUBE));
  cube.cut(plane(Vec3(0, 0, THROUGH), Vec3::UnitZ()));
  forPoints(cube.mesh, [&](int p, const Vec3& point) {
    CutSought sought = near(point);
    sought.growing = 0;
    const bool own = facetOf(cube.mesh.polytope(p), 0) && std::abs(point.z() - THROUGH) < DISTANCE;
    EXPECT_EQ(isCutHere(cube.mesh, p, sought), own);
  });
}

}  // namespace
}  // namespace incision

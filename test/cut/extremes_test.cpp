#include <gtest/gtest.h>

#include "support/closed_surface.h"
#include "support/cut_laws.h"
#include "support/deformed_mesh.h"
#include "support/scenes.h"

namespace incision {
namespace {

using test::DeformedMesh;
using test::plane;

const GridSettings CELL = {{1, 1, 1}, Vec3::Ones(), Vec3::Zero()};

TEST(Extremes, OneElementInHundredsOfParts) {
  TetMesh element;
  element.nodes = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  element.elements = {{0, 1, 2, 3}};
  test::Random random(30);
  DeformedMesh body(element);
  for (int k = 0; k < 25; ++k) body.cut(plane(Vec3::Constant(0.22) + random.vector(0.05), random.direction()));
  const int parts = static_cast<int>(body.mesh.parts().size());
  EXPECT_GT(parts, 300);
  EXPECT_EQ(body.pieces(), parts);
  EXPECT_EQ(body.mesh.numCopies(), 4 * parts);
  test::expectPartsFillTheMesh(body.mesh);
  test::expectSurfaceEnclosesTheParts(body.mesh, body.x, 1e-11);
}

void cutByManyPlanes(int cells, int planes) {
  const GridSettings box = {{cells, cells, cells}, Vec3::Ones(), Vec3::Zero()};
  test::Random random(31);
  DeformedMesh body(test::jitteredGrid(box, 0.2, &random));
  for (int k = 0; k < planes; ++k) body.cut(random.rectangle(box, 0.15, 0.4));
  EXPECT_LE(body.mesh.numCracks(), planes);
  EXPECT_GT(body.mesh.numCracks(), planes / 2);
  test::expectSoundCutMesh(body.mesh);
  test::expectSurfaceEnclosesTheParts(body.mesh, body.x, 1e-10);
}

TEST(Extremes, TwoHundredRectanglesInASmallMesh) { cutByManyPlanes(4, 200); }
TEST(Extremes, FullFourHundredRectangles) { cutByManyPlanes(6, 400); }

TEST(Extremes, CutsAHairApart) {
  test::Random random(32);
  for (double gap = 1e-3; gap > 1e-13; gap /= 10) {
    SCOPED_TRACE("gap " + std::to_string(std::log10(gap)));
    DeformedMesh body(test::jitteredGrid({{2, 2, 2}, Vec3::Ones(), Vec3::Zero()}, 0.2, &random));
    const Vec3 normal = random.direction(), point = Vec3::Constant(0.5) + random.vector(0.1);
    EXPECT_TRUE(body.cut(plane(point, normal)).changed());
    for (int k = 1; k <= 3; ++k) body.cut(plane(point + k * gap * normal, normal));
    EXPECT_GE(body.pieces(), 2);
    EXPECT_LE(body.pieces(), 5);
    test::expectSoundCutMesh(body.mesh);
    test::expectSurfaceEnclosesTheParts(body.mesh, body.x, 1e-11);
  }
}

TEST(Extremes, CutsThatTurnByAHair) {
  test::Random random(33);
  for (double angle = 1e-2; angle > 1e-14; angle /= 10) {
    SCOPED_TRACE("angle " + std::to_string(std::log10(angle)));
    DeformedMesh body(test::jitteredGrid({{2, 2, 2}, Vec3::Ones(), Vec3::Zero()}, 0.2, &random));
    const Vec3 normal = random.direction(), point = Vec3::Constant(0.5) + random.vector(0.1);
    for (int k = 0; k < 4; ++k) body.cut(plane(point, normal + k * angle * random.direction()));
    EXPECT_GE(body.pieces(), 2);
    test::expectSoundCutMesh(body.mesh);
    test::expectSurfaceEnclosesTheParts(body.mesh, body.x, 1e-11);
  }
}

// Positions in which φ is alike all over, or turned inside out.
TEST(Extremes, CutsOfCollapsedAndInvertedBodies) {
  test::Random random(34);
  for (double scale : {0.0, 1e-300, 1e-12, -1.0, -1e-9}) {
    SCOPED_TRACE("scale " + std::to_string(scale));
    for (int axes = 1; axes <= 3; ++axes) {
      DeformedMesh body(test::jitteredGrid({{2, 2, 2}, Vec3::Ones(), Vec3::Zero()}, 0.2, &random));
      for (Vec3& x : body.x) x.head(axes) *= scale;
      for (int k = 0; k < 3; ++k) {
        const Vec3 inside = 0.25 * (body.x[0] + body.x[8] + body.x[17] + body.x[26]);
        body.cut(plane(inside + random.vector(0.1 * std::abs(scale)), random.direction()));
      }
      test::expectSoundCutMesh(body.mesh);
      test::expectSurfaceEnclosesTheParts(body.mesh, body.x, 1e-11);
    }
  }
}

TEST(Extremes, APlaneAwayFromTheBodyOrFarOffDoesNothing) {
  for (double distance : {1.5, 1e3, 1e9}) {
    DeformedMesh body(gridMesh(CELL));
    EXPECT_FALSE(body.cut(plane(Vec3(distance, 0, 0), Vec3(1, 1e-10, 0))).changed());
  }
}

}  // namespace
}  // namespace incision

#include "incision/rigid/mesh_solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "incision/base/input_error.h"
#include "incision/base/nearest.h"
#include "incision/rigid/box.h"
#include "support/distance_gradient.h"
#include "support/rig.h"
#include "support/solid_meshes.h"

namespace incision::test {
namespace {

std::unique_ptr<MeshSolid> solidOf(const TriangleMesh& mesh) {
  std::string remark;
  auto solid = std::make_unique<MeshSolid>(closeMesh(mesh, &remark));
  EXPECT_EQ(remark, "");
  return solid;
}

std::array<Vec3, 3> cornersOf(const TriangleMesh& mesh, std::size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

/// How often a closed surface goes round the point (van Oosterom and Strackee's solid angles, 1983).
double windingNumber(const TriangleMesh& mesh, const Vec3& point) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [p, q, r] = cornersOf(mesh, t);
    const Vec3 a = p - point, b = q - point, c = r - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (2 * M_PI);
}

double distanceToAll(const TriangleMesh& mesh, const Vec3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    least = std::min(least, (nearestOnTriangle(cornersOf(mesh, t), point) - point).norm());
  return least;
}

/// Signed, by looking at every triangle.
double plainDistance(const TriangleMesh& mesh, const Vec3& point) {
  return (windingNumber(mesh, point) > 0.5 ? -1 : 1) * distanceToAll(mesh, point);
}

/// Every other one is half as far out, where the solids are thick.
std::vector<Vec3> randomPoints(std::size_t count, unsigned seed) {
  std::vector<Vec3> points = randomVectors(count, 1.3, seed);
  for (std::size_t i = 0; i < count; i += 2) points[i] /= 2;
  return points;
}

/// A prism over a star, whose points are sharp and whose corners between them are hollow.
TriangleMesh starMesh() {
  std::vector<Eigen::Vector2d> corners;
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < 10; ++i) corners.emplace_back(onCircle(i % 2 == 0 ? 1 : 0.3, i, 10, 0).head<2>());
  for (int i = 1; i < 10; i += 2) faces.push_back({i, (i + 1) % 10, (i + 2) % 10});
  for (int i = 3; i < 9; i += 2) faces.push_back({1, i, i + 2});
  return prismMesh(corners, faces, -0.2, 0.3);
}

const TriangleMesh BOX = boxMesh(Vec3(0.5, 1.2, 0.8)), SPHERE = sphereMesh(0.7, 12), TORUS = torusMesh(0.8, 0.25, 12),
                   ANGLE = angleMesh(), STAR = starMesh(), CYLINDER = cylinderMesh(0.4, 1.1, 16);
const TriangleMesh APART = together({boxMesh(Vec3(0.3, 0.4, 0.5), Vec3(-0.6, 0, 0)), sphereMesh(0.4, 8),
                                     boxMesh(Vec3(0.2, 0.2, 1.4), Vec3(0.7, 0.5, 0))});
const std::vector<const TriangleMesh*> ALL = {&BOX, &SPHERE, &TORUS, &ANGLE, &STAR, &CYLINDER, &APART};

TEST(MeshSolid, DistanceIsThatOfEveryTriangleLookedAtAndItsSignThatOfTheWindingNumber) {
  for (std::size_t i = 0; i < ALL.size(); ++i) {
    const auto solid = solidOf(*ALL[i]);
    int inside = 0;
    for (const Vec3& p : randomPoints(700, 7)) {
      const double plain = plainDistance(*ALL[i], p);
      EXPECT_NEAR(solid->distanceTo(p).distance, plain, 1e-12) << "mesh " << i << " at " << p.transpose();
      inside += plain < 0 ? 1 : 0;
    }
    EXPECT_GT(inside, 7) << i;
  }
}

TEST(MeshSolid, DistanceIsRightNextToEdgesAndCorners) {
  std::mt19937 random(3);
  std::normal_distribution<double> near(0, 1e-3);
  for (const TriangleMesh* mesh : ALL) {
    const auto solid = solidOf(*mesh);
    for (const Vec3& vertex : mesh->vertices)
      for (int i = 0; i < 5; ++i) {
        const Vec3 p = vertex + Vec3(near(random), near(random), near(random));
        EXPECT_NEAR(solid->distanceTo(p).distance, plainDistance(*mesh, p), 1e-12);
      }
  }
}

TEST(MeshSolid, WhereShellsOverlapTheDeepestCounts) {
  const TriangleMesh a = boxMesh(Vec3(1, 1, 1), Vec3(-0.2, 0, 0)), b = boxMesh(Vec3(1, 0.6, 1.4), Vec3(0.3, 0.1, 0));
  const auto both = solidOf(together({a, b}));
  for (const Vec3& p : randomPoints(700, 9))
    EXPECT_NEAR(both->distanceTo(p).distance, std::min(plainDistance(a, p), plainDistance(b, p)), 1e-12);
}

TEST(MeshSolid, NormalIsTheDistancesGradient) {
  const double h = 1e-6;
  for (const TriangleMesh* mesh : ALL) {
    const auto solid = solidOf(*mesh);
    int compared = 0;
    for (const Vec3& p : randomPoints(300, 11)) {
      const Vec3 normal = solid->distanceTo(p).normal;
      ASSERT_NEAR(normal.norm(), 1, 1e-12);
      const std::optional<Vec3> gradient = distanceGradient(*solid, p, h);
      EXPECT_TRUE(!gradient || (*gradient - normal).norm() < 1e-6) << p.transpose();
      compared += gradient.has_value();
    }
    EXPECT_GT(compared, 250);
  }
}

TEST(MeshSolid, OfABoxIsThatBox) {
  const Box box(Vec3(0.5, 1.2, 0.8));
  const auto solid = solidOf(BOX);
  EXPECT_TRUE(solid->isConvex());
  EXPECT_NEAR(solid->thickness(), 0.5, 1e-12);
  EXPECT_NEAR(solid->reach(), box.reach(), 1e-12);
  const std::vector<Vec3> normals = randomPoints(300, 2);
  int compared = 0;
  for (const Vec3& p : randomPoints(300, 1)) {
    const Vec3 n = normals[compared++].normalized();
    const SolidDistance is = solid->distanceTo(p), should = box.distanceTo(p);
    EXPECT_NEAR(is.distance, should.distance, 1e-12);
    EXPECT_LT((is.normal - should.normal).norm(), 1e-9);
    const SolidDistance against = solid->distanceAgainst(p, n), box_against = box.distanceAgainst(p, n);
    EXPECT_NEAR(against.distance, box_against.distance, 1e-12);
    EXPECT_LT((against.normal - box_against.normal).norm(), 1e-12);
    EXPECT_NEAR(solid->reachAlong(n), box.reachAlong(n), 1e-12);
  }
}

TEST(MeshSolid, KnowsWhetherItIsConvex) {
  EXPECT_TRUE(solidOf(SPHERE)->isConvex());
  EXPECT_TRUE(solidOf(CYLINDER)->isConvex());
  for (const TriangleMesh* mesh : {&TORUS, &ANGLE, &STAR, &APART}) EXPECT_FALSE(solidOf(*mesh)->isConvex());
}

TEST(MeshSolid, ReachesAsFarAsItsFarthestVertex) {
  for (const TriangleMesh* mesh : ALL) {
    const auto solid = solidOf(*mesh);
    for (const Vec3& p : randomPoints(100, 5)) {
      const Vec3 n = p.normalized();
      double along = -std::numeric_limits<double>::infinity(), farthest = 0;
      for (const Vec3& vertex : mesh->vertices) {
        along = std::max(along, n.dot(vertex));
        farthest = std::max(farthest, vertex.norm());
      }
      EXPECT_NEAR(solid->reachAlong(n), along, 1e-14);
      EXPECT_NEAR(solid->reach(), farthest, 1e-14);
    }
  }
}

TEST(MeshSolid, IsAsThickAsTheNarrowestPairOfPlanesThatHoldsIt) {
  // A regular tetrahedron is narrowest between opposite edges, a box between faces, a round solid anywhere.
  const TriangleMesh tetrahedron = {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                                    {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
  EXPECT_NEAR(solidOf(tetrahedron)->thickness(), 2, 1e-8);
  EXPECT_NEAR(solidOf(ANGLE)->thickness(), 0.4, 1e-12);
  EXPECT_NEAR(solidOf(TORUS)->thickness(), 0.5, 0.01);
  const double thickness = solidOf(SPHERE)->thickness();
  EXPECT_LE(thickness, 1.4);
  EXPECT_GE(thickness, 1.4 * std::cos(M_PI / 24) * std::cos(M_PI / 24));
}

TEST(MeshSolid, ComesOutAgainstANormalWhereTheRayFirstLeavesASolidThatIsNotConvex) {
  const auto solid = solidOf(ANGLE);
  // In the leg along x, from which the other leg reaches much farther along y.
  const SolidDistance out = solid->distanceAgainst(Vec3(0.7, 0.1, 0.2), Vec3(0, -1, 0));
  EXPECT_NEAR(out.distance, -0.2, 1e-12);
  EXPECT_LT((out.normal - Vec3::UnitY()).norm(), 1e-12);
  const SolidDistance aslant = solid->distanceAgainst(Vec3(0.7, 0.1, 0.2), Vec3(0.6, -0.8, 0));
  EXPECT_NEAR(aslant.distance, -0.2, 1e-12);
  EXPECT_EQ(solid->distanceAgainst(Vec3(0.7, 0.9, 0.2), Vec3(0, -1, 0)).distance,
            -std::numeric_limits<double>::infinity());
}

TEST(MeshSolid, SaysOfNoPointThatItIsFartherAwayThanItIs) {
  for (const TriangleMesh* mesh : ALL) {
    const auto solid = solidOf(*mesh);
    int clear = 0, far = 0;
    for (const Vec3& p : randomPoints(3000, 13)) {
      const double distance = solid->distanceTo(p).distance, room = 0.02;
      const bool is_clear = solid->isClearOf(p, room);
      EXPECT_TRUE(!is_clear || distance > room);
      clear += is_clear ? 1 : 0;
      far += distance > room ? 1 : 0;
    }
    EXPECT_GT(clear, 0.6 * far);
  }
}

TEST(MeshSolid, SizesOutOfRangeAreRefused) {
  EXPECT_NO_THROW(solidOf(BOX)->check("here"));
  EXPECT_THROW(solidOf(boxMesh(Vec3(1e-3, 1e-3, 1e-7)))->check("here"), InputError);
  EXPECT_THROW(solidOf(boxMesh(Vec3(1, 1, 1), Vec3(2e6, 0, 0)))->check("here"), InputError);
}

}  // namespace
}  // namespace incision::test

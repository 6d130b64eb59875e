#include "incision/fem/loads.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/deformed_mesh.h"
#include "support/rig.h"

namespace incision {
namespace {

const RestBox ALL_OF_IT = {Vec3::Constant(-10), Vec3::Constant(10)};
constexpr double PRESSURE = 200;

Load pressing(const Place& place) {
  Load load;
  load.place = place;
  load.pressure = PRESSURE;
  return load;
}

std::vector<Vec3> forcesAt(const CutMesh& mesh, const Load& load, const std::vector<Vec3>& x, double time = 1) {
  Loads loads(mesh, {load});
  loads.topologyChanged();
  std::vector<Vec3> forces(x.size(), Vec3::Zero());
  loads.addTo(time, x, &forces);
  return forces;
}

Vec3 sumOf(const std::vector<Vec3>& forces) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& f : forces) sum += f;
  return sum;
}

test::DeformedMesh blockCutTwice() {
  test::DeformedMesh body(block({3, 2, 2}, Vec3(0.9, 0.6, 0.4)));
  body.cut(plane(Vec3(0.45, 0.3, 0.2), Vec3(0.5, 1, 0.7)));
  body.cut(plane(Vec3(0.45, 0.3, 0.2), Vec3(1, -0.5, 0.2)));
  return body;
}

/// Of the mesh with these positions of its copies, none of which is cut [m³].
double volume(const CutMesh& mesh, const std::vector<Vec3>& x) {
  double sum = 0;
  for (const auto& e : mesh.mesh().elements) sum += sixVolumes(x[e[0]], x[e[1]], x[e[2]], x[e[3]]) / 6;
  return sum;
}

// The two skins of a cut that has not opened close each other.
TEST(Pressures, OnAClosedSkinSumToZeroInAnyDeformation) {
  test::Random random(1);
  test::DeformedMesh cut = blockCutTwice();
  for (int k = 0; k < 10; ++k) {
    std::vector<Vec3> of_node = cut.mesh.mesh().nodes;
    for (Vec3& x : of_node) x += random.vector(0.3);
    for (int c = 0; c < cut.mesh.numCopies(); ++c) cut.x[c] = of_node[cut.mesh.copyNode(c)];
    const std::vector<Vec3> forces = forcesAt(cut.mesh, pressing(ALL_OF_IT), cut.x);
    double largest = 0;
    Vec3 torque = Vec3::Zero();
    for (std::size_t c = 0; c < forces.size(); ++c) {
      largest += forces[c].norm();
      torque += cut.x[c].cross(forces[c]);
    }
    EXPECT_GT(largest, PRESSURE);
    EXPECT_LT(sumOf(forces).norm(), 1e-12 * largest);
    EXPECT_LT(torque.norm(), 1e-12 * largest);
  }
}

// The volume is a polynomial of the third degree along any way: five points give its slope.
TEST(Pressures, DoTheWorkOfTheVolumeThatTheyTake) {
  test::Random random(2);
  test::DeformedMesh body(block({2, 2, 2}, Vec3(1, 0.8, 0.6)));
  for (int k = 0; k < 10; ++k) {
    body.shake(0.05, &random);
    std::vector<Vec3> way(body.x.size());
    for (Vec3& d : way) d = random.vector(1);
    const auto volumeAt = [&](double s) {
      std::vector<Vec3> x = body.x;
      for (std::size_t c = 0; c < x.size(); ++c) x[c] += s * way[c];
      return volume(body.mesh, x);
    };
    const double h = 0.01;
    const double slope = (8 * (volumeAt(h) - volumeAt(-h)) - (volumeAt(2 * h) - volumeAt(-2 * h))) / (12 * h);
    const std::vector<Vec3> forces = forcesAt(body.mesh, pressing(ALL_OF_IT), body.x);
    double work = 0;
    for (std::size_t c = 0; c < forces.size(); ++c) work += forces[c].dot(way[c]);
    EXPECT_NEAR(work, -PRESSURE * slope, 1e-10 * PRESSURE);
  }
}

TEST(Pressures, TurnWithEachPieceByTheAreaItOwns) {
  test::Random random(3);
  test::DeformedMesh body = blockCutTwice();
  const auto piecewise = [&](const std::vector<Vec3>& x) {
    int pieces = 0;
    const std::vector<int> piece = body.mesh.copyPieces(&pieces);
    std::vector<Vec3> sums(pieces, Vec3::Zero());
    const std::vector<Vec3> forces = forcesAt(body.mesh, pressing(slab(0, 0.9)), x);
    for (std::size_t c = 0; c < forces.size(); ++c) sums[piece[c]] += forces[c];
    return sums;
  };
  const std::vector<Vec3> rest = piecewise(body.x);
  ASSERT_GT(rest.size(), 2u);
  EXPECT_LT((sumOf(rest) - Vec3(-PRESSURE * 0.6 * 0.4, 0, 0)).norm(), 1e-12 * PRESSURE);
  body.scatter(1, &random);
  const std::vector<Vec3> turned = piecewise(body.x);
  for (std::size_t k = 0; k < rest.size(); ++k) EXPECT_NEAR(turned[k].norm(), rest[k].norm(), 1e-12 * PRESSURE);
  EXPECT_GT((sumOf(turned) - sumOf(rest)).norm(), 0.1 * PRESSURE * 0.6 * 0.4);
}

TEST(Pressures, GrowOverTheirRamp) {
  const test::DeformedMesh body(block({1, 1, 1}, Vec3::Ones()));
  Load load = pressing(slab(0, 1));
  load.ramp = 0.5;
  for (const auto& [time, share] : {std::pair(0.0, 0.0), {0.25, 0.5}, {0.5, 1.0}, {2.0, 1.0}})
    EXPECT_LT((sumOf(forcesAt(body.mesh, load, body.x, time)) - Vec3(-share * PRESSURE, 0, 0)).norm(), 1e-12);
}

TEST(Pressures, ActBesideATractionOfTheSameLoad) {
  const test::DeformedMesh body(block({1, 1, 1}, Vec3::Ones()));
  Load load = pressing(slab(0, 1));
  load.traction = Vec3(1, 2, 3);
  EXPECT_LT((sumOf(forcesAt(body.mesh, load, body.x)) - Vec3(1 - PRESSURE, 2, 3)).norm(), 1e-12);
}

TEST(Loads, LieOnGroupsOfSurfaces) {
  TetMesh mesh = block({2, 2, 2}, Vec3::Ones());
  PhysicalGroup skin;
  skin.name = "skin";
  skin.dimension = 2;
  for (const ElementFace& at : boundaryFacesAt(slab(2, 1), mesh, buildTopology(mesh))) {
    std::array<int, 3> nodes;
    for (int i = 0; i < 3; ++i) nodes[i] = mesh.elements[at.element][FACE_NODES[at.face][i]];
    std::sort(nodes.begin(), nodes.end());
    skin.triangles.push_back(nodes);
  }
  std::sort(skin.triangles.begin(), skin.triangles.end());
  mesh.groups.push_back(skin);
  const test::DeformedMesh body(mesh);
  Place place;
  place.group = "skin";
  EXPECT_LT((sumOf(forcesAt(body.mesh, pressing(place), body.x)) - Vec3(0, 0, -PRESSURE)).norm(), 1e-12 * PRESSURE);
}

}  // namespace
}  // namespace incision

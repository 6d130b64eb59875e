#include <gtest/gtest.h>

#include <map>

#include "support/closed_surface.h"
#include "support/cut_laws.h"
#include "support/deformed_mesh.h"

namespace incision {
namespace {

using test::DeformedMesh;

using Corners = std::array<Vec3, 4>;
using Sides = std::vector<bool>;  // of each plane

// Volumes of the zones into which planes part a tetrahedron, by splitting it into tetrahedra.
void addZones(const Corners& tet, const std::vector<PlaneCut>& planes, Sides* sides, std::map<Sides, double>* zones) {
  const std::size_t k = sides->size();
  if (k == planes.size()) {
    (*zones)[*sides] += std::abs(sixVolumes(tet[0], tet[1], tet[2], tet[3])) / 6;
    return;
  }
  const auto visit = [&](bool side, const Corners& piece) {
    sides->push_back(side);
    addZones(piece, planes, sides, zones);
    sides->pop_back();
  };
  std::vector<Vec3> in, out;
  const auto phi = [&](const Vec3& x) { return planes[k].normal.dot(x - planes[k].point); };
  for (const Vec3& x : tet) (phi(x) > 0 ? in : out).push_back(x);
  const auto cross = [&](const Vec3& a, const Vec3& b) -> Vec3 { return a + phi(a) / (phi(a) - phi(b)) * (b - a); };
  const auto prism = [&](bool side, const std::array<Vec3, 6>& p) {  // triangles 012 and 345
    visit(side, {p[0], p[1], p[2], p[5]});
    visit(side, {p[0], p[1], p[5], p[4]});
    visit(side, {p[0], p[4], p[5], p[3]});
  };
  if (in.empty() || out.empty()) return visit(!in.empty(), tet);
  for (bool side : {true, false}) {
    const auto &near = side ? in : out, &far = side ? out : in;
    if (near.size() == 1)
      visit(side, {near[0], cross(near[0], far[0]), cross(near[0], far[1]), cross(near[0], far[2])});
    else if (near.size() == 2)
      prism(side, {near[0], cross(near[0], far[0]), cross(near[0], far[1]), near[1], cross(near[1], far[0]),
                   cross(near[1], far[1])});
    else
      prism(side, {near[0], near[1], near[2], cross(near[0], far[0]), cross(near[1], far[0]), cross(near[2], far[0])});
  }
}

std::vector<double> zoneVolumes(const TetMesh& mesh, const std::vector<PlaneCut>& planes) {
  std::map<Sides, double> zones;
  Sides sides;
  for (const auto& e : mesh.elements)
    addZones({mesh.nodes[e[0]], mesh.nodes[e[1]], mesh.nodes[e[2]], mesh.nodes[e[3]]}, planes, &sides, &zones);
  std::vector<double> volumes;
  for (const auto& [zone, volume] : zones) volumes.push_back(volume);
  std::sort(volumes.begin(), volumes.end());
  return volumes;
}

std::vector<double> pieceVolumes(const DeformedMesh& body) {
  int count = 0;
  const std::vector<int> piece = body.mesh.copyPieces(&count);
  std::vector<double> volumes(count, 0);
  for (const Part& part : body.mesh.parts())
    volumes[piece[part.copies[0]]] += part.fraction * elementVolume(body.mesh.mesh(), part.element);
  std::sort(volumes.begin(), volumes.end());
  return volumes;
}

// Snapping moves a crack, so planes that pass close by a node have no exact answer.
bool passesByANode(const PlaneCut& plane, const DeformedMesh& body) {
  for (int n = 0; n < static_cast<int>(body.mesh.mesh().nodes.size()); ++n)
    if (std::abs(plane.normal.dot(body.mesh.mesh().nodes[n] - plane.point)) < 2 * SNAP * body.mesh.shortestEdge(n))
      return true;
  return false;
}

// Whether a plane left some part whole that it passes through: its section there lies within snap of an older cut face.
bool tookASectionForAnOlderCut(const DeformedMesh& body, const std::vector<PlaneCut>& planes) {
  for (int p = 0; p < static_cast<int>(body.mesh.parts().size()); ++p)
    for (const PlaneCut& plane : planes) {
      double least = 0, most = 0;
      for (const Barycentric& b : body.mesh.polytope(p).corners) {
        Vec3 X = Vec3::Zero();
        for (int I = 0; I < 4; ++I)
          X += b[I] * body.mesh.mesh().nodes[body.mesh.mesh().elements[body.mesh.parts()[p].element][I]];
        least = std::min(least, plane.normal.dot(X - plane.point));
        most = std::max(most, plane.normal.dot(X - plane.point));
      }
      if (least < -1e-12 && most > 1e-12) return true;
    }
  return false;
}

// Planes part a box into their zones, whatever the mesh: as many pieces, of the same volumes.
void expectZonesOfPlanes(int runs, unsigned seed) {
  test::Random random(seed);
  const GridSettings box = {{3, 3, 2}, Vec3(1, 0.9, 0.7), Vec3(-0.2, 0.1, 0)};
  int compared = 0;
  for (int run = 0; run < runs; ++run) {
    DeformedMesh body(test::jitteredGrid(box, 0.2, &random));
    std::vector<PlaneCut> planes;
    while (planes.size() < 5) {
      const PlaneCut plane = random.plane(box);
      if (passesByANode(plane, body)) continue;
      planes.push_back(plane);
      body.cut(plane);
    }
    test::expectSoundCutMesh(body.mesh);
    if (tookASectionForAnOlderCut(body, planes)) continue;
    ++compared;
    const std::vector<double> zones = zoneVolumes(body.mesh.mesh(), planes), pieces = pieceVolumes(body);
    ASSERT_EQ(pieces.size(), zones.size()) << "run " << run;
    for (std::size_t k = 0; k < zones.size(); ++k) EXPECT_NEAR(pieces[k], zones[k], 1e-12 * box.size.prod());
  }
  EXPECT_GT(compared, 9 * runs / 10);
}

TEST(RandomCuts, PlanesPartABoxIntoTheirZones) { expectZonesOfPlanes(30, 20); }
TEST(RandomCuts, FullPlanesPartABoxIntoTheirZones) { expectZonesOfPlanes(500, 21); }

// Planes and rectangles given in a body whose pieces have flown apart and whose copies are out of place.
void expectSoundWhenDeformed(int runs, unsigned seed) {
  test::Random random(seed);
  const GridSettings box = {{4, 3, 3}, Vec3(1, 0.8, 0.8), Vec3::Zero()};
  for (int run = 0; run < runs; ++run) {
    SCOPED_TRACE("run " + std::to_string(run));
    DeformedMesh body(test::jitteredGrid(box, 0.2, &random));
    for (int cut = 0; cut < 8; ++cut) {
      body.shake(0.03, &random);
      if (cut % 4 == 3) body.scatter(0.2, &random);
      body.cut(random.index(2) ? random.plane(box) : random.rectangle(box, 0.2, 1));
    }
    test::expectSoundCutMesh(body.mesh);
    test::expectContinuityAtRandomFacePoints(body.mesh, 300, &random);
    test::expectSurfaceEnclosesTheParts(body.mesh, body.x, 1e-11);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(RandomCuts, KeepTheLawsInDeformedBodies) { expectSoundWhenDeformed(20, 22); }
TEST(RandomCuts, FullKeepTheLawsInDeformedBodies) { expectSoundWhenDeformed(400, 23); }

// Through nodes, edges and faces of a grid, in all the ways that small whole numbers give.
void expectSoundThroughNodes(int runs, unsigned seed) {
  test::Random random(seed);
  const GridSettings box = {{4, 4, 4}, Vec3::Constant(4), Vec3::Zero()};
  for (int run = 0; run < runs; ++run) {
    SCOPED_TRACE("run " + std::to_string(run));
    DeformedMesh body(gridMesh(box));
    for (int cut = 0; cut < 6; ++cut) {
      const auto whole = [&](int low, int count) { return static_cast<double>(low + random.index(count)); };
      PlaneCut plane;
      plane.point = Vec3(whole(0, 5), whole(0, 5), whole(0, 5));
      plane.normal = Vec3(whole(-1, 3), whole(-1, 3), whole(-1, 3));
      if (plane.normal.isZero()) continue;
      if (random.index(2)) {
        plane.tangent = plane.normal.cross(random.direction());
        plane.length = whole(1, 4);
        plane.width = whole(1, 4);
      }
      body.cut(plane);
    }
    test::expectSoundCutMesh(body.mesh);
    test::expectContinuityAtRandomFacePoints(body.mesh, 300, &random);
    test::expectSurfaceEnclosesTheParts(body.mesh, body.x, 64e-12);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(RandomCuts, KeepTheLawsThroughNodesEdgesAndFaces) { expectSoundThroughNodes(30, 24); }
TEST(RandomCuts, FullKeepTheLawsThroughNodesEdgesAndFaces) { expectSoundThroughNodes(500, 25); }

}  // namespace
}  // namespace incision

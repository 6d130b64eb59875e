#include "incision/surface/surface.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "incision/cut/cut_mesh.h"
#include "incision/mesh/grid_mesh.h"

namespace incision {
namespace {

using Random = std::mt19937;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Vec3 uniformVector(Random& random, double size) {
  return {uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size)};
}

/// A cut mesh and where its copies are.
struct Body {
  CutMesh mesh;
  std::vector<Vec3> x;

  explicit Body(const TetMesh& tets) : mesh(tets) {
    for (int c = 0; c < mesh.numCopies(); ++c) x.push_back(mesh.mesh().nodes[mesh.copyNode(c)]);
  }

  Insertion cut(const PlaneCut& plane) {
    const Insertion done = mesh.insert(planeField(plane, mesh, x));
    addNewCopies();
    return done;
  }

  void addNewCopies() {
    for (int c = static_cast<int>(x.size()); c < mesh.numCopies(); ++c) x.push_back(x[mesh.copyParent(c)]);
  }

  /// Moves every copy on its own, so that cracks open.
  void shake(Random& random, double size) {
    for (Vec3& position : x) position += uniformVector(random, size);
  }
};

TetMesh jitteredGrid(const std::array<int, 3>& cells, double jitter, Random& random) {
  TetMesh mesh = gridMesh({cells, Vec3(cells[0], cells[1], cells[2]), Vec3::Zero()});
  for (Vec3& X : mesh.nodes) X += uniformVector(random, jitter);
  return mesh;
}

PlaneCut plane(const Vec3& point, const Vec3& normal) {
  PlaneCut cut;
  cut.point = point;
  cut.normal = normal;
  return cut;
}

PlaneCut rectangle(const Vec3& point, const Vec3& normal, const Vec3& tangent, double length, double width) {
  PlaneCut cut = plane(point, normal);
  cut.tangent = tangent;
  cut.length = length;
  cut.width = width;
  return cut;
}

using EdgeCounts = std::map<std::pair<int, int>, int>;

EdgeCounts countEdges(const Surface& surface) {
  EdgeCounts edges;
  for (const auto& triangle : surface.triangles)
    for (int i = 0; i < 3; ++i) ++edges[{triangle[i], triangle[(i + 1) % 3]}];
  return edges;
}

/// Edges that do not occur as often as their reverse.
int openEdges(const Surface& surface) {
  const EdgeCounts edges = countEdges(surface);
  int open = 0;
  for (const auto& [edge, count] : edges) {
    const auto reverse = edges.find({edge.second, edge.first});
    open += reverse == edges.end() || reverse->second != count;
  }
  return open;
}

Vec3 areaVector(const std::vector<Vec3>& positions, const std::array<int, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  return (positions[b] - positions[a]).cross(positions[c] - positions[a]) / 2;
}

double area(const Surface& surface, const std::vector<Vec3>& positions, bool cut_face) {
  double sum = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    if (surface.cut_face[t] == cut_face) sum += areaVector(positions, surface.triangles[t]).norm();
  return sum;
}

int numTriangles(const Surface& surface, bool cut_face) {
  return static_cast<int>(std::count(surface.cut_face.begin(), surface.cut_face.end(), cut_face));
}

/// w_p V_e det F_p.
double deformedVolume(const Body& body, const Part& part) {
  const auto& c = part.copies;
  return part.fraction * sixVolumes(body.x[c[0]], body.x[c[1]], body.x[c[2]], body.x[c[3]]) / 6;
}

/// The closed surfaces of the pieces, each by itself.
std::vector<Surface> pieceSurfaces(const Body& body, const Surface& surface) {
  int num_pieces = 0;
  const std::vector<int> piece = body.mesh.copyPieces(&num_pieces);
  std::vector<Surface> pieces(num_pieces);
  for (Surface& one : pieces) one.vertices = surface.vertices;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    pieces[piece[body.mesh.parts()[surface.part[t]].copies[0]]].triangles.push_back(surface.triangles[t]);
  return pieces;
}

void expectClosed(const Surface& surface) { EXPECT_EQ(openEdges(surface), 0); }

void expectVertexOnOnePiece(const Body& body, const Surface& surface) {
  int num_pieces = 0;
  const std::vector<int> piece = body.mesh.copyPieces(&num_pieces);
  for (const SurfaceVertex& vertex : surface.vertices)
    for (int k = 1; k < 4; ++k) ASSERT_EQ(piece[vertex.copies[k]], piece[vertex.copies[0]]);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (int v : surface.triangles[t])
      ASSERT_EQ(piece[surface.vertices[v].copies[0]], piece[body.mesh.parts()[surface.part[t]].copies[0]]);
}

/// Merging points nearer than SAME_POINT moves the surface by far less than 1e-10 of its size.
void expectPartsVolume(const Body& body, const Surface& surface) {
  int num_pieces = 0;
  const std::vector<int> piece = body.mesh.copyPieces(&num_pieces);
  std::vector<double> volume(num_pieces);
  double scale = 0;
  for (const Part& part : body.mesh.parts()) {
    volume[piece[part.copies[0]]] += deformedVolume(body, part);
    scale += std::abs(deformedVolume(body, part));
  }
  const std::vector<Vec3> positions = surfacePositions(surface, body.x);
  const std::vector<Surface> pieces = pieceSurfaces(body, surface);
  for (int i = 0; i < num_pieces; ++i) {
    EXPECT_NEAR(enclosedVolume(pieces[i], positions), volume[i], 1e-10 * scale);
    Vec3 total = Vec3::Zero();
    for (const auto& triangle : pieces[i].triangles) total += areaVector(positions, triangle);
    EXPECT_LT(total.norm(), 1e-10 * scale);
  }
}

/// At rest, every triangle of some area turns away from the centroid of its convex part. Parts thinner than SAME_POINT
/// are flat here, and merging points may tilt a triangle of this area by 1e-5.
void expectOutward(const Body& body, const Surface& surface) {
  const auto& nodes = body.mesh.mesh().nodes;
  std::vector<Vec3> rest;
  for (int c = 0; c < body.mesh.numCopies(); ++c) rest.push_back(nodes[body.mesh.copyNode(c)]);
  const std::vector<Vec3> positions = surfacePositions(surface, rest);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const int part = surface.part[t];
    const Barycentric N = body.mesh.centroid(part);
    Vec3 centroid = Vec3::Zero();
    for (int I = 0; I < 4; ++I) centroid += N[I] * nodes[body.mesh.mesh().elements[body.mesh.parts()[part].element][I]];
    const Vec3 outward = areaVector(positions, surface.triangles[t]);
    if (outward.norm() < 1e-4) continue;
    ASSERT_GT(outward.normalized().dot(positions[surface.triangles[t][0]] - centroid), -1e-5);
  }
}

void expectLaws(const Body& body) {
  const Surface surface = buildSurface(body.mesh);
  expectClosed(surface);
  expectVertexOnOnePiece(body, surface);
  expectPartsVolume(body, surface);
  expectOutward(body, surface);
}

/// Area of a plane's section of the box [0, size], from where the plane meets the box's edges.
double sectionArea(const Vec3& size, const Vec3& point, const Vec3& normal) {
  std::vector<Vec3> corners;
  for (int axis = 0; axis < 3; ++axis)
    for (int edge = 0; edge < 4; ++edge) {
      Vec3 a = Vec3::Zero();
      a[(axis + 1) % 3] = edge & 1 ? size[(axis + 1) % 3] : 0;
      a[(axis + 2) % 3] = edge & 2 ? size[(axis + 2) % 3] : 0;
      const double t = normal.dot(point - a) / normal[axis];
      a[axis] = t;
      if (t >= 0 && t <= size[axis]) corners.push_back(a);
    }
  Vec3 middle = Vec3::Zero();
  for (const Vec3& c : corners) middle += c / static_cast<double>(corners.size());
  const Vec3 n = normal.normalized(), u = n.unitOrthogonal(), v = n.cross(u);
  const auto angle = [&](const Vec3& c) { return std::atan2(v.dot(c - middle), u.dot(c - middle)); };
  std::sort(corners.begin(), corners.end(), [&](const Vec3& a, const Vec3& b) { return angle(a) < angle(b); });
  Vec3 twice = Vec3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i)
    twice += (corners[i] - middle).cross(corners[(i + 1) % corners.size()] - middle);
  return twice.norm() / 2;
}

TEST(Surface, OfAnUncutGridIsItsSkin) {
  const Body body(gridMesh({{3, 4, 5}, Vec3(3, 4, 5), Vec3(100, 0, 0)}));
  const Surface surface = buildSurface(body.mesh);
  EXPECT_EQ(numTriangles(surface, false), 4 * (3 * 4 + 4 * 5 + 5 * 3));
  EXPECT_EQ(numTriangles(surface, true), 0);
  EXPECT_EQ(surface.vertices.size(), 4u * 5 * 6 - 2u * 3 * 4);
  EXPECT_NEAR(area(surface, surfacePositions(surface, body.x), false), 2 * (3 * 4 + 4 * 5 + 5 * 3), 1e-10);
  expectLaws(body);
}

// Each of the cell's six tetrahedra is cut, four in a triangle and two in a quadrilateral. Each of the eight triangles
// on the cell's sides along x becomes a triangle and a quadrilateral.
TEST(Surface, OfACellCutInTwoShowsTheSectionFromBothSides) {
  Body body(gridMesh({}));
  body.cut(plane(Vec3(0.4, 0, 0), Vec3::UnitX()));
  const Surface surface = buildSurface(body.mesh);
  EXPECT_EQ(numTriangles(surface, true), 2 * (4 * 1 + 2 * 2));
  EXPECT_EQ(numTriangles(surface, false), 2 * 2 + 8 * (1 + 2));
  const std::vector<Vec3> positions = surfacePositions(surface, body.x);
  EXPECT_NEAR(area(surface, positions, true), 2, 1e-14);
  EXPECT_NEAR(area(surface, positions, false), 6, 1e-14);
  expectLaws(body);
}

TEST(Surface, OfACutAlongMeshFacesShowsTheFacesFromBothSides) {
  Body body(gridMesh({{2, 3, 1}, Vec3(2, 3, 1), Vec3::Zero()}));
  EXPECT_GT(body.cut(plane(Vec3(1, 0, 0), Vec3::UnitX())).faces_severed, 0);
  const Surface surface = buildSurface(body.mesh);
  EXPECT_EQ(numTriangles(surface, true), 2 * 3 * 2);
  EXPECT_NEAR(area(surface, surfacePositions(surface, body.x), true), 2 * 3, 1e-13);
  expectLaws(body);
}

TEST(Surface, ShowsTwiceTheSectionOfThePlane) {
  Random random(7);
  const Vec3 size(2, 3, 2);
  for (int i = 0; i < 50; ++i) {
    Body body(gridMesh({{2, 3, 2}, size, Vec3::Zero()}));
    const Vec3 point = size / 2 + uniformVector(random, 0.8), normal = uniformVector(random, 1);
    body.cut(plane(point, normal));
    const Surface surface = buildSurface(body.mesh);
    const double expected = 2 * sectionArea(size, point, normal);
    // A node that snaps onto the plane tilts the section of its elements by up to SNAP.
    EXPECT_NEAR(area(surface, surfacePositions(surface, body.x), true), expected, SNAP * expected);
  }
}

TEST(Surface, FollowsEachPieceOnItsOwn) {
  Body body(gridMesh({{2, 2, 2}, Vec3(2, 2, 2), Vec3::Zero()}));
  body.cut(plane(Vec3(0.7, 0, 0), Vec3::UnitX()));
  int num_pieces = 0;
  const std::vector<int> piece = body.mesh.copyPieces(&num_pieces);
  ASSERT_EQ(num_pieces, 2);
  const Surface surface = buildSurface(body.mesh);
  const std::vector<Vec3> before = surfacePositions(surface, body.x);
  for (int c = 0; c < body.mesh.numCopies(); ++c)
    if (piece[c] == 1) body.x[c] += Vec3(5, 0, 0);
  const std::vector<Vec3> after = surfacePositions(surface, body.x);
  for (std::size_t v = 0; v < after.size(); ++v)
    EXPECT_NEAR((after[v] - before[v]).x(), piece[surface.vertices[v].copies[0]] == 1 ? 5 : 0, 1e-14);
}

TEST(Surface, OfThreeCrossingPlanesBoundsEightPieces) {
  Random random(1);
  Body body(jitteredGrid({3, 3, 3}, 0.1, random));
  for (int axis = 0; axis < 3; ++axis) body.cut(plane(Vec3(1.4, 1.6, 1.45), Vec3::Unit(axis) + Vec3(0.1, 0.05, 0.2)));
  int num_pieces = 0;
  body.mesh.copyPieces(&num_pieces);
  ASSERT_EQ(num_pieces, 8);
  body.shake(random, 0.1);
  expectLaws(body);
}

// The neighbours that the crack has not cut must take up its corners on their sides, or they leave a slit.
TEST(Surface, OfARectangleThatEndsInsideIsClosed) {
  Body body(gridMesh({{4, 4, 4}, Vec3(4, 4, 4), Vec3::Zero()}));
  body.cut(rectangle(Vec3(2.3, 0, 2), Vec3::UnitX(), Vec3::UnitY(), 4, 10));
  int num_pieces = 0;
  body.mesh.copyPieces(&num_pieces);
  ASSERT_EQ(num_pieces, 1);
  ASSERT_GT(numTriangles(buildSurface(body.mesh), true), 0);
  Random random(2);
  body.shake(random, 0.1);
  expectLaws(body);
}

// The faces of its neighbours take up hundreds of corners on their sides.
TEST(Surface, OfOneElementCutAHundredTimesIsClosed) {
  Body body(gridMesh({}));
  for (int i = 1; i <= 100; ++i) {
    const PlaneCut slice = plane(Vec3(i / 101.0, 0, 0), Vec3(1, 0.2, 0));
    CrackField crack = planeField(slice, body.mesh, body.x);
    crack.contains = [&](int part, const auto&) { return body.mesh.parts()[part].element == 2; };
    body.mesh.insert(crack);
    body.addNewCopies();
  }
  ASSERT_GT(body.mesh.parts().size(), 100u);
  Random random(3);
  body.shake(random, 0.1);
  expectLaws(body);
}

TEST(Surface, OfWholePlanesHasTwoTrianglesAtEveryEdge) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    Random random(seed);
    Body body(jitteredGrid({3, 2, 2}, 0.15, random));
    for (unsigned i = 0; i <= seed % 4; ++i)
      body.cut(plane(Vec3(1.5, 1, 1) + uniformVector(random, 0.7), uniformVector(random, 1)));
    for (const auto& [edge, count] : countEdges(buildSurface(body.mesh))) EXPECT_EQ(count, 1) << seed;
  }
}

TEST(Surface, HoldsItsLawsAfterRandomPlanesAndRectangles) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Body body(jitteredGrid({3, 2, 2}, seed % 2 ? 0.15 : 0, random));
    for (unsigned i = 0; i <= seed % 5; ++i) {
      const Vec3 point = Vec3(1.5, 1, 1) + uniformVector(random, 0.7), normal = uniformVector(random, 1);
      const Vec3 tangent = uniformVector(random, 1);
      const double length = uniform(random, 0.3, 3), width = uniform(random, 0.3, 3);
      body.cut(random() % 2 ? plane(point, normal) : rectangle(point, normal, tangent, length, width));
      if (seed % 3 == 0) body.shake(random, 0.05);
    }
    body.shake(random, 0.1);
    expectLaws(body);
  }
}

TEST(Surface, HoldsItsLawsAfterCutsThroughNodesEdgesAndFaces) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Body body(gridMesh({{2, 2, 2}, Vec3(2, 2, 2), Vec3::Zero()}));
    for (unsigned i = 0; i <= seed % 4; ++i) {
      const auto direction = [&] { return static_cast<double>(random() % 3) - 1; };
      const Vec3 normal{direction(), direction(), direction()};
      const Vec3 tangent = uniformVector(random, 1);
      if (normal.isZero()) continue;
      const Vec3& node = body.mesh.mesh().nodes[random() % body.mesh.mesh().nodes.size()];
      body.cut(random() % 2 ? plane(node, normal) : rectangle(node, normal, tangent, 1.7, 2.2));
    }
    body.shake(random, 0.1);
    expectLaws(body);
  }
}

// Cuts about a common line, apart by anything from rounding to a thousandth: slivers of every size.
TEST(Surface, HoldsItsLawsAfterCutsAHairApart) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto hair = [&] { return Vec3(std::pow(10, uniform(random, -14, -3)) * uniformVector(random, 1)); };
    Body body(jitteredGrid({2, 2, 2}, seed % 2 ? 0.15 : 0, random));
    const Vec3 point = Vec3(1, 1, 1) + uniformVector(random, 0.6);
    for (unsigned i = 0; i < 2 + seed % 5; ++i) {
      const Vec3 normal = uniformVector(random, 1).cross(Vec3(0.3, 0.5, 0.8));
      body.cut(plane(point + hair(), normal + hair()));
    }
    body.shake(random, 0.1);
    expectLaws(body);
  }
}

}  // namespace
}  // namespace incision

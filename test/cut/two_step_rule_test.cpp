// Which nodes get extended freedoms, after the rule of section 3.1 of the paper, against the copies.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "support/deformed_mesh.h"
#include "support/scenes.h"

namespace incision {
namespace {

using test::DeformedMesh;
using Edge = std::pair<int, int>;

// What one plane or rectangle does to a body at rest, as the paper sees it.
struct PaperCrack {
  std::vector<double> phi;                 // at the nodes
  std::vector<bool> crossed, cut;          // elements that the plane crosses; those whose section is in bounds
  std::map<Edge, std::vector<int>> edges;  // elements round every edge
  std::vector<std::vector<int>> stars;     // elements round every node
};

PaperCrack paperCrack(const TetMesh& mesh, const PlaneCut& plane) {
  PaperCrack crack;
  const Vec3 n = plane.normal.normalized(), t = (plane.tangent - plane.tangent.dot(n) * n).normalized();
  const auto shortest = shortestEdges(mesh);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const double phi = n.dot(mesh.nodes[i] - plane.point);
    crack.phi.push_back(std::abs(phi) < SNAP * shortest[i] ? 0 : phi);
  }
  crack.stars.resize(mesh.nodes.size());
  for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e) {
    const auto& nodes = mesh.elements[e];
    std::vector<Vec3> section;
    double least = 0, most = 0;
    for (int i : nodes) {
      crack.stars[i].push_back(e);
      least = std::min(least, crack.phi[i]);
      most = std::max(most, crack.phi[i]);
      if (crack.phi[i] == 0) section.push_back(mesh.nodes[i]);
    }
    for (const auto& [I, J] : EDGE_NODES) {
      const int i = std::min(nodes[I], nodes[J]), j = std::max(nodes[I], nodes[J]);
      crack.edges[{i, j}].push_back(e);
      const double a = crack.phi[i], b = crack.phi[j];
      if (a * b < 0) section.push_back((b * mesh.nodes[i] - a * mesh.nodes[j]) / (b - a));
    }
    crack.crossed.push_back(least < 0 && most > 0);
    // Triangles with every corner but two, those opposite, cover a quadrilateral twice.
    Vec3 moment = Vec3::Zero();
    double area = 0;
    for (std::size_t i = 0; i < section.size(); ++i)
      for (std::size_t j = i + 1; j < section.size(); ++j)
        for (std::size_t k = j + 1; k < section.size(); ++k) {
          const double a = (section[j] - section[i]).cross(section[k] - section[i]).norm();
          area += a;
          moment += a * (section[i] + section[j] + section[k]) / 3;
        }
    const Vec3 r = area > 0 ? Vec3(moment / area - plane.point) : Vec3::Zero();
    const bool inside = (plane.length == 0 || std::abs(t.dot(r)) <= plane.length / 2) &&
                        (plane.width == 0 || std::abs(n.cross(t).dot(r)) <= plane.width / 2);
    crack.cut.push_back(crack.crossed.back() && inside);
  }
  return crack;
}

// The fringe is every edge point that borders an element which the crack has not cut.
std::set<int> nodesWithExtendedFreedoms(const PaperCrack& crack) {
  std::set<int> nodes;
  std::vector<int> fringe;
  const auto meet = [&](const std::vector<int>& around, std::initializer_list<int> vertices) {
    bool any = false, all = true;
    for (int e : around) {
      any = any || crack.cut[e];
      all = all && (crack.cut[e] || !crack.crossed[e]);
    }
    if (!any) return;  // no point of the crack
    nodes.insert(vertices);
    if (!all) fringe.insert(fringe.end(), vertices);
  };
  for (const auto& [edge, around] : crack.edges)
    if (crack.phi[edge.first] * crack.phi[edge.second] < 0) meet(around, {edge.first, edge.second});
  for (std::size_t i = 0; i < crack.stars.size(); ++i)
    if (crack.phi[i] == 0) meet(crack.stars[i], {static_cast<int>(i)});
  for (int i : fringe) nodes.erase(i);
  return nodes;
}

// Whether the plane's sections round a node hang together. The paper's rule takes for granted that they do; where an
// irregular mesh has none of it, each set of sections is a crack of its own for the node.
bool sectionsHangTogether(const TetMesh& mesh, const PaperCrack& crack, int node) {
  std::vector<int> open;
  for (int e : crack.stars[node])
    if (crack.crossed[e]) open.push_back(e);
  if (open.empty()) return true;
  std::vector<int> found = {open.back()};
  open.pop_back();
  for (std::size_t k = 0; k < found.size(); ++k)
    for (std::size_t i = open.size(); i-- > 0;) {
      // They share a face that holds the node and that the plane crosses, or an edge in the plane.
      int shared = 0, zeros = 0;
      double least = 0, most = 0;
      for (int a : mesh.elements[found[k]])
        for (int b : mesh.elements[open[i]])
          if (a == b) {
            ++shared;
            zeros += crack.phi[a] == 0;
            least = std::min(least, crack.phi[a]);
            most = std::max(most, crack.phi[a]);
          }
      if (zeros < 2 && (shared != 3 || least >= 0 || most <= 0)) continue;
      found.push_back(open[i]);
      open.erase(open.begin() + static_cast<long>(i));
    }
  return open.empty();
}

struct Comparison {
  int nodes = 0, left_out = 0, extended = 0;
};

void compare(const TetMesh& mesh, const PlaneCut& plane, Comparison* done) {
  DeformedMesh body(mesh);
  body.cut(plane);
  const PaperCrack crack = paperCrack(mesh, plane);
  const std::set<int> expected = nodesWithExtendedFreedoms(crack);
  std::vector<int> copies(mesh.nodes.size(), 0);
  for (int c = 0; c < body.mesh.numCopies(); ++c) ++copies[body.mesh.copyNode(c)];
  for (int i = 0; i < static_cast<int>(mesh.nodes.size()); ++i) {
    ++done->nodes;
    if (!sectionsHangTogether(mesh, crack, i)) {
      ++done->left_out;
      continue;
    }
    done->extended += static_cast<int>(expected.count(i));
    EXPECT_EQ(copies[i], 1 + static_cast<int>(expected.count(i))) << "node " << i << ", φ " << crack.phi[i];
  }
}

const GridSettings BOX = {{5, 5, 4}, Vec3(1, 1, 0.8), Vec3::Zero()};

TEST(TwoStepRule, GivesTheCopiesOfAGridForHundredsOfRectangles) {
  test::Random random(40);
  Comparison done;
  for (int run = 0; run < 300 && !::testing::Test::HasFailure(); ++run)
    compare(gridMesh(BOX), random.rectangle(BOX, 0.2, 1.2), &done);
  EXPECT_EQ(done.left_out, 0);
  EXPECT_GT(done.extended, 3000);
}

TEST(TwoStepRule, GivesTheCopiesOfAnIrregularMeshForHundredsOfRectangles) {
  test::Random random(41);
  Comparison done;
  for (int run = 0; run < 300 && !::testing::Test::HasFailure(); ++run)
    compare(test::jitteredGrid(BOX, 0.25, &random), random.rectangle(BOX, 0.2, 1.2), &done);
  EXPECT_LT(done.left_out, done.nodes / 50);
  EXPECT_GT(done.extended, 3000);
}

TEST(TwoStepRule, GivesTheCopiesWhereRectanglesPassThroughNodes) {
  test::Random random(42);
  Comparison done;
  for (int run = 0; run < 300 && !::testing::Test::HasFailure(); ++run) {
    PlaneCut rectangle = random.rectangle(BOX, 0.3, 1.2);
    const TetMesh mesh = gridMesh(BOX);
    // Through three nodes of an element's size, so that it slants through the grid.
    const Vec3 a = 0.2 * Vec3(1 + random.index(4), 1 + random.index(4), 1 + random.index(3));
    rectangle.point = a;
    do rectangle.normal = Vec3(random.index(5) - 2, random.index(5) - 2, 2);
    while (rectangle.normal.head<2>().isZero() || rectangle.normal.cwiseAbs().minCoeff() < 1);
    rectangle.tangent = rectangle.normal.cross(random.direction());
    const PaperCrack crack = paperCrack(mesh, rectangle);
    // Faces in the plane are severed, not split: those are another law.
    bool face_in_plane = false;
    for (const auto& nodes : mesh.elements) {
      int zeros = 0;
      for (int i : nodes) zeros += crack.phi[i] == 0;
      face_in_plane = face_in_plane || zeros >= 3;
    }
    if (!face_in_plane) compare(mesh, rectangle, &done);
  }
  EXPECT_EQ(done.left_out, 0);
  EXPECT_GT(done.extended, 1000);
}

}  // namespace
}  // namespace incision

#include "incision/mesh/tet_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace incision {
namespace {

/// A face of an element, its nodes in ascending order: the lowest one is known by where the face is stored.
struct Face {
  int middle, highest;
  int element;
  int local;
  bool even;  ///< the ascending order runs counter-clockwise seen from outside the element
};

bool sameNodes(const Face& a, const Face& b) { return a.middle == b.middle && a.highest == b.highest; }

/// Face `local` of an element and its lowest node.
std::pair<int, Face> faceOf(const std::array<int, 4>& nodes, int element, int local) {
  std::array<int, 3> n;
  for (int i = 0; i < 3; ++i) n[i] = nodes[FACE_NODES[local][i]];
  bool even = true;
  const auto swapUnlessAscending = [&](int i, int j) {
    if (n[i] < n[j]) return;
    std::swap(n[i], n[j]);
    even = !even;
  };
  swapUnlessAscending(0, 1);
  swapUnlessAscending(1, 2);
  swapUnlessAscending(0, 1);
  return {n[0], Face{n[1], n[2], element, local, even}};
}

[[noreturn]] void failAtFace(int lowest, const Face* first, const Face* last, bool overlap) {
  std::vector<int> elements;
  for (const Face* face = first; face != last; ++face) elements.push_back(face->element);
  throw TopologyError(overlap, {lowest, first->middle, first->highest}, elements);
}

std::string message(bool overlap, const std::array<int, 3>& face, const std::vector<int>& elements) {
  std::string text = "elements ";
  for (int e : elements) text += std::to_string(e) + " ";
  text += overlap ? "overlap: they lie on the same side of" : "share";
  text += " the face of nodes";
  for (int n : face) text += " " + std::to_string(n);
  return text + " (counted from 0)";
}

/// Makes neighbours of the elements at every one of these faces, which have their lowest node in common.
void joinFaces(int lowest, Span<Face> faces, std::vector<std::array<int, 4>>& neighbours) {
  Face *first = faces.begin(), *const last = faces.end();
  std::sort(first, last, [](const Face& a, const Face& b) {
    return std::tie(a.middle, a.highest, a.element) < std::tie(b.middle, b.highest, b.element);
  });
  while (first != last) {
    Face* const next = std::find_if(first, last, [&](const Face& face) { return !sameNodes(face, *first); });
    if (next - first > 2) failAtFace(lowest, first, next, false);
    if (next - first == 2) {
      const Face& a = first[0];
      const Face& b = first[1];
      if (a.even == b.even) failAtFace(lowest, first, next, true);
      neighbours[a.element][a.local] = b.element;
      neighbours[b.element][b.local] = a.element;
    }
    first = next;
  }
}

/// Sorts the faces into buckets by their lowest node, so that only few faces must be compared with each other.
std::vector<std::array<int, 4>> findNeighbours(const TetMesh& mesh) {
  const int n_elements = static_cast<int>(mesh.elements.size());
  Lists<Face> faces;
  faces.sort(static_cast<int>(mesh.nodes.size()), [&](const auto& add) {
    for (int e = 0; e < n_elements; ++e)
      for (int f = 0; f < 4; ++f) {
        const auto [lowest, face] = faceOf(mesh.elements[e], e, f);
        add(lowest, face);
      }
  });

  std::vector<std::array<int, 4>> neighbours(mesh.elements.size(), {-1, -1, -1, -1});
  for (int n = 0; n < faces.count(); ++n) joinFaces(n, faces[n], neighbours);
  return neighbours;
}

}  // namespace

TopologyError::TopologyError(bool overlapping, const std::array<int, 3>& face_nodes, const std::vector<int>& at_face)
    : InputError(message(overlapping, face_nodes, at_face)),
      overlap(overlapping),
      face(face_nodes),
      elements(at_face) {}

MeshTopology buildTopology(const TetMesh& mesh) {
  MeshTopology topology;
  topology.neighbours = findNeighbours(mesh);
  topology.star.sort(static_cast<int>(mesh.nodes.size()), [&](const auto& add) {
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
      for (int n : mesh.elements[e]) add(n, static_cast<int>(e));
  });
  return topology;
}

double sixVolumes(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).dot((c - a).cross(d - a));
}

double elementVolume(const TetMesh& mesh, int e) {
  const auto& n = mesh.elements[e];
  return sixVolumes(mesh.nodes[n[0]], mesh.nodes[n[1]], mesh.nodes[n[2]], mesh.nodes[n[3]]) / 6;
}

std::vector<char> usedNodes(const TetMesh& mesh) {
  std::vector<char> used(mesh.nodes.size(), 0);
  for (const auto& element : mesh.elements)
    for (int n : element) used[n] = 1;
  return used;
}

std::vector<double> shortestEdges(const TetMesh& mesh) {
  std::vector<double> shortest(mesh.nodes.size(), std::numeric_limits<double>::infinity());
  for (const auto& element : mesh.elements) {
    for (const auto& [i, j] : EDGE_NODES) {
      const double length = (mesh.nodes[element[i]] - mesh.nodes[element[j]]).norm();
      for (int n : {element[i], element[j]}) shortest[n] = std::min(shortest[n], length);
    }
  }
  return shortest;
}

}  // namespace incision

#pragma once

#include <array>
#include <string>
#include <vector>

#include "incision/base/input_error.h"
#include "incision/base/lists.h"
#include "incision/base/vec.h"
#include "incision/mesh/physical_group.h"

namespace incision {

/// The mesh as read; it never changes after loading.
struct TetMesh {
  std::vector<Vec3> nodes;                   ///< rest positions X [m]; a node no element uses stays in the list
  std::vector<std::array<int, 4>> elements;  ///< nodes of each tetrahedron, det [X1−X0, X2−X0, X3−X0] > 0
  std::vector<PhysicalGroup> groups = {};    ///< by dimension and number
};

/// Local nodes of the face opposite to local node `f`, counter-clockwise seen from outside the element.
inline constexpr std::array<std::array<int, 3>, 4> FACE_NODES = {{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// Local nodes at the ends of the six edges.
inline constexpr std::array<std::array<int, 2>, 6> EDGE_NODES = {{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// Which elements meet where.
struct MeshTopology {
  /// Element across the face opposite to local node f, or −1 on the boundary.
  std::vector<std::array<int, 4>> neighbours;
  Lists<int> star;  ///< elements round each node, ascending
};

/// Elements that do not fit together at a face they share. The message counts elements and nodes from 0.
class TopologyError : public InputError {
 public:
  /// `overlap`: two that lie on the same side of the face; else more than two have it.
  TopologyError(bool overlap, const std::array<int, 3>& face_nodes, const std::vector<int>& at_face);
  const bool overlap;
  const std::array<int, 3> face;    ///< its nodes, ascending
  const std::vector<int> elements;  ///< all that have the face, ascending
};

/// Throws TopologyError when a face belongs to more than two elements, or to two that lie on the same side of it.
MeshTopology buildTopology(const TetMesh& mesh);

/// Six times the signed volume [m³] of a tetrahedron.
double sixVolumes(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Volume [m³] of element `e`.
double elementVolume(const TetMesh& mesh, int e);

/// Whether an element uses it, for every node.
std::vector<char> usedNodes(const TetMesh& mesh);

/// Shortest edge [m] at each node over the elements that use it; infinity at a node no element uses.
std::vector<double> shortestEdges(const TetMesh& mesh);

}  // namespace incision

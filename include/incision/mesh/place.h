#pragma once

#include <string>
#include <vector>

#include "incision/mesh/rest_box.h"
#include "incision/mesh/tet_mesh.h"

namespace incision {

class YamlMap;

/// Where something is in a body at rest: a physical group of its mesh, or a box.
struct Place {
  Place() = default;
  Place(const RestBox& rest) : box(rest) {}
  Place(const Vec3& min, const Vec3& max) : box{min, max} {}

  RestBox box;
  std::string group = {};    ///< all physical groups of this name; empty: the box
  std::string said_at = {};  ///< source and key of what lies there, for messages
};

/// The keys `group` and `box` of a map, of which it has one. Throws InputError.
Place parsePlace(const YamlMap& map);

// The next three throw InputError, with a guess, where the mesh has no group of this name.

/// Nodes of the group's elements, of whatever dimension, or in the box; ascending.
std::vector<int> nodesAt(const Place& place, const TetMesh& mesh);

/// Elements of groups of volumes, or with their centroids in the box; ascending.
std::vector<int> elementsAt(const Place& place, const TetMesh& mesh);

/// A face of an element, by the local node opposite to it.
struct ElementFace {
  int element, face;
};

/// Faces on the mesh's boundary that are triangles of groups of surfaces or faces of elements of groups of volumes, or
/// with all their nodes in the box; by ascending element.
std::vector<ElementFace> boundaryFacesAt(const Place& place, const TetMesh& mesh, const MeshTopology& topology);

/// What a message calls it: "group 'skin'" or "box [[0, 0, 0], [1, 1, 1]]".
std::string describe(const Place& place);

}  // namespace incision

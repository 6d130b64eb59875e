#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <unordered_map>
#include <vector>

#include "incision/cut/cut_mesh.h"

namespace incision {

/// A crack that can grow: what it needs to go on where it ends.
struct GrowingCrack {
  int number = -1;                          ///< in the mesh; one of them, where several have become one
  std::unordered_map<int, double> phi;      ///< φ [m] at the copies of the parts that it splits
  std::unordered_map<int, double> reached;  ///< when it grew into the elements that it splits [s]; not those of a cut
  std::set<int> refused;                    ///< parts that it met and could not split
};

/// Growing cracks by their numbers in the mesh; those that have become one share what they are.
using GrowingCracks = std::map<int, std::shared_ptr<GrowingCrack>>;

/// A face at which a crack ends inside the material: it splits what lies behind and meets what lies ahead.
struct Fringe {
  int crack;          ///< as the mesh numbers it
  int behind, ahead;  ///< parts that hang together across the face; `behind` is on the crack's positive side
  int face;           ///< of the element ahead, named by the opposite local node
};

/// Every face at which a growing crack ends although it could split the part ahead, in the order of the parts behind.
std::vector<Fringe> findFringes(const CutMesh& mesh, const GrowingCracks& cracks);

/// φ at a part's four copies; empty where the crack has not met them all.
std::optional<Eigen::Vector4d> phiAt(const GrowingCrack& crack, const Part& part);

/// Whether an edge of the facet lies in that face of the part's element.
bool reaches(const Facet& facet, int face, const Polytope& polytope);

/// The face of an element that it shares with another.
int faceTowards(const MeshTopology& topology, int element, int across);

}  // namespace incision

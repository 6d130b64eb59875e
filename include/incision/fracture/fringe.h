#pragma once

#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <vector>

#include "incision/cut/cut_mesh.h"

namespace incision {

/// A crack that can grow: what it needs to go on where it ends.
struct GrowingCrack {
  std::unordered_map<int, double> phi;      ///< φ [m] at the copies of the parts that it splits
  std::unordered_map<int, double> reached;  ///< when it grew into the elements that it splits [s]; not those of a cut
  std::set<int> refused;                    ///< parts that it met and could not split
};

template <class Archive>
void serialize(Archive& archive, GrowingCrack& crack) {
  auto& [phi, reached, refused] = crack;
  archive(phi, reached, refused);
}

/// The cracks that can grow, by their numbers in the mesh. Of two cracks that join one survives, and answers to both
/// numbers from then on, as the mesh keeps them. A plain value: a copy shares nothing with it.
struct GrowingCracks {
  std::map<int, GrowingCrack> cracks;  ///< those that no other one has taken in, by their numbers
  std::map<int, int> taken_in;  ///< by the number of each other one: the number of the crack that it now is part of

  /// The number of the crack that the one with this number now is part of; its own where none has taken it in.
  int survivorOf(int number) const;
  /// The crack with this number in the mesh, or null where it cannot grow.
  const GrowingCrack* find(int number) const;
  /// The crack with this number in the mesh, which can grow.
  const GrowingCrack& at(int number) const { return cracks.at(survivorOf(number)); }
  GrowingCrack& at(int number) { return cracks.at(survivorOf(number)); }
  /// Makes one crack of two that can grow; the one that `number` belongs to survives. The other's φ counts `sense`
  /// times (±1).
  void join(int number, int other, double sense);
};

template <class Archive>
void serialize(Archive& archive, GrowingCracks& all) {
  auto& [cracks, taken_in] = all;
  archive(cracks, taken_in);
}

/// A face at which a crack ends inside the material: it splits what lies behind and meets what lies ahead.
///
///    ┌───────┬───────┐
///    │ behind│ ahead │     ═ the crack, which splits the element behind;
///    ╞═══════╡       │     ╡ the face with the fringe, which the crack reaches
///    │       │       │       and at which it ends
///    └───────┴───────┘
///
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

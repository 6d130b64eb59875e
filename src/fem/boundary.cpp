#include "incision/fem/boundary.h"

#include <algorithm>

#include "incision/fem/owned_face.h"

namespace incision {
namespace {

template <typename Test>
bool allNodes(const std::array<int, 4>& element, const std::array<int, 3>& face, const Test& test) {
  return std::all_of(face.begin(), face.end(), [&](int I) { return test(element[I]); });
}

/// Whether a part owns area of a boundary face, or volume of an element, all of whose nodes move as one clamp:
/// between clamps that move differently the material is not held.
bool ownsClampedMaterial(const CutMesh& mesh, const std::vector<Clamp>& clamps, const std::vector<int>& held_nodes,
                         int clamp, int part) {
  const int e = mesh.parts()[part].element;
  const auto& element = mesh.mesh().elements[e];
  const auto clamped = [&](int node) {
    return held_nodes[node] >= 0 && (held_nodes[node] == clamp || moveAlike(clamps[held_nodes[node]], clamps[clamp]));
  };
  if (std::all_of(element.begin(), element.end(), clamped)) return true;
  for (int f = 0; f < 4; ++f)
    if (mesh.topology().neighbours[e][f] < 0 && allNodes(element, FACE_NODES[f], clamped) &&
        faceShare(ownedFace(mesh, part, f)) > MIN_OVERLAP)
      return true;
  return false;
}

}  // namespace

std::vector<int> heldNodes(const TetMesh& mesh, const std::vector<Clamp>& clamps) {
  std::vector<int> held(mesh.nodes.size(), -1);
  for (std::size_t h = 0; h < clamps.size(); ++h)
    for (int n : nodesAt(clamps[h].place, mesh))
      if (held[n] < 0) held[n] = static_cast<int>(h);
  return held;
}

std::vector<int> heldCopies(const CutMesh& mesh, const std::vector<Clamp>& clamps, const std::vector<int>& held_nodes) {
  std::vector<int> held(mesh.numCopies(), -1);
  for (std::size_t n = 0; n < held_nodes.size(); ++n)
    if (held_nodes[n] >= 0 && mesh.ownCopy(static_cast<int>(n)) >= 0)
      held[mesh.ownCopy(static_cast<int>(n))] = held_nodes[n];
  for (std::size_t p = 0; p < mesh.parts().size(); ++p)
    for (int c : mesh.parts()[p].copies) {
      const int clamp = held_nodes[mesh.copyNode(c)];
      if (clamp >= 0 && held[c] < 0 && ownsClampedMaterial(mesh, clamps, held_nodes, clamp, static_cast<int>(p)))
        held[c] = clamp;
    }
  return held;
}

}  // namespace incision

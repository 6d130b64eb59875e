#pragma once

#include <vector>

#include "incision/base/lists.h"
#include "incision/cut/cut_mesh.h"
#include "incision/fem/regions.h"

namespace incision {

/// Sets of elements round an edge each, some six: the cell of a grid, for one. Returns the cluster of every element.
/// Edges that most elements surround come first, long ones before short ones; what is left over joins its smallest
/// neighbour. No cluster crosses from one region to another.
std::vector<int> edgeClusters(const TetMesh& mesh, const MeshTopology& topology, const Regions& regions);

/// Patches of parts that share one mean dilatation. A linear tetrahedron has one for itself, more of them than a body
/// has freedoms to change its volume by, so tissue of ν near 0.5 locks; a patch has about as many as there are nodes.
///
/// A patch is what hangs together of the parts in one cluster of elements: a crack between them makes two of it.
class Patches {
 public:
  /// A patch that uses a copy, as its copy number `index`.
  struct Use {
    int patch, index;
  };

  /// `mesh` must outlive this.
  Patches(const CutMesh& mesh, const Regions& regions);

  /// Takes over the mesh's parts and copies, of which those round the nodes `touched` have changed; the first call
  /// takes all.
  void topologyChanged(const std::vector<int>& touched);
  /// Forgets what it took over.
  void reset() { patch_of_.clear(); }

  int count() const { return parts_.count(); }
  int of(int part) const { return patch_of_[part]; }
  /// The parts of each patch, ascending.
  const Lists<int>& parts() const { return parts_; }
  /// The copies that the parts of each patch use, each once.
  const Lists<int>& copies() const { return copies_; }
  int numCopies(int patch) const { return copies_[patch].size(); }
  /// Which of its patch's copies corner I of a part uses, the part being number `n` of parts().values().
  int indexOf(int n, int I) const { return corner_index_[4 * n + I]; }
  /// Pairs of copies of all patches before this one; pair (i, j) of patch a is pairStart(a) + i numCopies(a) + j.
  std::size_t pairStart(int patch) const { return pair_start_[patch]; }

  /// The patches that use each copy.
  const Lists<Use>& uses() const { return uses_; }

  /// The nodes of all clusters that have one of the nodes `touched`.
  std::vector<int> nodesBeside(const std::vector<int>& touched) const;

 private:
  std::vector<int> clustersAt(const std::vector<int>& nodes) const;
  void divide(int cluster);
  void number();
  void listCopies();
  void listUses();

  const CutMesh& mesh_;
  std::vector<int> cluster_of_;  // of each element
  Lists<int> elements_;          // of each cluster
  std::vector<int> patch_of_;    // of each part
  int patches_ = 0;
  Lists<int> parts_, copies_;  // of each patch
  std::vector<int> corner_index_;
  std::vector<std::size_t> pair_start_;
  Lists<Use> uses_;
};

}  // namespace incision

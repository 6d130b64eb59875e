#include "incision/fem/patches.h"

#include <algorithm>
#include <numeric>

#include "incision/base/disjoint_sets.h"
#include "incision/base/sort_once.h"

namespace incision {
namespace {

/// Whether two parts of elements that share a face see the same copies of its nodes.
bool hangTogether(const TetMesh& mesh, const Part& p, int face, const Part& q) {
  return std::all_of(FACE_NODES[face].begin(), FACE_NODES[face].end(), [&](int I) {
    const auto& nodes = mesh.elements[q.element];
    const auto J = std::find(nodes.begin(), nodes.end(), mesh.elements[p.element][I]) - nodes.begin();
    return p.copies[I] == q.copies[J];
  });
}

}  // namespace

Patches::Patches(const CutMesh& mesh, const Regions& regions)
    : mesh_(mesh), cluster_of_(edgeClusters(mesh.mesh(), mesh.topology(), regions)) {
  const int clusters = cluster_of_.empty() ? 0 : 1 + *std::max_element(cluster_of_.begin(), cluster_of_.end());
  elements_ = sortedByList(cluster_of_, clusters);
}

void Patches::topologyChanged(const std::vector<int>& touched) {
  const bool first = patch_of_.empty();
  if (first) patches_ = 0;
  patch_of_.resize(mesh_.parts().size(), -1);
  std::vector<int> clusters(elements_.count());
  std::iota(clusters.begin(), clusters.end(), 0);
  for (int cluster : first ? clusters : clustersAt(touched)) divide(cluster);
  number();
  parts_ = sortedByList(patch_of_, patches_);
  listCopies();
  listUses();
}

std::vector<int> Patches::clustersAt(const std::vector<int>& nodes) const {
  std::vector<int> clusters;
  for (int node : nodes)
    for (int element : mesh_.topology().star[node]) clusters.push_back(cluster_of_[element]);
  sortOnce(&clusters);
  return clusters;
}

std::vector<int> Patches::nodesBeside(const std::vector<int>& touched) const {
  std::vector<int> nodes;
  for (int cluster : clustersAt(touched))
    for (int element : elements_[cluster])
      nodes.insert(nodes.end(), mesh_.mesh().elements[element].begin(), mesh_.mesh().elements[element].end());
  sortOnce(&nodes);
  return nodes;
}

/// Sorts the parts of a cluster into new patches.
void Patches::divide(int cluster) {
  std::vector<int> parts;
  for (int element : elements_[cluster])
    for (int p = element; p >= 0; p = mesh_.parts()[p].next) parts.push_back(p);
  std::sort(parts.begin(), parts.end());
  const auto indexOfPart = [&](int p) {
    return static_cast<int>(std::lower_bound(parts.begin(), parts.end(), p) - parts.begin());
  };
  DisjointSets sets(static_cast<int>(parts.size()));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Part& part = mesh_.parts()[parts[i]];
    for (int face = 0; face < 4; ++face) {
      const int across = mesh_.topology().neighbours[part.element][face];
      if (across < part.element || cluster_of_[across] != cluster) continue;
      for (int q = across; q >= 0; q = mesh_.parts()[q].next)
        if (hangTogether(mesh_.mesh(), part, face, mesh_.parts()[q])) sets.join(static_cast<int>(i), indexOfPart(q));
    }
  }
  std::vector<int> set_of;
  const int count = sets.enumerate(&set_of);
  for (std::size_t i = 0; i < parts.size(); ++i) patch_of_[parts[i]] = patches_ + set_of[i];
  patches_ += count;
}

/// Numbers the patches by their first parts: sums over them then round alike, whichever cuts came before which.
void Patches::number() {
  std::vector<int> number_of(patches_, -1);
  patches_ = 0;
  for (int& patch : patch_of_) {
    int& number = number_of[patch];
    if (number < 0) number = patches_++;
    patch = number;
  }
}

void Patches::listCopies() {
  copies_.clear();
  pair_start_.assign(1, 0);
  corner_index_.clear();
  for (int a = 0; a < patches_; ++a) {
    for (int p : parts_[a])
      for (int copy : mesh_.parts()[p].copies) {
        const Span<int> found = copies_.unfinished();
        const auto at = std::find(found.begin(), found.end(), copy);
        corner_index_.push_back(static_cast<int>(at - found.begin()));
        if (at == found.end()) copies_.append(copy);
      }
    copies_.finish();
    const auto count = static_cast<std::size_t>(copies_[a].size());
    pair_start_.push_back(pair_start_.back() + count * count);
  }
}

void Patches::listUses() {
  uses_.sort(mesh_.numCopies(), [&](const auto& add) {
    for (int a = 0; a < patches_; ++a)
      for (int i = 0; i < numCopies(a); ++i) add(copies_[a][i], Use{a, i});
  });
}

}  // namespace incision

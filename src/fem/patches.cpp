#include "incision/fem/patches.h"

#include <algorithm>
#include <numeric>

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

/// Members by the set they belong to: those of set s become members[start[s]] … members[start[s + 1] − 1].
void sortIntoSets(const std::vector<int>& set_of, int sets, std::vector<int>* start, std::vector<int>* members) {
  start->assign(sets + 1, 0);
  for (int set : set_of) ++(*start)[set + 1];
  std::partial_sum(start->begin(), start->end(), start->begin());
  std::vector<int> end(start->begin(), start->end() - 1);
  members->resize(set_of.size());
  for (std::size_t i = 0; i < set_of.size(); ++i) (*members)[end[set_of[i]]++] = static_cast<int>(i);
}

}  // namespace

Patches::Patches(const CutMesh& mesh) : mesh_(mesh), cluster_of_(edgeClusters(mesh.mesh(), mesh.topology())) {
  const int clusters = cluster_of_.empty() ? 0 : 1 + *std::max_element(cluster_of_.begin(), cluster_of_.end());
  sortIntoSets(cluster_of_, clusters, &element_start_, &elements_);
}

void Patches::topologyChanged(const std::vector<int>& touched) {
  const bool first = patch_of_.empty();
  if (first) patches_ = 0;
  patch_of_.resize(mesh_.parts().size(), -1);
  std::vector<int> clusters(element_start_.size() - 1);
  std::iota(clusters.begin(), clusters.end(), 0);
  for (int cluster : first ? clusters : clustersAt(touched)) divide(cluster);
  sortIntoSets(patch_of_, patches_, &part_start_, &parts_);
  listCopies();
  listUses();
}

std::vector<int> Patches::clustersAt(const std::vector<int>& nodes) const {
  const MeshTopology& topology = mesh_.topology();
  std::vector<int> clusters;
  for (int node : nodes)
    for (int s = topology.star_start[node]; s < topology.star_start[node + 1]; ++s)
      clusters.push_back(cluster_of_[topology.star[s]]);
  std::sort(clusters.begin(), clusters.end());
  clusters.erase(std::unique(clusters.begin(), clusters.end()), clusters.end());
  return clusters;
}

std::vector<int> Patches::nodesBeside(const std::vector<int>& touched) const {
  std::vector<int> nodes;
  for (int cluster : clustersAt(touched))
    for (int k = element_start_[cluster]; k < element_start_[cluster + 1]; ++k)
      nodes.insert(nodes.end(), mesh_.mesh().elements[elements_[k]].begin(), mesh_.mesh().elements[elements_[k]].end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// Sorts the parts of a cluster into patches. A patch that was there before keeps its number with its first part.
void Patches::divide(int cluster) {
  std::vector<int> parts;
  for (int k = element_start_[cluster]; k < element_start_[cluster + 1]; ++k)
    for (int p = elements_[k]; p >= 0; p = mesh_.parts()[p].next) parts.push_back(p);
  std::sort(parts.begin(), parts.end());
  const auto indexOfPart = [&](int p) {
    return static_cast<int>(std::lower_bound(parts.begin(), parts.end(), p) - parts.begin());
  };
  std::vector<int> link(parts.size());
  std::iota(link.begin(), link.end(), 0);
  const auto root = [&](int i) {
    while (link[i] != i) i = link[i] = link[link[i]];
    return i;
  };
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Part& part = mesh_.parts()[parts[i]];
    for (int face = 0; face < 4; ++face) {
      const int across = mesh_.topology().neighbours[part.element][face];
      if (across < part.element || cluster_of_[across] != cluster) continue;
      for (int q = across; q >= 0; q = mesh_.parts()[q].next)
        if (hangTogether(mesh_.mesh(), part, face, mesh_.parts()[q]))
          link[root(static_cast<int>(i))] = root(indexOfPart(q));
    }
  }
  std::vector<int> numbers, patch_of_root(parts.size(), -1);
  for (int p : parts) numbers.push_back(patch_of_[p]);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    int& patch = patch_of_root[root(static_cast<int>(i))];
    if (patch < 0) {
      const auto used = std::find(patch_of_root.begin(), patch_of_root.end(), numbers[i]);
      patch = numbers[i] >= 0 && used == patch_of_root.end() ? numbers[i] : patches_++;
    }
    patch_of_[parts[i]] = patch;
  }
}

void Patches::listCopies() {
  copies_.clear();
  copy_start_.assign(1, 0);
  pair_start_.assign(1, 0);
  corner_index_.resize(4 * parts_.size());
  for (int a = 0; a < patches_; ++a) {
    const int first = copy_start_.back();
    for (int n = part_start_[a]; n < part_start_[a + 1]; ++n)
      for (int I = 0; I < 4; ++I) {
        const int copy = mesh_.parts()[parts_[n]].copies[I];
        const auto at = std::find(copies_.begin() + first, copies_.end(), copy);
        corner_index_[4 * n + I] = static_cast<int>(at - copies_.begin()) - first;
        if (at == copies_.end()) copies_.push_back(copy);
      }
    copy_start_.push_back(static_cast<int>(copies_.size()));
    const std::size_t count = copies_.size() - first;
    pair_start_.push_back(pair_start_.back() + count * count);
  }
}

void Patches::listUses() {
  use_start_.assign(mesh_.numCopies() + 1, 0);
  for (int copy : copies_) ++use_start_[copy + 1];
  std::partial_sum(use_start_.begin(), use_start_.end(), use_start_.begin());
  std::vector<int> end(use_start_.begin(), use_start_.end() - 1);
  uses_.resize(copies_.size());
  for (int a = 0; a < patches_; ++a)
    for (int k = copy_start_[a]; k < copy_start_[a + 1]; ++k) uses_[end[copies_[k]]++] = {a, k - copy_start_[a]};
}

}  // namespace incision

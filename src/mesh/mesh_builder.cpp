#include "mesh_builder.h"

#include <algorithm>
#include <string>
#include <utility>

#include "incision/base/limits.h"
#include "limits.h"

namespace incision {

void MeshBuilder::reserveNodes(int count) {
  mesh_.nodes.reserve(count);
  node_of_tag_.reserve(count);
}

void MeshBuilder::reserveElements(int count) {
  mesh_.elements.reserve(count);
  lines_.reserve(count);
  element_tags_.reserve(count);
}

void MeshBuilder::addNode(std::int64_t tag, const Vec3& position) {
  if (position.cwiseAbs().maxCoeff() > MAX_COORDINATE) reader_.fail("coordinates must be within 1e9 m of the origin");
  if (!node_of_tag_.emplace(tag, static_cast<int>(mesh_.nodes.size())).second)
    reader_.fail("node " + std::to_string(tag) + " is given twice");
  mesh_.nodes.push_back(position);
}

void MeshBuilder::addTetrahedron(std::int64_t tag, const std::array<std::int64_t, 4>& node_tags) {
  claimElementTag(tag);
  std::array<int, 4> nodes;
  for (int i = 0; i < 4; ++i) {
    const auto found = node_of_tag_.find(node_tags[i]);
    if (found == node_of_tag_.end())
      reader_.fail("element " + std::to_string(tag) + " uses node " + std::to_string(node_tags[i]) +
                   ", which is not among the nodes");
    nodes[i] = found->second;
    if (std::find(nodes.begin(), nodes.begin() + i, nodes[i]) != nodes.begin() + i)
      reader_.fail("element " + std::to_string(tag) + " uses node " + std::to_string(node_tags[i]) + " twice");
  }

  const auto& [a, b, c, d] = nodes;
  const std::vector<Vec3>& X = mesh_.nodes;
  if (isDegenerate(X[a], X[b], X[c], X[d]))
    reader_.fail("element " + std::to_string(tag) + " is degenerate: it is flat, or smaller than 1e-12 m");
  if (sixVolumes(X[a], X[b], X[c], X[d]) < 0) {
    std::swap(nodes[2], nodes[3]);
    ++repairs_.reoriented;
  }
  mesh_.elements.push_back(nodes);
  lines_.push_back(reader_.line());
}

void MeshBuilder::skipElement(std::int64_t tag) {
  claimElementTag(tag);
  ++repairs_.skipped_elements;
}

TetMesh MeshBuilder::finish(MeshRepairs& repairs) {
  if (mesh_.elements.empty())
    reader_.fail("no four-node tetrahedra (element type 4) among " + std::to_string(repairs_.skipped_elements) +
                 " elements");
  checkDuplicates();
  checkTopology();
  repairs_.unreferenced_nodes = countUnreferencedNodes();
  repairs = repairs_;
  return std::move(mesh_);
}

void MeshBuilder::claimElementTag(std::int64_t tag) {
  if (!element_tags_.insert(tag).second) reader_.fail("element " + std::to_string(tag) + " is given twice");
}

void MeshBuilder::checkDuplicates() const {
  std::vector<std::pair<std::array<int, 4>, int>> sorted;
  sorted.reserve(mesh_.elements.size());
  for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
    sorted.emplace_back(mesh_.elements[e], lines_[e]);
    std::sort(sorted.back().first.begin(), sorted.back().first.end());
  }
  std::sort(sorted.begin(), sorted.end());
  const auto same =
      std::adjacent_find(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first == b.first; });
  if (same != sorted.end())
    reader_.failAt(std::next(same)->second,
                   "the element has the same four nodes as the one in line " + std::to_string(same->second) +
                       " (Gmsh 2.2 files hold an element once for each physical group it is in: save but one)");
}

void MeshBuilder::checkTopology() const {
  try {
    buildTopology(mesh_);
  } catch (const TopologyError& error) {
    reader_.failAt(lines_[error.element], error.what());
  }
}

int MeshBuilder::countUnreferencedNodes() const {
  std::vector<char> used(mesh_.nodes.size(), 0);
  for (const auto& element : mesh_.elements)
    for (int n : element) used[n] = 1;
  return static_cast<int>(std::count(used.begin(), used.end(), 0));
}

}  // namespace incision

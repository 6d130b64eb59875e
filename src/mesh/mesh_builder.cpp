#include "mesh_builder.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "coincident_nodes.h"
#include "incision/base/limits.h"
#include "limits.h"

namespace incision {
namespace {

/// For each element the first one that has the same nodes.
std::vector<int> firstOfSameNodes(const std::vector<std::array<int, 4>>& elements) {
  std::vector<std::pair<std::array<int, 4>, int>> sorted;
  sorted.reserve(elements.size());
  for (const auto& nodes : elements) {
    sorted.emplace_back(nodes, static_cast<int>(sorted.size()));
    std::sort(sorted.back().first.begin(), sorted.back().first.end());
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<int> first(elements.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const bool again = i > 0 && sorted[i].first == sorted[i - 1].first;
    first[sorted[i].second] = again ? first[sorted[i - 1].second] : sorted[i].second;
  }
  return first;
}

}  // namespace

void MeshBuilder::reserveNodes(int count) {
  mesh_.nodes.reserve(count);
  node_numbers_.reserve(count);
  node_of_number_.reserve(count);
}

void MeshBuilder::reserveElements(int count) {
  mesh_.elements.reserve(count);
  lines_.reserve(count);
  element_numbers_.reserve(count);
}

void MeshBuilder::addNode(std::int64_t number, const Vec3& position) {
  if (position.cwiseAbs().maxCoeff() > MAX_COORDINATE) reader_.fail("coordinates must be within 1e9 of the origin");
  if (!node_of_number_.emplace(number, static_cast<int>(mesh_.nodes.size())).second)
    reader_.fail("node " + std::to_string(number) + " is given twice");
  mesh_.nodes.push_back(position);
  node_numbers_.push_back(number);
}

void MeshBuilder::nameGroup(int dimension, int number, const std::string& name) {
  if (!groups_.name(dimension, number, name))
    reader_.fail("physical group " + std::to_string(number) + " of dimension " + std::to_string(dimension) +
                 " has a name already");
}

void MeshBuilder::addTetrahedron(std::int64_t number, const std::vector<std::int64_t>& nodes,
                                 const std::vector<int>& groups) {
  const std::vector<int>& found = findNodes(number, nodes);
  std::array<int, 4> corners = {found[0], found[1], found[2], found[3]};
  for (int i = 0; i < 4; ++i)
    if (std::find(corners.begin(), corners.begin() + i, corners[i]) != corners.begin() + i)
      reader_.fail("element " + std::to_string(number) + " uses node " + std::to_string(nodes[i]) + " twice");

  const auto& [a, b, c, d] = corners;
  const std::vector<Vec3>& X = mesh_.nodes;
  if (isDegenerate(X[a], X[b], X[c], X[d]))
    reader_.fail("element " + std::to_string(number) + " is degenerate: it is flat, or smaller than 1e-12");
  if (sixVolumes(X[a], X[b], X[c], X[d]) < 0) {
    std::swap(corners[2], corners[3]);
    ++repairs_.reoriented;
  }
  if (nodes.size() > 4) ++repairs_.second_order_elements;
  groups_.addTetrahedron(groups, static_cast<int>(mesh_.elements.size()));
  mesh_.elements.push_back(corners);
  element_numbers_.push_back(number);
  lines_.push_back(reader_.line());
}

void MeshBuilder::addToGroups(const GmshElement& kind, std::int64_t number, const std::vector<std::int64_t>& nodes,
                              const std::vector<int>& groups) {
  std::vector<int> corners = findNodes(number, nodes);
  corners.resize(kind.corners);
  if (corners.size() == 3 && (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]))
    reader_.fail("element " + std::to_string(number) + " uses a node twice");
  groups_.addElement(kind.dimension, groups, corners);
}

void MeshBuilder::addOtherVolume(const GmshElement& kind) {
  ++other_volumes_[kind.shape];
  if (other_volume_line_ == 0) other_volume_line_ = reader_.line();
}

TetMesh MeshBuilder::finish(MeshRepairs& repairs) {
  checkVolumes();
  mergeRepeated();
  checkTopology();
  repairs_.unreferenced_nodes = countUnreferencedNodes();
  const CoincidentNodes coincident = findCoincidentNodes(mesh_);
  repairs_.coincident_nodes = coincident.count;
  if (coincident.count > 0)
    repairs_.coincident_pair = {node_numbers_[coincident.pair[0]], node_numbers_[coincident.pair[1]]};
  mesh_.groups = groups_.finish(mesh_);
  repairs = repairs_;
  return std::move(mesh_);
}

const std::vector<int>& MeshBuilder::findNodes(std::int64_t element, const std::vector<std::int64_t>& nodes) {
  found_.clear();
  for (std::int64_t number : nodes) {
    const auto node = node_of_number_.find(number);
    if (node == node_of_number_.end())
      reader_.fail("element " + std::to_string(element) + " uses node " + std::to_string(number) +
                   ", which is not among the nodes");
    found_.push_back(node->second);
  }
  return found_;
}

/// There are tetrahedra, and no other elements with a volume, which would be missing from the body.
void MeshBuilder::checkVolumes() const {
  if (!other_volumes_.empty()) {
    std::string counts;
    for (const auto& [shape, count] : other_volumes_) counts += shape + ": " + std::to_string(count) + ", ";
    reader_.failAt(other_volume_line_, counts +
                                           "the first of them here, but only tetrahedra are simulated (leave Recombine "
                                           "out of the .geo and mesh it again, or split them with the filter "
                                           "Tetrahedralize of ParaView)");
  }
  if (!mesh_.elements.empty()) return;
  reader_.fail("no tetrahedra among " + std::to_string(repairs_.skipped_elements) +
               " elements: did gmsh report errors? (gmsh -3 fills volumes; where there are physical groups it saves "
               "them alone, so one of them must hold the volume)");
}

/// Makes one of tetrahedra of the same nodes: Gmsh 2.2 has an element once for each physical group it is in.
void MeshBuilder::mergeRepeated() {
  const int count = static_cast<int>(mesh_.elements.size());
  const std::vector<int> first = firstOfSameNodes(mesh_.elements);
  std::vector<int> now(count);
  int kept = 0;
  for (int e = 0; e < count; ++e) {
    if (first[e] < e) {
      now[e] = now[first[e]];
      continue;
    }
    mesh_.elements[kept] = mesh_.elements[e];
    element_numbers_[kept] = element_numbers_[e];
    lines_[kept] = lines_[e];
    now[e] = kept++;
  }
  if (kept == count) return;
  repairs_.repeated_elements = count - kept;
  mesh_.elements.resize(kept);
  element_numbers_.resize(kept);
  lines_.resize(kept);
  groups_.renumberElements(now);
}

void MeshBuilder::checkTopology() const {
  try {
    buildTopology(mesh_);
  } catch (const TopologyError& error) {
    const int last = error.elements.back();
    std::string others, face = "the face of nodes";
    for (int n : error.face) face += " " + std::to_string(node_numbers_[n]);
    for (int e : error.elements)
      if (e != last) others += (others.empty() ? "" : " and ") + called(e) + " in line " + std::to_string(lines_[e]);
    reader_.failAt(lines_[last],
                   called(last) + (error.overlap ? " overlaps " + others + ": they lie on the same side of " + face +
                                                       ", as where one is turned inside out"
                                                 : " shares " + face + " with " + others +
                                                       ": a face belongs to one element or two"));
  }
}

/// How messages call a tetrahedron.
std::string MeshBuilder::called(int element) const { return "element " + std::to_string(element_numbers_[element]); }

int MeshBuilder::countUnreferencedNodes() const {
  const std::vector<char> used = usedNodes(mesh_);
  return static_cast<int>(std::count(used.begin(), used.end(), 0));
}

}  // namespace incision

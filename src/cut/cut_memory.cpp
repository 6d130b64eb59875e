// What a memory of a cut mesh must be.
#include <algorithm>
#include <cmath>

#include "incision/base/disjoint_sets.h"
#include "incision/cut/cut_mesh.h"
#include "incision/cut/section.h"

namespace incision {
namespace {

/// How far sums of weights and of shares may be off by rounding, which cuts through cuts add up.
constexpr double ROUNDING = 1e-6;

bool isWeight(double weight) { return -ROUNDING <= weight && weight <= 1 + ROUNDING; }

bool isPoint(const Barycentric& point) {
  return std::all_of(point.data(), point.data() + 4, isWeight) && std::abs(point.sum() - 1) <= ROUNDING;
}

void checkFacet(const Polytope& polytope, const Facet& facet, int cracks) {
  require(facet.corners.size() >= 3, "a facet of a part has less than three corners");
  require(facet.face == -1 ? isOneOf(facet.crack, cracks) : isOneOf(facet.face, 4) && facet.crack == -1,
          "a facet of a part is neither a face of its element nor of a crack");
  for (const int corner : facet.corners) {
    require(isOneOf(corner, static_cast<int>(polytope.corners.size())), "a facet of a part has a corner that is none");
    require(facet.face == -1 || polytope.corners[corner][facet.face] == 0, "a facet of a part lies beside its face");
  }
}

void checkCutPart(const CutPart& part, int cracks) {
  require(part.polytope.corners.size() >= 4 && part.polytope.facets.size() >= 4, "a part is no solid");
  for (const Barycentric& corner : part.polytope.corners) require(isPoint(corner), "a part lies beside its element");
  for (const Facet& facet : part.polytope.facets) checkFacet(part.polytope, facet, cracks);
  require(isPoint(part.centroid), "a part's centroid lies beside its element");
  for (const FaceSide& side : part.face_sides)
    require(isOneOf(side.face, 4) && isOneOf(side.crack, cracks) && (side.side == 1 || side.side == -1),
            "a part is on no side of a crack");
}

/// Copies are in the order in which they were made.
int checkCopies(const CutMesh::Memory& memory, int nodes) {
  const std::size_t count = memory.copy_node.size();
  require(count <= MAX_COPIES && memory.copy_parent.size() == count, "its copies are too many, or have no parents");
  int first = 0;
  while (first < static_cast<int>(count) && memory.copy_parent[first] == first) ++first;
  for (int c = 0; c < static_cast<int>(count); ++c) {
    require(isOneOf(memory.copy_node[c], nodes), "a copy is of no node");
    require(c < first || isOneOf(memory.copy_parent[c], c), "a copy is older than its parent");
    require(memory.copy_node[memory.copy_parent[c]] == memory.copy_node[c], "a copy's parent is of another node");
  }
  return first;
}

/// Each crack has split a part or severed a face.
void checkCracks(const CutMesh::Memory& memory, std::size_t elements) {
  std::size_t most = memory.parts.size() - elements;
  for (const CutPart& part : memory.details) most += part.face_sides.size();
  require(memory.num_cracks >= 0 && static_cast<std::size_t>(memory.num_cracks) <= most, "its cracks are too many");
}

/// Each part is met once, on the way from its element's first.
void checkChains(const std::vector<Part>& parts, int elements) {
  std::vector<char> met(parts.size());
  for (int e = 0; e < elements; ++e) {
    double sum = 0;
    int count = 0;
    for (int p = e; p >= 0; p = parts[p].next) {
      require(!met[p] && parts[p].element == e && (p == e || p >= elements), "a part is not where its element has it");
      met[p] = 1;
      sum += parts[p].fraction;
      require(++count <= MAX_PARTS_PER_ELEMENT, "an element has too many parts");
    }
    require(count == 1 || parts[e].detail >= 0, "a part is whole and not alone in its element");
    require(std::abs(sum - 1) <= ROUNDING, "the parts of an element do not fill it");
  }
  require(std::all_of(met.begin(), met.end(), [](char m) { return m != 0; }), "a part is in no element");
}

}  // namespace

MemoryLimits CutMesh::check(const Memory& memory) const {
  const int nodes = static_cast<int>(mesh_.nodes.size()), elements = static_cast<int>(mesh_.elements.size());
  const std::vector<Part>& parts = memory.parts;
  require(parts.size() >= mesh_.elements.size(), "it has less parts than elements");
  require(memory.own_copy == own_copy_, "the own copies of its nodes are others");
  MemoryLimits limits;
  limits.nodes = nodes;
  limits.elements = elements;
  limits.first_copies = checkCopies(memory, nodes);
  limits.copies = static_cast<int>(memory.copy_node.size());
  for (const int copy : own_copy_) require(copy < limits.first_copies, "the own copy of a node is missing");
  checkCracks(memory, mesh_.elements.size());
  limits.cracks = memory.num_cracks;

  std::vector<char> met(memory.details.size());
  DisjointSets pieces(limits.copies);
  for (const Part& part : parts) {
    require(isOneOf(part.element, elements), "a part is of no element");
    require(part.next == -1 || isOneOf(part.next, static_cast<int>(parts.size())), "a part is followed by none");
    require(part.fraction > 0 && part.fraction <= 1 + ROUNDING, "a part's share of its element is none");
    for (int I = 0; I < 4; ++I) {
      require(
          isOneOf(part.copies[I], limits.copies) && memory.copy_node[part.copies[I]] == mesh_.elements[part.element][I],
          "a part uses copies of other nodes than its element's");
      pieces.join(part.copies[0], part.copies[I]);
    }
    limits.element_of_part.push_back(part.element);
    if (part.detail == -1) continue;
    require(isOneOf(part.detail, static_cast<int>(met.size())) && !met[part.detail], "a part has another one's form");
    met[part.detail] = 1;
  }
  require(std::all_of(met.begin(), met.end(), [](char m) { return m != 0; }), "the form of a part is of none");
  checkChains(parts, elements);
  for (const CutPart& part : memory.details) checkCutPart(part, memory.num_cracks);
  std::vector<int> piece;
  limits.pieces = pieces.enumerate(&piece);
  return limits;
}

void check(const Section& section, const MemoryLimits& limits) {
  require(isOneOf(section.crack, limits.cracks), "a section is of no crack");
  require(isOneOf(section.element, limits.elements), "a section is of no element");
  for (const int part : {section.plus, section.minus})
    require(isOneOf(part, limits.parts()) && limits.element_of_part[part] == section.element,
            "a section is not between parts of its element");
}

}  // namespace incision

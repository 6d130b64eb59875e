#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <unordered_map>

#include "incision/cut/copies.h"
#include "incision/cut/cut_mesh.h"
#include "incision/mesh/input_error.h"

namespace incision {
namespace {

Eigen::Vector4d atCopies(const std::vector<double>& phi, const Part& part) {
  return {phi[part.copies[0]], phi[part.copies[1]], phi[part.copies[2]], phi[part.copies[3]]};
}

bool bothSigns(const std::vector<signed char>& signs) {
  return std::find(signs.begin(), signs.end(), 1) != signs.end() &&
         std::find(signs.begin(), signs.end(), -1) != signs.end();
}

Barycentric inElement(const FacePoint& point, int face) {
  Barycentric b = Barycentric::Zero();
  for (int i = 0; i < 3; ++i) b[FACE_NODES[face][i]] = point[i];
  return b;
}

void sortUnique(std::vector<int>* values) {
  std::sort(values->begin(), values->end());
  values->erase(std::unique(values->begin(), values->end()), values->end());
}

/// How positive a component is at a crack, by its parts that hold the node: the better of two has the higher highest
/// side, or as high a one and the higher lowest.
struct Rank {
  int highest = -2, lowest = 2;  // holds nothing
  void add(int side) {
    highest = std::max(highest, side);
    lowest = std::min(lowest, side);
  }
  bool operator>(const Rank& other) const {
    return highest != other.highest ? highest > other.highest : lowest > other.lowest;
  }
};

}  // namespace

struct CutMesh::SplitPart {
  int part;
  Split halves;
};

struct CutMesh::SeveredPair {
  int part, face, other, other_face;
};

/// All that a crack will do, worked out before anything changes.
struct CutMesh::Plan {
  int crack;
  std::vector<SplitPart> splits;
  std::vector<SeveredPair> severed;  // `part` on the positive side
};

Insertion CutMesh::insert(const CrackField& crack) {
  Insertion done;
  const int number = crack.crack < 0 ? num_cracks_ : crack.crack;
  Plan work = plan(crack, number, &done);
  if (!done.changed()) return done;
  checkLimits(work);
  const int before = numCopies();
  done.touched = apply(std::move(work));
  done.crack = number;
  num_cracks_ = std::max(num_cracks_, number + 1);
  done.copies_added = numCopies() - before;
  return done;
}

CutMesh::Plan CutMesh::plan(const CrackField& crack, int number, Insertion* done) const {
  Plan plan{number, {}, {}};
  double scale = 0;
  const auto visit = [&](auto&& action) {
    if (crack.parts.empty())
      for (std::size_t p = 0; p < parts_.size(); ++p) action(static_cast<int>(p));
    else
      for (int p : crack.parts) action(p);
  };
  visit([&](int p) { scale = std::max(scale, atCopies(crack.phi, parts_[p]).cwiseAbs().maxCoeff()); });
  visit([&](int p) {
    const Eigen::Vector4d phi = atCopies(crack.phi, parts_[p]);
    if (phi.minCoeff() < 0 && phi.maxCoeff() > 0) planSplit(crack, ZERO_PHI * scale, p, &plan, done);
    if ((phi.array() == 0).count() >= 3 && phi.minCoeff() >= 0) planSever(crack, p, &plan);
  });
  done->parts_split = static_cast<int>(plan.splits.size());
  done->faces_severed = static_cast<int>(plan.severed.size());
  return plan;
}

void CutMesh::planSplit(const CrackField& crack, double zero, int part, Plan* plan, Insertion* done) const {
  const Eigen::Vector4d phi = atCopies(crack.phi, parts_[part]);
  const std::vector<signed char> signs = cornerSigns(polytope(part), phi, zero);
  if (!bothSigns(signs)) return;
  std::optional<Split> halves = split(polytope(part), phi, signs, plan->crack);
  if (!halves || coincidesWithCut(part, halves->section, phi)) return;
  if (crack.contains && !crack.contains(part, polygonCentroid(halves->section))) {
    ++done->out_of_bounds;
    return;
  }
  plan->splits.push_back({part, std::move(*halves)});
}

/// Severs `part`, which lies on the positive side of a crack through one of its faces, from what lies across.
void CutMesh::planSever(const CrackField& crack, int part, Plan* plan) const {
  const Eigen::Vector4d phi = atCopies(crack.phi, parts_[part]);
  for (int face = 0; face < 4; ++face) {
    const bool in_crack =
        std::all_of(FACE_NODES[face].begin(), FACE_NODES[face].end(), [&](int I) { return phi[I] == 0; });
    if (!in_crack) continue;
    for (const FacePair& pair : facePairs(parts_[part].element, face)) {
      if (pair.part != part || pair.severed) continue;
      if (atCopies(crack.phi, parts_[pair.other]).minCoeff() >= 0) continue;
      if (crack.contains && !crack.contains(part, inElement(incision::centroid(pair.polygon), face))) continue;
      int back = 0;
      while (topology_.neighbours[parts_[pair.other].element][back] != parts_[part].element) ++back;
      plan->severed.push_back({part, face, pair.other, back});
    }
  }
}

/// Whether a section lies everywhere within snap of one face along which the part was cut before, and that face within
/// snap of the crack: a small section near an edge of the part is close to a face that it crosses at any angle, and the
/// neighbours across must decide alike.
bool CutMesh::coincidesWithCut(int part, const std::vector<Barycentric>& section, const Eigen::Vector4d& phi) const {
  if (parts_[part].detail < 0) return false;
  const std::array<int, 4>& nodes = mesh_.elements[parts_[part].element];
  const auto place = [&](const Barycentric& b) {
    Vec3 X = Vec3::Zero();
    for (int I = 0; I < 4; ++I) X += b[I] * mesh_.nodes[nodes[I]];
    return X;
  };
  double edge = shortest_edge_[nodes[0]];
  for (int I = 1; I < 4; ++I) edge = std::min(edge, shortest_edge_[nodes[I]]);
  const CutPart& cut = detail(part);
  for (const Facet& facet : cut.polytope.facets) {
    const bool severed_face = std::any_of(cut.face_sides.begin(), cut.face_sides.end(),
                                          [&](const FaceSide& side) { return side.face == facet.face; });
    if (facet.face >= 0 && !severed_face) continue;
    const auto corner = [&](std::size_t i) -> const Barycentric& { return cut.polytope.corners[facet.corners[i]]; };
    const Vec3 base = place(corner(0));
    Vec3 normal = Vec3::Zero();
    bool within = true;
    for (std::size_t i = 0; i < facet.corners.size(); ++i) {
      within = within && std::abs(phi.dot(corner(i))) < SNAP * edge;
      if (i >= 2) normal += (place(corner(i - 1)) - base).cross(place(corner(i)) - base);
    }
    normal.stableNormalize();
    for (const Barycentric& b : section) within = within && std::abs(normal.dot(place(b) - base)) < SNAP * edge;
    if (within) return true;
  }
  return false;
}

void CutMesh::checkLimits(const Plan& plan) const {
  std::unordered_map<int, int> added;
  for (const SplitPart& split : plan.splits) ++added[parts_[split.part].element];
  for (const auto& [element, more] : added) {
    int count = more;
    for (int p = element; p >= 0; p = parts_[p].next) ++count;
    if (count > MAX_PARTS_PER_ELEMENT)
      throw InputError("it would cut element " + std::to_string(element) + " into more than " +
                       std::to_string(MAX_PARTS_PER_ELEMENT) + " parts");
  }
  // A split part brings at most four copies, a severed face at most three.
  if (numCopies() + 4.0 * static_cast<double>(plan.splits.size()) + 3.0 * static_cast<double>(plan.severed.size()) >
      MAX_COPIES)
    throw InputError("it could make more than " + std::to_string(MAX_COPIES) + " copies");
}

CutPart& CutMesh::makeDetail(int part) {
  if (parts_[part].detail < 0) {
    parts_[part].detail = static_cast<int>(details_.size());
    const PolytopeMoments m = moments(wholeElement());
    details_.push_back({wholeElement(), m.centroid, m.products, {}});
  }
  return details_[parts_[part].detail];
}

/// Returns the nodes of all parts that are not as they were, ascending.
std::vector<int> CutMesh::apply(Plan&& plan) {
  std::vector<int> nodes;
  std::vector<std::pair<int, int>> sides;  // parts at the new crack, and on which side of it they lie
  const auto touch = [&](int part, int side) {
    sides.emplace_back(part, side);
    const auto& element = mesh_.elements[parts_[part].element];
    nodes.insert(nodes.end(), element.begin(), element.end());
  };
  const auto reshape = [&](int part, Polytope&& polytope) {
    const PolytopeMoments m = moments(polytope);
    CutPart& cut = makeDetail(part);
    cut.polytope = std::move(polytope);
    cut.centroid = m.centroid;
    cut.products = m.products;
    parts_[part].fraction = m.fraction;
  };
  // At once, but still in growing leaps: a stroke adds a few parts in each of many steps.
  const std::size_t needed = details_.size() + 2 * plan.splits.size();
  if (details_.capacity() < needed) details_.reserve(std::max(needed, 2 * details_.capacity()));
  for (SplitPart& split : plan.splits) {
    const int positive = split.part, negative = static_cast<int>(parts_.size());
    std::vector<FaceSide> inherited = makeDetail(positive).face_sides;
    parts_.push_back(parts_[positive]);
    parts_[positive].next = negative;
    parts_[negative].detail = -1;
    makeDetail(negative).face_sides = std::move(inherited);
    reshape(positive, std::move(split.halves.positive));
    reshape(negative, std::move(split.halves.negative));
    touch(positive, 1);
    touch(negative, -1);
  }
  for (const SeveredPair& pair : plan.severed) {
    makeDetail(pair.part).face_sides.push_back({pair.face, plan.crack, 1});
    makeDetail(pair.other).face_sides.push_back({pair.other_face, plan.crack, -1});
    touch(pair.part, 1);
    touch(pair.other, -1);
  }
  sortUnique(&nodes);
  const std::vector<int> reconnected = reconnect(nodes, sides);
  nodes.insert(nodes.end(), reconnected.begin(), reconnected.end());
  sortUnique(&nodes);
  return nodes;
}

/// Gives every component round the nodes a copy of its own. The own copy stays with the component that holds the node
/// and is most positive; an extended copy with its first component. Returns the nodes of parts whose copies changed.
std::vector<int> CutMesh::reconnect(const std::vector<int>& nodes, const std::vector<std::pair<int, int>>& sides) {
  std::vector<int> touched;
  const std::unordered_map<int, int> side_of(sides.begin(), sides.end());
  ComponentFinder finder(*this);
  std::vector<int> old_copy, new_copy, keeper;
  std::vector<Rank> rank;
  for (int node : nodes) {
    const NodeComponents& found = finder.find(node);
    if (found.count == 1) continue;
    old_copy.assign(found.count, -1);
    rank.assign(found.count, Rank());
    for (std::size_t i = 0; i < found.parts.size(); ++i) {
      const int part = found.parts[i], c = found.component[i];
      old_copy[c] = parts_[part].copies[found.local_node[i]];
      if (old_copy[c] != own_copy_[node] || !holdsNode(part, found.local_node[i])) continue;
      const auto side = side_of.find(part);
      rank[c].add(side == side_of.end() ? 0 : side->second);
    }
    keeper.clear();  // the first component of the highest rank, for each old copy
    for (int c = 0; c < found.count; ++c) {
      const auto same = std::find_if(keeper.begin(), keeper.end(), [&](int k) { return old_copy[k] == old_copy[c]; });
      if (same == keeper.end())
        keeper.push_back(c);
      else if (rank[c] > rank[*same])
        *same = c;
    }
    new_copy.resize(found.count);
    for (int c = 0; c < found.count; ++c) {
      new_copy[c] = old_copy[c];
      if (std::find(keeper.begin(), keeper.end(), c) != keeper.end()) continue;
      new_copy[c] = numCopies();
      copy_node_.push_back(node);
      copy_parent_.push_back(old_copy[c]);
    }
    for (std::size_t i = 0; i < found.parts.size(); ++i) {
      int& copy = parts_[found.parts[i]].copies[found.local_node[i]];
      if (copy == new_copy[found.component[i]]) continue;
      copy = new_copy[found.component[i]];
      const auto& element = mesh_.elements[parts_[found.parts[i]].element];
      touched.insert(touched.end(), element.begin(), element.end());
    }
  }
  return touched;
}

}  // namespace incision

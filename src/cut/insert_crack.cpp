#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <unordered_map>

#include "incision/cut/copies.h"
#include "incision/cut/cut_mesh.h"
#include "incision/mesh/input_error.h"
#include "incision/mesh/parallel.h"

namespace incision {
namespace {

/// Parts whose splits a thread plans one after the other.
constexpr int PARTS_TOGETHER = 64;

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

/// A set of nodes, listed in ascending order.
class NodeSet {
 public:
  explicit NodeSet(const TetMesh& mesh) : mesh_(mesh), has_(mesh.nodes.size(), 0) {}
  void addNodesOf(int element) {
    for (int node : mesh_.elements[element]) has_[node] = 1;
  }
  std::vector<int> list() const {
    std::vector<int> nodes;
    for (std::size_t n = 0; n < has_.size(); ++n)
      if (has_[n]) nodes.push_back(static_cast<int>(n));
    return nodes;
  }

 private:
  const TetMesh& mesh_;
  std::vector<char> has_;
};

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
  PolytopeMoments positive, negative;  // of the halves
};

struct CutMesh::SeveredPair {
  int part, face, other, other_face;
};

/// All that a crack will do, worked out before anything changes.
struct CutMesh::Plan {
  int crack;
  std::vector<SplitPart> splits;
  std::vector<SeveredPair> severed;  // `part` on the positive side
  int out_of_bounds = 0;
};

Insertion CutMesh::insert(const CrackField& crack) {
  Insertion done;
  const int number = crack.crack < 0 ? num_cracks_ : crack.crack;
  Plan work = plan(crack, number);
  done.parts_split = static_cast<int>(work.splits.size());
  done.faces_severed = static_cast<int>(work.severed.size());
  done.out_of_bounds = work.out_of_bounds;
  if (!done.changed()) return done;
  checkLimits(work);
  for (const SplitPart& split : work.splits) done.parts.push_back(split.part);
  for (const SeveredPair& pair : work.severed) done.parts.push_back(pair.part);
  const int before = numCopies();
  done.touched = apply(std::move(work));
  done.crack = number;
  num_cracks_ = std::max(num_cracks_, number + 1);
  done.copies_added = numCopies() - before;
  return done;
}

CutMesh::Plan CutMesh::plan(const CrackField& crack, int number) const {
  const int count = static_cast<int>(crack.parts.empty() ? parts_.size() : crack.parts.size());
  const auto partOf = [&](int i) { return crack.parts.empty() ? i : crack.parts[i]; };
  double scale = 0;
  for (int i = 0; i < count; ++i) scale = std::max(scale, atCopies(crack.phi, parts_[partOf(i)]).cwiseAbs().maxCoeff());

  // In chunks, put together in the order of the parts whatever thread has planned them.
  std::vector<Plan> plans((count + PARTS_TOGETHER - 1) / PARTS_TOGETHER, Plan{number, {}, {}, 0});
  parallelFor(static_cast<int>(plans.size()), threads_, [&](int chunk) {
    for (int i = chunk * PARTS_TOGETHER; i < std::min(count, (chunk + 1) * PARTS_TOGETHER); ++i) {
      const Eigen::Vector4d phi = atCopies(crack.phi, parts_[partOf(i)]);
      if (phi.minCoeff() < 0 && phi.maxCoeff() > 0) planSplit(crack, ZERO_PHI * scale, partOf(i), &plans[chunk]);
      if ((phi.array() == 0).count() >= 3 && phi.minCoeff() >= 0) planSever(crack, partOf(i), &plans[chunk]);
    }
  });
  Plan plan{number, {}, {}, 0};
  for (Plan& part : plans) {
    std::move(part.splits.begin(), part.splits.end(), std::back_inserter(plan.splits));
    plan.severed.insert(plan.severed.end(), part.severed.begin(), part.severed.end());
    plan.out_of_bounds += part.out_of_bounds;
  }
  return plan;
}

void CutMesh::planSplit(const CrackField& crack, double zero, int part, Plan* plan) const {
  const Eigen::Vector4d phi = atCopies(crack.phi, parts_[part]);
  const std::vector<signed char> signs = cornerSigns(polytope(part), phi, zero);
  if (!bothSigns(signs)) return;
  std::optional<Split> halves = split(polytope(part), phi, signs, plan->crack);
  if (!halves || coincidesWithCut(part, halves->section, phi)) return;
  if (crack.contains && !crack.contains(part, polygonCentroid(halves->section))) {
    ++plan->out_of_bounds;
    return;
  }
  const PolytopeMoments positive = moments(halves->positive), negative = moments(halves->negative);
  plan->splits.push_back({part, std::move(*halves), positive, negative});
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
      throw InputError("it would cut an element into more than " + std::to_string(MAX_PARTS_PER_ELEMENT) + " parts");
  }
  // A split part brings at most four copies, a severed face at most three.
  if (numCopies() + 4.0 * static_cast<double>(plan.splits.size()) + 3.0 * static_cast<double>(plan.severed.size()) >
      MAX_COPIES)
    throw InputError("it could make more than " + std::to_string(MAX_COPIES) + " copies");
}

/// The part's detail; a new one is empty.
CutPart& CutMesh::makeDetail(int part) {
  if (parts_[part].detail < 0) {
    parts_[part].detail = static_cast<int>(details_.size());
    details_.emplace_back();
  }
  return details_[parts_[part].detail];
}

/// Returns the nodes of all parts that are not as they were, ascending.
std::vector<int> CutMesh::apply(Plan&& plan) {
  NodeSet touched(mesh_);
  std::vector<std::pair<int, int>> sides;  // parts at the new crack, and on which side of it they lie
  const auto touch = [&](int part, int side) {
    sides.emplace_back(part, side);
    touched.addNodesOf(parts_[part].element);
  };
  const auto reshape = [&](int part, Polytope&& polytope, const PolytopeMoments& m) {
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
    reshape(positive, std::move(split.halves.positive), split.positive);
    reshape(negative, std::move(split.halves.negative), split.negative);
    touch(positive, 1);
    touch(negative, -1);
  }
  for (const SeveredPair& pair : plan.severed) {
    for (int part : {pair.part, pair.other})
      if (parts_[part].detail < 0) reshape(part, Polytope(wholeElement()), moments(wholeElement()));
    makeDetail(pair.part).face_sides.push_back({pair.face, plan.crack, 1});
    makeDetail(pair.other).face_sides.push_back({pair.other_face, plan.crack, -1});
    touch(pair.part, 1);
    touch(pair.other, -1);
  }
  for (int part : reconnect(touched.list(), sides)) touched.addNodesOf(parts_[part].element);
  return touched.list();
}

/// Gives every component round the nodes a copy of its own. The own copy stays with the component that holds the node
/// and is most positive; an extended copy with its first component. Returns the parts whose copies changed.
std::vector<int> CutMesh::reconnect(const std::vector<int>& nodes, const std::vector<std::pair<int, int>>& sides) {
  std::vector<int> changed;
  const std::unordered_map<int, int> side_of(sides.begin(), sides.end());
  ComponentFinder finder(*this, nodes);
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
      changed.push_back(found.parts[i]);
    }
  }
  return changed;
}

}  // namespace incision

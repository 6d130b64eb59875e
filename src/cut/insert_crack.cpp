#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "incision/base/input_error.h"
#include "incision/base/parallel.h"
#include "incision/cut/cut_here.h"
#include "incision/cut/cut_mesh.h"

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

}  // namespace

struct CutMesh::SplitPart {
  int part;
  CutPart positive, negative;  // without the face_sides, which they inherit
  double positive_fraction, negative_fraction;
};

struct CutMesh::SeveredPair {
  int part, face, other, other_face;  // `part` on the positive side
};

/// What a crack will do to some of the parts.
struct CutMesh::Plan {
  int crack;
  std::vector<SplitPart> splits;
  std::vector<SeveredPair> severed;
  double severed_area = 0;
  int out_of_bounds = 0;
};

Insertion CutMesh::insert(const CrackField& crack) {
  Insertion done;
  const int number = crack.crack.value_or(num_cracks_);
  std::vector<Plan> plans = plan(crack, number);
  for (const Plan& plan : plans) {
    done.parts_split += static_cast<int>(plan.splits.size());
    done.faces_severed += static_cast<int>(plan.severed.size());
    done.severed_area += plan.severed_area;
    done.out_of_bounds += plan.out_of_bounds;
    for (const SplitPart& split : plan.splits) done.parts.push_back(split.part);
    for (const SeveredPair& pair : plan.severed) done.parts.push_back(pair.part);
  }
  if (!done.changed()) return done;
  checkLimits(plans, done);
  const int before = numCopies();
  done.touched = apply(std::move(plans), done);
  done.crack = number;
  num_cracks_ = std::max(num_cracks_, number + 1);
  done.copies_added = numCopies() - before;
  return done;
}

/// All that the crack will do, worked out before anything changes: in the order of the parts, whatever thread has
/// planned them.
std::vector<CutMesh::Plan> CutMesh::plan(const CrackField& crack, int number) const {
  const int count = static_cast<int>(crack.parts.empty() ? parts_.size() : crack.parts.size());
  const auto partOf = [&](int i) { return crack.parts.empty() ? i : crack.parts[i]; };
  double scale = 0;
  for (int i = 0; i < count; ++i) scale = std::max(scale, atCopies(crack.phi, parts_[partOf(i)]).cwiseAbs().maxCoeff());

  std::vector<Plan> plans((count + PARTS_TOGETHER - 1) / PARTS_TOGETHER, Plan{number, {}, {}, 0, 0});
  parallelFor(static_cast<int>(plans.size()), threads_, [&](int chunk) {
    for (int i = chunk * PARTS_TOGETHER; i < std::min(count, (chunk + 1) * PARTS_TOGETHER); ++i) {
      const Eigen::Vector4d phi = atCopies(crack.phi, parts_[partOf(i)]);
      if (phi.minCoeff() < 0 && phi.maxCoeff() > 0) planSplit(crack, ZERO_PHI * scale, partOf(i), &plans[chunk]);
      if ((phi.array() == 0).count() >= 3 && phi.minCoeff() >= 0) planSever(crack, partOf(i), &plans[chunk]);
    }
  });
  return plans;
}

void CutMesh::planSplit(const CrackField& crack, double zero, int part, Plan* plan) const {
  const Eigen::Vector4d phi = atCopies(crack.phi, parts_[part]);
  const std::vector<signed char> signs = cornerSigns(polytope(part), phi, zero);
  if (!bothSigns(signs)) return;
  std::optional<Split> halves = split(polytope(part), phi, signs, plan->crack);
  if (!halves || coincidesWithCut(part, halves->section, phi)) return;
  if (crack.contains && !crack.contains(part, halves->section)) {
    ++plan->out_of_bounds;
    return;
  }
  const PolytopeMoments positive = moments(halves->positive), negative = moments(halves->negative);
  plan->splits.push_back({part,
                          {std::move(halves->positive), positive.centroid, positive.products, {}},
                          {std::move(halves->negative), negative.centroid, negative.products, {}},
                          positive.fraction,
                          negative.fraction});
}

double CutMesh::faceArea(int element, int face) const {
  std::array<Vec3, 3> X;
  for (int i = 0; i < 3; ++i) X[i] = mesh_.nodes[mesh_.elements[element][FACE_NODES[face][i]]];
  return (X[1] - X[0]).cross(X[2] - X[0]).norm() / 2;
}

/// Severs `part`, which lies on the positive side of a crack through one of its faces, from what lies across.
void CutMesh::planSever(const CrackField& crack, int part, Plan* plan) const {
  const Eigen::Vector4d phi = atCopies(crack.phi, parts_[part]);
  for (int face = 0; face < 4; ++face) {
    const bool in_crack =
        std::all_of(FACE_NODES[face].begin(), FACE_NODES[face].end(), [&](int I) { return phi[I] == 0; });
    if (!in_crack) continue;
    for (const FacePair& pair : facePairs(parts_[part].element, face)) {
      if (pair.part != part || pair.severed_by) continue;
      if (atCopies(crack.phi, parts_[pair.other]).minCoeff() >= 0) continue;
      if (crack.contains && !crack.contains(part, inElement(pair.polygon, face))) continue;
      int back = 0;
      while (topology_.neighbours[parts_[pair.other].element][back] != parts_[part].element) ++back;
      plan->severed.push_back({part, face, pair.other, back});
      plan->severed_area += faceShare(pair.polygon) * faceArea(parts_[part].element, face);
    }
  }
}

/// Whether a section lies along a face of an earlier cut, everywhere within snap: then the crack is that cut.
bool CutMesh::coincidesWithCut(int part, const std::vector<Barycentric>& section, const Eigen::Vector4d& phi) const {
  if (parts_[part].detail < 0) return false;
  double edge = std::numeric_limits<double>::infinity();
  for (int node : mesh_.elements[parts_[part].element]) edge = std::min(edge, shortest_edge_[node]);
  return isCutHere(*this, part, section, phi, SNAP * edge);
}

void CutMesh::checkLimits(const std::vector<Plan>& plans, const Insertion& done) const {
  std::vector<int> added(mesh_.elements.size(), 0);
  for (const Plan& plan : plans)
    for (const SplitPart& split : plan.splits) ++added[parts_[split.part].element];
  for (const Plan& plan : plans)
    for (const SplitPart& split : plan.splits) {
      int& count = added[parts_[split.part].element];
      if (count == 0) continue;  // looked at before
      for (int p = parts_[split.part].element; p >= 0; p = parts_[p].next) ++count;
      if (count > MAX_PARTS_PER_ELEMENT)
        throw InputError("it would cut an element into more than " + std::to_string(MAX_PARTS_PER_ELEMENT) + " parts");
      count = 0;
    }
  // A split part brings at most four copies, a severed face at most three.
  if (numCopies() + 4.0 * done.parts_split + 3.0 * done.faces_severed > MAX_COPIES)
    throw InputError("it could make more than " + std::to_string(MAX_COPIES) + " copies");
}

/// The part's detail, to which sides are to be added; a new one is that of the whole element.
CutPart& CutMesh::makeDetail(int part) {
  if (parts_[part].detail < 0) {
    const PolytopeMoments whole = moments(wholeElement());
    details_.push_back({wholeElement(), whole.centroid, whole.products, {}});
    journal_.keepPart(parts_, part);
    parts_[part].detail = static_cast<int>(details_.size()) - 1;
  } else {
    journal_.keepSides(details_, parts_[part].detail);
  }
  return details_[parts_[part].detail];
}

void CutMesh::apply(SplitPart&& split) {
  const int positive = split.part, negative = static_cast<int>(parts_.size());
  journal_.keepPart(parts_, positive);
  parts_.push_back(parts_[positive]);
  if (parts_[positive].detail < 0) {
    parts_[positive].detail = static_cast<int>(details_.size());
    details_.push_back(std::move(split.positive));
  } else {
    const int detail = parts_[positive].detail;
    split.positive.face_sides = split.negative.face_sides = details_[detail].face_sides;
    journal_.replace(&details_, detail, std::move(split.positive));
  }
  parts_[negative].detail = static_cast<int>(details_.size());
  details_.push_back(std::move(split.negative));
  parts_[positive].next = negative;
  parts_[positive].fraction = split.positive_fraction;
  parts_[negative].fraction = split.negative_fraction;
}

/// Returns the nodes of all parts that are not as they were, ascending.
std::vector<int> CutMesh::apply(std::vector<Plan>&& plans, const Insertion& done) {
  NodeSet touched(mesh_);
  // On which side of the new crack each part lies that touches it.
  std::vector<signed char> side(parts_.size() + static_cast<std::size_t>(done.parts_split), 0);
  const auto touch = [&](int part, signed char at) {
    side[part] = at;
    touched.addNodesOf(parts_[part].element);
  };
  // At once, but still in growing leaps: a stroke adds a few parts in each of many steps.
  const std::size_t needed = details_.size() + 2 * static_cast<std::size_t>(done.parts_split);
  if (details_.capacity() < needed) details_.reserve(std::max(needed, 2 * details_.capacity()));
  for (Plan& plan : plans)
    for (SplitPart& split : plan.splits) {
      const int positive = split.part, negative = static_cast<int>(parts_.size());
      apply(std::move(split));
      touch(positive, 1);
      touch(negative, -1);
    }
  for (const Plan& plan : plans)
    for (const SeveredPair& pair : plan.severed) {
      makeDetail(pair.part).face_sides.push_back({pair.face, plan.crack, 1});
      makeDetail(pair.other).face_sides.push_back({pair.other_face, plan.crack, -1});
      touch(pair.part, 1);
      touch(pair.other, -1);
    }
  for (int part : reconnect(touched.list(), side)) touched.addNodesOf(parts_[part].element);
  return touched.list();
}

}  // namespace incision

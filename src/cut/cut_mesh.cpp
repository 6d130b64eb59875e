#include "incision/cut/cut_mesh.h"

#include <algorithm>
#include <numeric>

#include "incision/base/disjoint_sets.h"

namespace incision {
namespace {

bool oppositeSides(const FaceSide& a, const FaceSide& b) { return a.crack == b.crack && a.side != b.side; }

const FacePolygon WHOLE_FACE = {FacePoint::UnitX(), FacePoint::UnitY(), FacePoint::UnitZ()};

/// What one part owns of a face, with a box round it that tells most parts apart at once.
struct Owned {
  int part;
  FacePolygon polygon;
  FacePoint low, high;

  bool mayMeet(const Owned& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

/// The part's region of a face as weights of the listed local nodes, whose order sets the sense of rotation.
Owned owned(int part, const Polytope& polytope, const Facet& facet, const std::array<int, 3>& nodes, bool reverse) {
  Owned region{part, {}, FacePoint::Ones(), FacePoint::Zero()};
  region.polygon.reserve(facet.corners.size());
  for (int c : facet.corners) {
    const Barycentric& b = polytope.corners[c];
    region.polygon.emplace_back(b[nodes[0]], b[nodes[1]], b[nodes[2]]);
    region.low = region.low.cwiseMin(region.polygon.back());
    region.high = region.high.cwiseMax(region.polygon.back());
  }
  if (reverse) std::reverse(region.polygon.begin(), region.polygon.end());
  return region;
}

}  // namespace

CutMesh::CutMesh(TetMesh mesh, int threads)
    : mesh_(std::move(mesh)), threads_(threads), topology_(buildTopology(mesh_)), shortest_edge_(shortestEdges(mesh_)) {
  own_copy_.assign(mesh_.nodes.size(), -1);
  for (int n = 0; n < topology_.star.count(); ++n) {
    if (topology_.star[n].size() == 0) continue;
    own_copy_[n] = numCopies();
    copy_node_.push_back(n);
  }
  copy_parent_.resize(copy_node_.size());
  std::iota(copy_parent_.begin(), copy_parent_.end(), 0);
  parts_.reserve(mesh_.elements.size() + mesh_.elements.size() / 4);
  for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
    Part part{static_cast<int>(e), {}, 1, -1, -1};
    for (int I = 0; I < 4; ++I) part.copies[I] = own_copy_[mesh_.elements[e][I]];
    parts_.push_back(part);
  }
  reconnect(copy_node_, {});
  std::iota(copy_parent_.begin(), copy_parent_.end(), 0);
}

const Polytope& CutMesh::polytope(int part) const {
  return parts_[part].detail < 0 ? wholeElement() : detail(part).polytope;
}

Barycentric CutMesh::centroid(int part) const {
  return parts_[part].detail < 0 ? Barycentric::Constant(0.25) : detail(part).centroid;
}

bool CutMesh::holdsNode(int part, int local_node) const {
  if (parts_[part].detail < 0) return true;
  const auto& corners = detail(part).polytope.corners;
  return std::any_of(corners.begin(), corners.end(), [&](const Barycentric& b) { return b[local_node] == 1; });
}

std::vector<FacePair> CutMesh::facePairs(int element, int face) const {
  std::vector<FacePair> pairs;
  const int across = topology_.neighbours[element][face];
  if (across < 0) return pairs;
  int back = 0;
  while (topology_.neighbours[across][back] != element) ++back;
  if (isWhole(element) && isWhole(across)) return {{element, across, std::nullopt, WHOLE_FACE}};

  const auto& nodes = FACE_NODES[face];
  std::array<int, 3> same{};  // the face's nodes, as the neighbour numbers them
  for (int i = 0; i < 3; ++i)
    for (int J = 0; J < 4; ++J)
      if (mesh_.elements[across][J] == mesh_.elements[element][nodes[i]]) same[i] = J;
  const auto regions = [this](int e, int f, const std::array<int, 3>& as, bool reverse) {
    std::vector<Owned> found;
    for (int p = e; p >= 0; p = parts_[p].next)
      if (const Facet* facet = polytope(p).onFace(f)) found.push_back(owned(p, polytope(p), *facet, as, reverse));
    return found;
  };
  const std::vector<Owned> here = regions(element, face, nodes, false), there = regions(across, back, same, true);
  for (const Owned& p : here)
    for (const Owned& q : there) {
      if (!p.mayMeet(q)) continue;
      FacePolygon common = overlap(p.polygon, q.polygon);
      if (faceShare(common) > MIN_OVERLAP)
        pairs.push_back({p.part, q.part, severedBy(p.part, face, q.part, back), std::move(common)});
    }
  return pairs;
}

std::optional<int> CutMesh::severedBy(int part, int face, int other, int other_face) const {
  if (parts_[part].detail < 0 || parts_[other].detail < 0) return std::nullopt;
  for (const FaceSide& a : detail(part).face_sides)
    for (const FaceSide& b : detail(other).face_sides)
      if (a.face == face && b.face == other_face && oppositeSides(a, b)) return a.crack;
  return std::nullopt;
}

void CutMesh::mark() noexcept {
  journal_.restart(parts_.size(), details_.size());
  copies_at_mark_ = copy_node_.size();
  cracks_at_mark_ = num_cracks_;
}

void CutMesh::undo() noexcept {
  journal_.undo(&parts_, &details_);
  for (std::vector<int>* of_copies : {&copy_node_, &copy_parent_})
    of_copies->erase(of_copies->begin() + static_cast<std::ptrdiff_t>(copies_at_mark_), of_copies->end());
  num_cracks_ = cracks_at_mark_;
}

void CutMesh::exchange(Memory* memory) noexcept {
  parts_.swap(memory->parts);
  details_.swap(memory->details);
  copy_node_.swap(memory->copy_node);
  copy_parent_.swap(memory->copy_parent);
  own_copy_.swap(memory->own_copy);
  std::swap(num_cracks_, memory->num_cracks);
  mark();
}

std::vector<int> CutMesh::copyPieces(int* num_pieces) const {
  DisjointSets pieces(numCopies());
  for (const Part& part : parts_)
    for (int I = 1; I < 4; ++I) pieces.join(part.copies[0], part.copies[I]);
  std::vector<int> piece_of;
  *num_pieces = pieces.enumerate(&piece_of);
  return piece_of;
}

}  // namespace incision

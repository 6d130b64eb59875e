#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "incision/base/memory_limits.h"
#include "incision/cut/crack.h"
#include "incision/cut/cut_journal.h"
#include "incision/cut/cut_part.h"
#include "incision/cut/face_polygon.h"
#include "incision/mesh/tet_mesh.h"

namespace incision {

/// A node within this share of its shortest edge of a crack lies on the crack. It spares the solver slivers: what a
/// crack cuts off a corner is then at least SNAP³ = 1e-12 of the element, the smallest share measured harmless.
/// Larger values move the crack visibly; smaller ones admit shares that rounding makes meaningless.
inline constexpr double SNAP = 1e-4;

/// φ below this share of its largest magnitude is zero at a part's corner: a thousand times the rounding of φ.
inline constexpr double ZERO_PHI = 1e-13;

/// Parts hang together across a face where they share more than this of its area; less is rounding.
inline constexpr double MIN_OVERLAP = 1e-12;

/// A cut that would leave more parts in one element is refused; far beyond what a scene shows, it bounds the time of
/// a cut, which is quadratic in it.
inline constexpr int MAX_PARTS_PER_ELEMENT = 4096;

/// A cut that could leave more copies is refused: some 100 GB for the solver.
inline constexpr int MAX_COPIES = 10'000'000;

/// Two parts that overlap on a face of the mesh, and where.
struct FacePair {
  int part, other;
  std::optional<int> severed_by;  ///< the crack that runs between them
  FacePolygon polygon;            ///< their overlap, as weights of FACE_NODES of `part`'s element, in that order
};

/// What inserting a crack did.
struct Insertion {
  int crack = -1;  ///< the crack's number, where it changed anything
  int parts_split = 0, faces_severed = 0, copies_added = 0;
  double severed_area = 0;  ///< of the faces, at rest [m²]
  /// Parts that the crack met without splitting them because its section's centroid lies outside the bounds.
  int out_of_bounds = 0;
  std::vector<int> parts;    ///< those on its positive side that were split or severed
  std::vector<int> touched;  ///< nodes of the parts that were split or were given other copies, ascending
  bool changed() const { return parts_split > 0 || faces_severed > 0; }
};

/// The parts of every element and the copies of every node: what cracks have made of a mesh.
///
/// Copies are numbered so that the own copy of a node keeps its number for good; new copies are appended, and so are
/// new parts (the positive half of a split part keeps the part's number).
class CutMesh {
 public:
  /// Works with up to `threads` threads. Throws InputError when a face belongs to more than two elements.
  explicit CutMesh(TetMesh mesh, int threads = 1);

  const TetMesh& mesh() const { return mesh_; }
  const MeshTopology& topology() const { return topology_; }
  const std::vector<Part>& parts() const { return parts_; }
  const CutPart& detail(int part) const { return details_[parts_[part].detail]; }
  int numCracks() const { return num_cracks_; }
  int threads() const { return threads_; }
  void setThreads(int threads) { threads_ = threads; }
  /// Whether no crack has met an element.
  bool isWhole(int element) const { return parts_[element].detail < 0; }

  const Polytope& polytope(int part) const;
  Barycentric centroid(int part) const;
  bool holdsNode(int part, int local_node) const;

  int numCopies() const { return static_cast<int>(copy_node_.size()); }
  int copyNode(int copy) const { return copy_node_[copy]; }
  /// The copy a new copy was made from; its own number for a copy that was there at loading.
  int copyParent(int copy) const { return copy_parent_[copy]; }
  /// −1 for a node that no element uses.
  int ownCopy(int node) const { return own_copy_[node]; }
  /// Shortest rest edge [m] at a node.
  double shortestEdge(int node) const { return shortest_edge_[node]; }

  /// Every pair of parts that overlap on `face` of `element`, seen from `element`; none on the boundary.
  std::vector<FacePair> facePairs(int element, int face) const;

  /// Splits parts, severs faces and adds copies as the crack asks. A new crack that changes nothing is not counted.
  /// Throws InputError, with nothing changed, when the result would pass MAX_PARTS_PER_ELEMENT or MAX_COPIES.
  Insertion insert(const CrackField& crack);

  /// From here on changes can be undone.
  void mark() noexcept;
  /// Puts the mesh back as it was at the last mark, without memory from the heap: what has changed it may have been
  /// broken off anywhere.
  void undo() noexcept;

  /// What cracks have made of the mesh; all else follows from the mesh as read.
  struct Memory {
    std::vector<Part> parts;
    std::vector<CutPart> details;
    std::vector<int> copy_node, copy_parent, own_copy;
    int num_cracks = 0;
  };
  Memory keep() const { return {parts_, details_, copy_node_, copy_parent_, own_copy_, num_cracks_}; }
  /// Throws InputError where a memory cannot be one of this mesh. Returns what other memories that go with it number,
  /// but for regions.
  MemoryLimits check(const Memory& memory) const;
  /// Puts what was kept of this mesh in the place of what it is, which `memory` then holds, and marks it.
  void exchange(Memory* memory) noexcept;

  /// The piece of every copy: pieces are numbered from 0 in the order of their lowest copy.
  std::vector<int> copyPieces(int* num_pieces) const;

 private:
  struct SplitPart;
  struct SeveredPair;
  struct Plan;

  std::vector<Plan> plan(const CrackField& crack, int number) const;
  void planSplit(const CrackField& crack, double zero, int part, Plan* plan) const;
  void planSever(const CrackField& crack, int part, Plan* plan) const;
  double faceArea(int element, int face) const;
  void checkLimits(const std::vector<Plan>& plans, const Insertion& done) const;
  std::optional<int> severedBy(int part, int face, int other, int other_face) const;
  bool coincidesWithCut(int part, const std::vector<Barycentric>& section, const Eigen::Vector4d& phi) const;
  void apply(SplitPart&& split);
  std::vector<int> apply(std::vector<Plan>&& plans, const Insertion& done);
  CutPart& makeDetail(int part);
  std::vector<int> reconnect(const std::vector<int>& nodes, const std::vector<signed char>& side);

  TetMesh mesh_;
  int threads_;
  MeshTopology topology_;
  std::vector<double> shortest_edge_;
  std::vector<Part> parts_;
  std::vector<CutPart> details_;
  std::vector<int> copy_node_, copy_parent_, own_copy_;
  int num_cracks_ = 0;
  CutJournal journal_;
  std::size_t copies_at_mark_ = 0;
  int cracks_at_mark_ = 0;
};

template <class Archive>
void serialize(Archive& archive, CutMesh::Memory& memory) {
  auto& [parts, details, copy_node, copy_parent, own_copy, num_cracks] = memory;
  archive(parts, details, copy_node, copy_parent, own_copy, num_cracks);
}

}  // namespace incision

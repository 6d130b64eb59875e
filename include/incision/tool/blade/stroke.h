#pragma once

#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "incision/base/memory_limits.h"
#include "incision/cut/mesh_door.h"
#include "incision/tool/blade/swept_triangles.h"
#include "incision/tool/blade/ties.h"
#include "incision/tool/near_parts.h"

namespace incision {

/// A crack that grows as a blade's edge sweeps through the body. What the edge sweeps is reckoned in the material: from
/// the line of the tissue at which it stood last, wherever that has moved to, to the line at which it stands now. So a
/// blade that stands still in moving tissue cuts too. The crack keeps its distances at the copies of parts it has
/// split, and takes its direction from the way of the last element: the cut face is smooth however slow or fast
/// the blade moves. It keeps its whole sweep so far, carried along in the elements' own coordinates.
///
/// Where the edge comes upon its own crack at an angle, or turns a corner, the stroke goes on as a new crack.
///
/// Several edges may make one stroke, as those of scissors, which come towards each other: what each sweeps is of one
/// crack, so that they meet.
class Stroke {
 public:
  /// Without `progressive` it cuts elements whole, and nothing of them is tied. `near` must outlive this.
  Stroke(bool progressive, NearParts* near) : progressive_(progressive), near_(near) {}

  /// Another stroke begins with the next start.
  void restart();

  /// The edges stand here while the copies stand at `x` [m], and have not swept anything yet. Without meaning once one
  /// has.
  void start(const std::vector<Edge>& edges, const std::vector<Vec3>& x);

  /// The edges go on from the start without having swept anything; what they sweep next counts from there.
  void stand();

  /// Where an edge stood last, as it was then; unless none has swept anything, or stood.
  const Edge* lastEdge(std::size_t edge) const { return memory_.stands.empty() ? nullptr : &memory_.stands[edge].edge; }

  /// Adds what an edge sweeps from where it stood last to `to`, while the copies stand at `x` [m], and cuts the parts
  /// whose section the sweep so far has entered; without progressive ties those whose section's centroid it covers.
  /// Needs a start. Throws InputError, with the mesh unchanged, at the mesh's limits.
  Insertion sweep(std::size_t edge, const Edge& to, const std::vector<Vec3>& x, const Materials& materials,
                  MeshDoor* door, Ties* ties);

  /// An edge has come out of the body where it last was, by the motion `way` of its two ends [m], while the copies
  /// stand at `x` [m]. A crack that is one plane in each element comes through the skin beside the place where the edge
  /// does, and what of it lies farther on is cut as if the edge had gone on so. The stroke is to end with this.
  Insertion leave(std::size_t edge, const Edge& way, const std::vector<Vec3>& x, const Materials& materials,
                  MeshDoor* door, Ties* ties);

  /// Whether the stroke has met any part of the body.
  bool begun() const { return memory_.begun; }

  /// The crack that it goes on with, unless it has none yet, or none any more.
  std::optional<int> crack() const { return memory_.crack; }

  /// Cracks that it has made.
  int cracks() const { return memory_.cracks; }

  /// From the crack at a copy; settled once a part that uses the copy is split.
  struct Distance {
    double phi = 0;              // [m]
    Vec3 normal = Vec3::Zero();  // when it was measured
    bool settled = false;
  };

  /// Where an edge was at its last sweep.
  struct Stand {
    Edge edge = {Vec3::Zero(), Vec3::Zero()};  ///< [m],
    std::vector<Vec3> x;                       ///< and the copies then [m]
  };

  /// What of the stroke outlasts a step.
  struct Memory {
    std::optional<int> crack;                       ///< as crack() tells
    int cracks = 0;                                 ///< that it has made
    bool begun = false;                             ///< it has met a part of the body
    std::vector<Stand> stands;                      ///< of each edge; none: none has swept anything
    Vec3 normal = Vec3::Zero();                     ///< of the sweep so far, to keep the sides' signs
    std::unordered_map<int, Vec3> ways;             ///< round each copy: normals of the last sweeps [m]
    std::unordered_map<int, Distance> distances;    ///< of the copies of parts the sweep has passed
    std::unordered_map<int, SweptTriangles> swept;  ///< so far, in each element it met
  };
  const Memory& keep() const { return memory_; }
  void recall(const Memory& memory) {
    memory_ = memory;
    forgetLook();
  }

 private:
  /// A part that the current sweep passes.
  struct Passed {
    int part;
    bool within = false;                 // not only near
    std::array<Barycentric, 4> corners;  // of the sweep, in the element
    Vec3 normal = Vec3::Zero();          // of the sweep there, as long as the edge moved [m]
  };

  Insertion cut(const Materials& materials, MeshDoor* door, Ties* ties);
  bool record(const Stand& last, const Edge& to, const std::vector<Vec3>& x, const CutMesh& mesh);
  void keepTriangles(const CutMesh& mesh);
  void findHeadings(const CutMesh& mesh);
  void turnAlike();
  double distanceNow(int copy, const Edge& to, const std::vector<Vec3>& x) const;
  bool crossesItself(const Edge& to, const std::vector<Vec3>& x, const CutMesh& mesh) const;
  void measure(const Edge& to, const std::vector<Vec3>& x, const CutMesh& mesh);
  void forgetLook();
  std::vector<int> toLookAt(const CutMesh& mesh) const;
  CrackField field(const CutMesh& mesh) const;
  bool covers(const Part& part, const std::vector<Barycentric>& polygon, const std::vector<double>& phi) const;
  void settle(const Insertion& done, int before, const CutMesh& mesh);

  bool progressive_;
  NearParts* near_;
  Memory memory_;
  std::vector<Edge> start_edges_;  // where the first sweep of each starts [m]
  std::vector<Vec3> start_x_;      // and the copies then [m]
  // Of the current sweep:
  std::map<int, Vec3> headings_;  // of the copies passed: the crack's normal; sorted, as they are summed up
  std::unordered_map<int, std::vector<SweptTriangle>> just_swept_;
  std::vector<Passed> passed_, beside_;  // parts that it passes, and cut ones that it passes farther off
  // Since the crack was last inserted, unless all that was swept is to be looked at:
  std::vector<int> swept_since_;     // elements of the parts passed,
  std::vector<int> measured_since_;  // and copies whose distances were measured
  std::size_t known_parts_ = 0;      // that the mesh had then; 0: all is to be looked at
};

template <class Archive>
void serialize(Archive& archive, Stroke::Memory& memory) {
  auto& [crack, cracks, begun, stands, normal, ways, distances, swept] = memory;
  archive(crack, cracks, begun, stands, normal, ways, distances, swept);
}

void check(const Stroke::Memory& memory, const MemoryLimits& limits);

template <class Archive>
void serialize(Archive& archive, Stroke::Stand& stand) {
  auto& [edge, x] = stand;
  archive(edge, x);
}

template <class Archive>
void serialize(Archive& archive, Stroke::Distance& distance) {
  auto& [phi, normal, settled] = distance;
  archive(phi, normal, settled);
}

}  // namespace incision

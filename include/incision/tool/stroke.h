#pragma once

#include <array>
#include <deque>
#include <unordered_map>
#include <vector>

#include "incision/cut/cut_mesh.h"
#include "incision/tool/blade.h"

namespace incision {

/// One crack that grows as a blade's edge sweeps through the body. What the edge sweeps is reckoned in the material:
/// from the line of the tissue at which it stood last, wherever that has moved to, to the line at which it stands now.
/// The crack keeps its distances at the copies of parts it has split, so the cut face has no steps, and its whole sweep
/// so far, carried along in the elements' own coordinates.
class Stroke {
 public:
  /// The edge has not swept anything yet, and the copies stand at `x` [m] now. Later calls do nothing.
  void start(const std::vector<Vec3>& x) {
    if (last_x_.empty()) last_x_ = x;
  }

  /// Adds what the edge sweeps from `from`, where it stood at the last sweep, to `to`, while the copies stand at `x`
  /// [m], and cuts the parts whose section's centroid the sweep so far covers. Throws InputError, with the mesh
  /// unchanged, at the mesh's limits.
  Insertion sweep(const Edge& from, const Edge& to, const std::vector<Vec3>& x, CutMesh* mesh);

  /// Whether the stroke has met any part of the body.
  bool begun() const { return begun_; }

 private:
  using Triangle = std::array<Barycentric, 3>;

  /// From the crack at a copy; settled once a part that uses the copy is split.
  struct Distance {
    double phi = 0;  // [m]
    bool settled = false;
  };

  void record(const Edge& from, const Edge& to, const std::vector<Vec3>& x, const CutMesh& mesh);
  void turnAlike();
  void measure(const Edge& to, const std::vector<Vec3>& x, const CutMesh& mesh);
  CrackField field(const CutMesh& mesh) const;
  bool covers(const Part& part, const Barycentric& point, const std::vector<double>& phi) const;

  int crack_ = -1;
  bool begun_ = false;
  std::vector<Vec3> last_x_;                             // the copies' positions at the last sweep [m]
  Vec3 normal_ = Vec3::Zero();                           // of the last sweep as a whole, to keep the sides' signs
  std::unordered_map<int, Distance> distances_;          // of the copies of parts the sweep has passed
  std::unordered_map<int, std::deque<Triangle>> swept_;  // the sweep so far in each element it met
  std::vector<int> met_;                                 // parts that the current sweep passes,
  std::vector<Vec3> met_normal_;                         // and its normal there, as long as the edge moved [m]
};

/// Whether an edge passes through an element the body now has, its parts taken whole.
bool touches(const Edge& edge, const std::vector<Vec3>& x, const CutMesh& mesh);

}  // namespace incision

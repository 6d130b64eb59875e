#pragma once

#include <array>
#include <deque>
#include <unordered_map>
#include <vector>

#include "incision/cut/cut_mesh.h"
#include "incision/tool/blade.h"

namespace incision {

/// One crack that grows as a blade's edge sweeps through the body. It keeps its distances at the copies of parts it has
/// split, so the cut face has no steps, and its whole sweep so far, carried along in the elements' own coordinates.
class Stroke {
 public:
  /// Adds the surface the edge sweeps from `from` to `to` while the copies stand at `x` [m], and cuts the parts whose
  /// section's centroid the sweep so far covers. Throws InputError, with the mesh unchanged, at the mesh's limits.
  Insertion sweep(const Edge& from, const Edge& to, const std::vector<Vec3>& x, CutMesh* mesh);

  /// Whether the stroke has met any part of the body.
  bool begun() const { return begun_; }

 private:
  using Triangle = std::array<Barycentric, 3>;
  using ElementEdge = std::array<Barycentric, 2>;

  /// The sweep as one element's material saw it.
  struct Swept {
    std::deque<Triangle> triangles;
    ElementEdge edge;  // where the last sweep left it
    int last_sweep = -1;
    void add(const ElementEdge& start, const ElementEdge& end);
  };

  void record(const Edge& from, const Edge& to, const std::vector<Vec3>& x, const CutMesh& mesh);
  CrackField field(const Edge& from, const Edge& to, const std::vector<Vec3>& x, const CutMesh& mesh) const;
  bool covers(const Part& part, const Barycentric& point, const std::vector<double>& phi) const;

  int crack_ = -1;
  Vec3 normal_ = Vec3::Zero();            // of the last sweep, to keep the sides' signs
  std::unordered_map<int, double> phi_;   // distances at the copies the stroke owns [m]
  std::unordered_map<int, Swept> swept_;  // of each element near the sweep
  int sweeps_ = 0;
  bool begun_ = false;
  std::vector<int> met_;  // parts the current sweep may cut
};

/// Whether an edge passes through an element the body now has, its parts taken whole.
bool touches(const Edge& edge, const std::vector<Vec3>& x, const CutMesh& mesh);

}  // namespace incision

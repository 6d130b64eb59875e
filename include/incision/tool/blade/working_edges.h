#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "incision/base/memory_limits.h"
#include "incision/cut/cut_result.h"
#include "incision/tool/blade/cutting_edge.h"
#include "incision/tool/blade/stroke.h"
#include "incision/tool/tool_report.h"

namespace incision {

/// What is known of a tool's strokes.
struct StrokesMemory {
  CutResult under_way;
  double area = 0;       ///< cut by the stroke under way [m²]
  double last_area = 0;  ///< by the last stroke that ended [m²]
};

template <class Archive>
void serialize(Archive& archive, StrokesMemory& memory) {
  auto& [under_way, area, last_area] = memory;
  archive(under_way, area, last_area);
}

/// What of a tool's edges outlasts a step, but for what their couplers keep.
struct WorkingEdgesMemory {
  StrokesMemory strokes;
  Stroke::Memory stroke;
};

template <class Archive>
void serialize(Archive& archive, WorkingEdgesMemory& memory) {
  auto& [strokes, stroke] = memory;
  archive(strokes, stroke);
}

void check(const WorkingEdgesMemory& memory, const MemoryLimits& limits);

/// The cutting edges of a tool at their work. What they sweep in a step is cut after it, in the material; so an edge at
/// rest cuts tissue that moves. Their crack, which is one, opens as they sweep it, and what they have not cut yet
/// resists.
class WorkingEdges {
 public:
  /// `label`: what reports of their strokes call them. All others must outlive this.
  WorkingEdges(std::string label, const std::vector<EdgeOfTool>& edges, bool progressive, ToolInStep* tool, Ties* ties,
               NearParts* near, const Materials& materials, const CutMesh& mesh);

  const std::vector<EdgeOfTool>& edges() const { return edges_; }

  /// A step starts with the tool's groups where they are in it, and the copies at `x` [m].
  void start(const std::vector<Vec3>& x);

  /// The groups have gone along these ways, one of each, from their first poses, evenly in a step of `time_step` [s]
  /// that ended with `motion`. Returns the stroke that ended with that.
  std::optional<CutResult> act(const std::vector<std::vector<Pose>>& ways, double time_step, const Motion& motion,
                               MeshDoor* door);

  /// The stroke ends. Returns what became of it, if it cut anything.
  std::optional<CutResult> interrupt();

  /// As Tool::scaleCuttingForce.
  void scaleCuttingForce(double factor);

  /// Adds what they did in the step taken last.
  void addTo(ToolReport* report) const;

  /// Adds what acts between them and the tissue.
  void addCouplers(std::vector<Coupler*>* list);

  void keepIn(WorkingEdgesMemory* kept) const {
    kept->strokes = strokes_;
    kept->stroke = stroke_.keep();
  }
  void recall(const WorkingEdgesMemory& memory);

 private:
  Edge at(std::size_t edge, const Pose& pose) const { return placed(edges_[edge].edge, pose); }
  bool holdsBack(std::size_t edge, const Edge& to, const std::vector<Vec3>& x, const CutMesh& mesh) const;
  void sweep(std::size_t edge, const Edge& to, const std::vector<Vec3>& x, MeshDoor* door);
  template <typename Cut>
  void record(const Cut& cut);

  std::string label_;
  std::vector<EdgeOfTool> edges_;
  ToolInStep* tool_;
  const Materials& materials_;
  Ties& ties_;
  NearParts& near_;
  Stroke stroke_;
  std::deque<CuttingEdge> resistances_;  // of each edge; they stay where they are
  StrokesMemory strokes_;
  // Kept for their memory:
  std::vector<Edge> starts_;     // of the edges in a step [m]
  std::vector<Vec3> x_within_;   // of the copies within a step [m]
  std::vector<char> held_back_;  // of the edges in a step
};

}  // namespace incision

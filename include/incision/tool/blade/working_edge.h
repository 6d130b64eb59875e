#pragma once

#include <optional>
#include <string>
#include <vector>

#include "incision/cut/cut_result.h"
#include "incision/tool/blade/cutting_edge.h"
#include "incision/tool/blade/stroke.h"
#include "incision/tool/tool_report.h"

namespace incision {

/// What is known of an edge's strokes.
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

/// What of an edge outlasts a step, but for what its coupler keeps.
struct WorkingEdgeMemory {
  StrokesMemory strokes;
  Stroke::Memory stroke;
};

template <class Archive>
void serialize(Archive& archive, WorkingEdgeMemory& memory) {
  auto& [strokes, stroke] = memory;
  archive(strokes, stroke);
}

/// A cutting edge of a tool at its work. What it sweeps in a step is cut after it, in the material; so an edge at rest
/// cuts tissue that moves. Its crack opens as it sweeps it, and what it has not cut yet resists.
class WorkingEdge {
 public:
  /// `label`: what reports of its strokes call it. The tool, the ties, the materials and the mesh must outlive this.
  WorkingEdge(std::string label, const EdgeOfTool& edge, bool progressive, ToolInStep* tool, Ties* ties,
              const Materials& materials, const CutMesh& mesh);

  const Edge& edge() const { return edge_; }

  /// The edge's group stands there when a step starts with the copies at `x` [m].
  void start(const Pose& pose, const std::vector<Vec3>& x) { stroke_.start(placed(edge_, pose), x); }

  /// The group has gone along `way`, from its first pose, evenly in a step of `time_step` [s] that ended with `motion`.
  /// Returns the stroke that ended with that.
  std::optional<CutResult> act(const std::vector<Pose>& way, double time_step, const Motion& motion, MeshDoor* door);

  /// Its stroke ends. Returns what became of it, if it cut anything.
  std::optional<CutResult> interrupt();

  /// Whether a stroke has met the body and not ended.
  bool cuts() const { return stroke_.begun(); }

  /// Adds what it did in the step taken last.
  void addTo(ToolReport* report) const;

  CuttingEdge* coupler() { return &resistance_; }

  WorkingEdgeMemory keep() const { return {strokes_, stroke_.keep()}; }
  void recall(const WorkingEdgeMemory& memory);

 private:
  void sweep(const Edge& to, const std::vector<Vec3>& x, MeshDoor* door);
  template <typename Cut>
  void record(const Cut& cut);

  std::string label_;
  Edge edge_;
  const Materials& materials_;
  Ties& ties_;
  Stroke stroke_;
  CuttingEdge resistance_;
  StrokesMemory strokes_;
  std::vector<Vec3> x_within_;  // of the copies within a step, kept for its memory [m]
};

}  // namespace incision

#pragma once

#include <memory>

#include "incision/tool/blade/cutting_edge.h"
#include "incision/tool/blade/stroke.h"
#include "incision/tool/tool.h"
#include "incision/tool/tool_contact.h"

namespace incision {

/// What is known of a blade's strokes.
struct StrokesMemory {
  CutResult under_way;
  double area_before = 0;  ///< cut before the stroke under way [m²]
  double last_area = 0;    ///< by the last stroke that ended [m²]
};

template <class Archive>
void serialize(Archive& archive, StrokesMemory& memory) {
  auto& [under_way, area_before, last_area] = memory;
  archive(under_way, area_before, last_area);
}

/// What of a blade outlasts a step, but for what its couplers keep.
struct BladeMemory {
  ToolMemory tool;
  StrokesMemory strokes;
  Stroke::Memory stroke;
};

template <class Archive>
void serialize(Archive& archive, BladeMemory& memory) {
  auto& [tool, strokes, stroke] = memory;
  archive(tool, strokes, stroke);
}

/// A tool with a cutting edge. What the edge sweeps in a step is cut after it, in the material; so a blade at rest cuts
/// tissue that moves. Its crack opens as it sweeps it, what it has not cut yet resists, and the shapes of its link
/// push.
class Blade : public Tool {
 public:
  /// `edge` in the frame of its link, `fronts` as tipFronts has them. `touching` are the shapes of its link, where they
  /// touch. `materials` and `mesh` must outlive this.
  Blade(const ToolSettings& settings, const Edge& edge, const std::array<double, 2>& fronts, const Materials& materials,
        const CutMesh& mesh, std::unique_ptr<ToolContact> touching);

  const Edge* edge() const override { return &edge_; }

  std::vector<Coupler*> couplers() override;
  ToolReport report() const override;

  std::any keep() const override { return BladeMemory{tool_, strokes_, stroke_.keep()}; }
  void recall(const std::any& kept) override;
  void write(const std::any& kept, ArchiveWriter* archive) const override { writeKept<BladeMemory>(kept, archive); }
  std::any read(ArchiveReader* archive) const override { return readKept<BladeMemory>(archive); }

 protected:
  void start(const Pose& pose, const std::vector<Vec3>& x) override;
  std::optional<CutResult> act(const Pose& first, const std::vector<Pose>& way, double time_step, const Motion& motion,
                               MeshDoor* door) override;
  std::optional<CutResult> interrupt() override;

 private:
  void sweep(const Edge& to, const std::vector<Vec3>& x, MeshDoor* door);
  template <typename Cut>
  void record(const Cut& cut);

  Edge edge_;
  const Materials& materials_;
  Ties ties_;
  Stroke stroke_;
  CuttingEdge cutting_;
  StrokesMemory strokes_;
  std::vector<Vec3> x_within_;  // of the copies within a step, kept for its memory [m]
};

}  // namespace incision

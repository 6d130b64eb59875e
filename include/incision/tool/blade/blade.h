#pragma once

#include <memory>

#include "incision/base/memory_limits.h"
#include "incision/tool/blade/working_edges.h"
#include "incision/tool/kinds.h"

namespace incision {

/// What of a blade outlasts a step, but for what its couplers keep.
struct BladeMemory {
  ToolMemory tool;
  WorkingEdgesMemory edge;
};

template <class Archive>
void serialize(Archive& archive, BladeMemory& memory) {
  auto& [tool, edge] = memory;
  archive(tool, edge);
}

void check(const BladeMemory& memory, const MemoryLimits& limits);

/// A tool with a cutting edge: what that sweeps is cut, and the shapes of its link push.
class Blade : public Tool {
 public:
  /// `edge` in the frame of its link, `fronts` as tipFronts has them.
  Blade(const ToolSettings& settings, const Edge& edge, const std::array<double, 2>& fronts,
        const ToolSurroundings& surroundings, Touching touching);

  ToolForm form() const override;

  std::vector<Coupler*> couplers() override;
  ToolReport report() const override;

  std::any keep() const override { return BladeMemory{tool_, edge_.keep()}; }
  void recall(const std::any& kept) override;
  void write(const std::any& kept, ArchiveWriter* archive) const override { writeKept<BladeMemory>(kept, archive); }
  std::any read(ArchiveReader* archive) const override;

 protected:
  void start(const std::vector<Vec3>& x) override { edge_.start(x); }
  std::optional<CutResult> act(double time_step, const Motion& motion, MeshDoor* door) override {
    return edge_.act(ways(), time_step, motion, door);
  }
  std::optional<CutResult> interrupt() override { return edge_.interrupt(); }

 private:
  WorkingEdges edge_;
};

/// As ToolKind::make says.
std::unique_ptr<Tool> makeBlade(const ToolSettings& settings, const Description& description,
                                const ToolSurroundings& surroundings);

}  // namespace incision

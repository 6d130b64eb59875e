#pragma once

#include <memory>

#include "incision/base/memory_limits.h"
#include "incision/tool/blade/working_edges.h"
#include "incision/tool/jawed_tool.h"
#include "incision/tool/kinds.h"
#include "incision/tool/scissors/scissor_edges.h"

namespace incision {

/// What of scissors outlasts a step, but for what their couplers keep.
struct ScissorsMemory {
  ToolMemory tool;
  WorkingEdgesMemory edges;
};

template <class Archive>
void serialize(Archive& archive, ScissorsMemory& memory) {
  auto& [tool, edges] = memory;
  archive(tool, edges);
}

void check(const ScissorsMemory& memory, const MemoryLimits& limits);

/// Two blades on a joint, whose edges cut what lies between them. Where the joint opens, and while it is closed as far
/// as it goes, they only touch: so they spread tissue, and can be led into it.
class Scissors : public JawedTool {
 public:
  Scissors(const ToolSettings& settings, JawLinks links, const ScissorEdges& edges,
           const ToolSurroundings& surroundings, Touching touching);

  ToolForm form() const override;
  std::vector<Coupler*> couplers() override;
  ToolReport report() const override;

  std::any keep() const override { return ScissorsMemory{tool_, edges_.keep()}; }
  void recall(const std::any& kept) override;
  void write(const std::any& kept, ArchiveWriter* archive) const override { writeKept<ScissorsMemory>(kept, archive); }
  std::any read(ArchiveReader* archive) const override;

 protected:
  void start(const std::vector<Vec3>& x) override;
  std::optional<CutResult> act(double time_step, const Motion& motion, MeshDoor* door) override {
    return edges_.act(ways(), time_step, motion, door);
  }
  std::optional<CutResult> interrupt() override { return edges_.interrupt(); }

 private:
  double closed_;  // the least angle of the joint [rad]; 0 where it has no limits
  WorkingEdges edges_;
};

/// As ToolKind::make says.
std::unique_ptr<Tool> makeScissors(const ToolSettings& settings, const Description& description,
                                   const ToolSurroundings& surroundings);

}  // namespace incision

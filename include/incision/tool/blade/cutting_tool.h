#pragma once

#include <utility>
#include <vector>

#include "incision/base/memory_limits.h"
#include "incision/tool/blade/working_edges.h"
#include "incision/tool/kinds.h"

namespace incision {

/// What of a tool with cutting edges outlasts a step, but for what its couplers keep.
struct CuttingToolMemory {
  ToolMemory tool;
  WorkingEdgesMemory edges;
};

template <class Archive>
void serialize(Archive& archive, CuttingToolMemory& memory) {
  auto& [tool, edges] = memory;
  archive(tool, edges);
}

void check(const CuttingToolMemory& memory, const MemoryLimits& limits);

/// A `Base`, which is a Tool or derives from it, with cutting edges: what these sweep is cut.
template <class Base>
class CuttingTool : public Base {
 public:
  /// `of_base` is what a Base is made of.
  template <class... OfBase>
  CuttingTool(const std::vector<EdgeOfTool>& edges, bool progressive, const ToolSurroundings& surroundings,
              OfBase&&... of_base)
      : Base(std::forward<OfBase>(of_base)...),
        edges_(this->settings().name, edges, progressive, &this->in_step_, &surroundings.ties, &surroundings.near,
               surroundings.materials, surroundings.mesh) {}

  ToolForm form() const override {
    ToolForm form = Base::form();
    for (const EdgeOfTool& edge : edges_.edges()) form.edges.push_back({edge.group, edge.edge});
    return form;
  }

  std::vector<Coupler*> couplers() override {
    std::vector<Coupler*> list = Base::couplers();
    edges_.addCouplers(&list);
    return list;
  }

  void scaleCuttingForce(double factor) override { edges_.scaleCuttingForce(factor); }

  ToolReport report() const override {
    ToolReport report = Base::report();
    if (this->pose()) edges_.addTo(&report);
    return report;
  }

  void keepIn(std::any* kept) const override {
    auto& memory = memoryIn<CuttingToolMemory>(kept);
    memory.tool = this->tool_;
    edges_.keepIn(&memory.edges);
  }
  void recall(const std::any& kept) override {
    const auto& memory = std::any_cast<const CuttingToolMemory&>(kept);
    this->tool_ = memory.tool;
    edges_.recall(memory.edges);
  }
  void write(const std::any& kept, ArchiveWriter* archive) const override {
    writeKept<CuttingToolMemory>(kept, archive);
  }
  std::any read(ArchiveReader* archive) const override {
    std::any kept = readKept<CuttingToolMemory>(archive);
    // Where edges have swept anything, all of them have stood somewhere.
    const auto& stands = std::any_cast<const CuttingToolMemory&>(kept).edges.stroke.stands;
    require(stands.empty() || stands.size() == edges_.edges().size(), "a stroke is of other edges");
    return kept;
  }

 protected:
  void start(const std::vector<Vec3>& x) override { edges_.start(x); }
  std::optional<CutResult> act(double time_step, const Motion& motion, MeshDoor* door) override {
    return edges_.act(this->ways(), time_step, motion, door);
  }
  std::optional<CutResult> interrupt() override { return edges_.interrupt(); }

 private:
  WorkingEdges edges_;
};

}  // namespace incision

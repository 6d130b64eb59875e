// What memories of tools must be.
#include "incision/tool/blade/cutting_tool.h"
#include "incision/tool/grasper/grip.h"

namespace incision {

void check(const ToolMemory& memory, const MemoryLimits& limits) {
  if (memory.pose) check(*memory.pose, limits);
  for (const Pose& pose : memory.path) check(pose, limits);
}

void check(const Stroke::Memory& memory, const MemoryLimits& limits) {
  require(!memory.crack || isOneOf(*memory.crack, limits.cracks), "a stroke's crack is none");
  require(memory.cracks >= 0, "a stroke has made less than no cracks");
  for (const Stroke::Stand& stand : memory.stands)
    require(
        static_cast<int>(stand.x.size()) >= limits.first_copies && static_cast<int>(stand.x.size()) <= limits.copies,
        "a stroke is among other copies");
  for (const auto& [copy, way] : memory.ways) require(isOneOf(copy, limits.copies), "a stroke is at what is no copy");
  for (const auto& [copy, distance] : memory.distances)
    require(isOneOf(copy, limits.copies), "a stroke is at what is no copy");
  for (const auto& [element, swept] : memory.swept)
    require(isOneOf(element, limits.elements), "a stroke is in what is no element");
}

void check(const WorkingEdgesMemory& memory, const MemoryLimits& limits) {
  require(memory.strokes.under_way.status <= CutStatus::REJECTED, "a stroke came to what is no end");
  check(memory.stroke, limits);
}

void check(const CuttingToolMemory& memory, const MemoryLimits& limits) {
  check(memory.tool, limits);
  check(memory.edges, limits);
}

void check(const std::vector<StationMemory>& /*memory*/, const MemoryLimits& /*limits*/) {}

std::any CuttingEdge::read(ArchiveReader* archive) const {
  const std::any kept = WithMemory::read(archive);
  require(std::any_cast<const std::vector<StationMemory>&>(kept).size() == memory_.size(),
          "an edge has other stations");
  return kept;
}

void check(const TiesMemory& memory, const MemoryLimits& limits) {
  for (const Tie& tie : memory.ties) {
    check(tie.section, limits);
    require(!tie.unswept.empty() && tie.unswept.size() <= tie.points, "a tie has more points than its section");
    require(tie.area >= 0 && tie.steepness >= 0 && tie.size > 0, "a tie has a size below 0");
    require(tie.share_then >= 0 && tie.share_then < 1, "a tie has come apart at no share");
  }
}

void check(const GripMemory& memory, const MemoryLimits& limits) {
  require(memory.taken >= static_cast<int>(memory.points.size()), "a grip holds more than it has taken");
  for (const GripPoint& point : memory.points) {
    require(isOneOf(point.held.part, limits.parts()) && limits.element_of_part[point.held.part] == point.held.element,
            "a grip holds what is no part");
    require(point.stiffness >= 0, "a grip's stiffness is below 0");
  }
}

}  // namespace incision

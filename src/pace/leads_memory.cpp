#include "incision/pace/leads_memory.h"

#include <sstream>

#include "incision/base/archive.h"

namespace incision {

template <class Archive>
void serialize(Archive& archive, LeadsMemory& memory) {
  auto& [tools, obstacles, clamps] = memory;
  archive(tools, obstacles, clamps);
}

std::string toBytes(const LeadsMemory& memory) {
  std::ostringstream out;
  out.exceptions(std::ostream::badbit);  // where memory runs out too, which the stream would keep to itself
  ArchiveWriter archive(out);
  archive(memory);
  return out.str();
}

std::optional<LeadsMemory> readLeads(const std::string& bytes, const LeadsMemory& alike) {
  if (bytes.empty()) return std::nullopt;
  ArchiveReader archive(bytes);
  LeadsMemory memory;
  archive(memory);
  require(archive.left() == 0, "there is more than leads it");
  require(memory.tools.size() == alike.tools.size(), "its tools are others");
  require(memory.obstacles.size() == alike.obstacles.size(), "its obstacles are others");
  require(memory.clamps.size() == alike.clamps.size(), "its clamps are others");
  for (const ToolGuideMemory& tool : memory.tools) check(tool, archive.limits);
  check(memory.obstacles, archive.limits);
  check(memory.clamps, archive.limits);
  return memory;
}

}  // namespace incision

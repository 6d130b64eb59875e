// Whatever a tool's description is, reading it gives an edge with two finite ends or an InputError.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "incision/mesh/input_error.h"
#include "incision/tool/blade.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  incision::ToolSettings tool;
  tool.link = "blade";
  try {
    const incision::Edge edge =
        incision::bladeEdge(tool, std::string(reinterpret_cast<const char*>(data), size), "tool.urdf");
    if (!edge[0].allFinite() || !edge[1].allFinite() || edge[0] == edge[1]) std::abort();
  } catch (const incision::InputError&) {
  }
  return 0;
}

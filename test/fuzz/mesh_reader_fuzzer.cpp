// Whatever bytes a file holds, the reader gives a mesh on which later stages can rely, or an InputError.
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>

#include "incision/base/input_error.h"
#include "incision/mesh/mesh_io.h"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

void requireValid(const incision::TetMesh& mesh) {
  require(!mesh.elements.empty());
  for (const auto& node : mesh.nodes) require(node.allFinite());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    for (int n : mesh.elements[e]) require(n >= 0 && n < static_cast<int>(mesh.nodes.size()));
    require(incision::elementVolume(mesh, static_cast<int>(e)) > 0);
  }
  const incision::MeshTopology topology = incision::buildTopology(mesh);
  require(topology.star.values().size() == 4 * mesh.elements.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream in(std::string(data, data + size));
  try {
    requireValid(incision::readGmsh(in, "fuzz.msh"));
  } catch (const incision::InputError&) {
    // Refused, as most inputs are.
  }
  return 0;
}

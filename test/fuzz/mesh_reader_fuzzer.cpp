// Whatever bytes a file holds, the reader gives a mesh on which later stages can rely, or an InputError.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "incision/base/input_error.h"
#include "incision/mesh/mesh_io.h"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

template <class Values>
void requireAscending(const Values& values, int end) {
  for (std::size_t i = 0; i < values.size(); ++i)
    require(values[i] >= (i == 0 ? 0 : values[i - 1] + 1) && values[i] < end);
}

/// Groups come by dimension and number, have a name, and have nothing that the body has not.
void requireValidGroups(const incision::TetMesh& mesh) {
  const int nodes = static_cast<int>(mesh.nodes.size()), elements = static_cast<int>(mesh.elements.size());
  std::vector<char> used(nodes, 0);
  for (const auto& element : mesh.elements)
    for (int n : element) used[n] = 1;
  std::pair<int, int> last = {-1, 0};
  for (const incision::PhysicalGroup& group : mesh.groups) {
    const std::pair<int, int> key = {group.dimension, group.tag};
    require(last < key && group.dimension <= 3 && group.tag > 0 && !group.name.empty());
    last = key;
    requireAscending(group.nodes, nodes);
    requireAscending(group.elements, elements);
    require(group.elements.empty() || group.dimension == 3);
    require(group.triangles.empty() || group.dimension == 2);
    require(std::adjacent_find(group.triangles.begin(), group.triangles.end(), std::greater_equal<>()) ==
            group.triangles.end());
    const auto has = [&](int n) { return std::binary_search(group.nodes.begin(), group.nodes.end(), n); };
    for (int n : group.nodes) require(used[n]);
    for (const auto& triangle : group.triangles) {
      requireAscending(triangle, nodes);
      require(std::all_of(triangle.begin(), triangle.end(), has));
    }
    for (int e : group.elements) require(std::all_of(mesh.elements[e].begin(), mesh.elements[e].end(), has));
  }
}

void requireValid(const incision::TetMesh& mesh) {
  require(!mesh.elements.empty());
  for (const auto& node : mesh.nodes) require(node.allFinite());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    for (int n : mesh.elements[e]) require(n >= 0 && n < static_cast<int>(mesh.nodes.size()));
    require(incision::elementVolume(mesh, static_cast<int>(e)) > 0);
  }
  requireValidGroups(mesh);
  const incision::MeshTopology topology = incision::buildTopology(mesh);
  require(topology.star.values().size() == 4 * mesh.elements.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream in(std::string(data, data + size));
  try {
    incision::MeshRepairs repairs;
    requireValid(incision::readGmsh(in, "fuzz.msh", &repairs));
    incision::sentences(repairs);
  } catch (const incision::InputError&) {
    // Refused, as most inputs are.
  }
  return 0;
}

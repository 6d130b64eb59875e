#include "incision/body/remarks.h"

#include <algorithm>

#include "incision/fem/boundary.h"

namespace incision {
namespace {

/// "scene.yaml: boundary[0]: box [[…]]" with what is wrong.
std::string remark(const Place& place, const std::string& what) {
  return (place.said_at.empty() ? "" : place.said_at + ": ") + describe(place) + " " + what;
}

void remarkOnClamps(const Scene& scene, const CutMesh& mesh, std::vector<std::string>* remarks) {
  const std::vector<int> held = heldNodes(mesh.mesh(), scene.boundary);
  for (std::size_t i = 0; i < scene.boundary.size(); ++i) {
    if (std::find(held.begin(), held.end(), static_cast<int>(i)) != held.end()) continue;
    const Place& place = scene.boundary[i].place;
    const bool is_empty = nodesAt(place, mesh.mesh()).empty();
    remarks->push_back(remark(place, is_empty ? "has no node of the mesh: it holds nothing"
                                              : "has only nodes that entries before it hold: it holds nothing"));
  }
}

void remarkOnLoads(const Scene& scene, const CutMesh& mesh, std::vector<std::string>* remarks) {
  for (const Load& load : scene.loads)
    if (boundaryFacesAt(load.place, mesh.mesh(), mesh.topology()).empty())
      remarks->push_back(remark(load.place, "has no face of the mesh's boundary: it loads nothing"));
}

}  // namespace

std::vector<std::string> remarksOn(const Scene& scene, const CutMesh& mesh) {
  std::vector<std::string> remarks;
  remarkOnClamps(scene, mesh, &remarks);
  remarkOnLoads(scene, mesh, &remarks);
  const std::vector<int> held = heldNodes(mesh.mesh(), scene.boundary);
  const bool is_held = std::any_of(held.begin(), held.end(), [](int clamp) { return clamp >= 0; });
  if (!is_held && !scene.contact && !scene.gravity.isZero(0))
    remarks.push_back("nothing holds the body, neither a clamp nor contact: it falls");
  return remarks;
}

}  // namespace incision

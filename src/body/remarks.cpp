#include "incision/body/remarks.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "incision/fem/boundary.h"
#include "incision/fem/regions.h"

namespace incision {
namespace {

/// Longest side of a body's box [m] that is taken for meant. Organs and limbs stay below it; in millimetres none does.
constexpr double LARGEST_BODY = 10;

/// "scene.yaml: boundary[0]: box [[…]]" with what is wrong.
std::string remark(const Place& place, const std::string& what) {
  return (place.said_at.empty() ? "" : place.said_at + ": ") + describe(place) + " " + what;
}

/// `held`: the clamp of every node.
void remarkOnClamps(const Scene& scene, const CutMesh& mesh, const std::vector<int>& held,
                    std::vector<std::string>* remarks) {
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

void remarkOnRegions(const Scene& scene, const CutMesh& mesh, std::vector<std::string>* remarks) {
  const Regions regions(mesh.mesh(), scene.body.regions);
  std::vector<char> is_used(regions.count(), 0);
  for (int e = 0; e < static_cast<int>(mesh.mesh().elements.size()); ++e) is_used[regions.of(e)] = 1;
  for (std::size_t i = 0; i < scene.body.regions.size(); ++i) {
    if (is_used[i + 1]) continue;
    const Place& place = scene.body.regions[i].place;
    const bool is_empty = elementsAt(place, mesh.mesh()).empty();
    remarks->push_back(remark(place, is_empty ? "has no element of the mesh: this region is empty"
                                              : "has only elements that later entries take: this region is empty"));
  }
}

/// Who has written a grid or a scale has thought of the unit.
void remarkOnUnit(const Scene& scene, const CutMesh& mesh, std::vector<std::string>* remarks) {
  const std::vector<PlacedMesh>& meshes = scene.body.meshes;
  if (std::none_of(meshes.begin(), meshes.end(), [](const PlacedMesh& file) { return file.scale == 1; })) return;
  const RestBox bounds = boundsOf(mesh.mesh());
  const double size = (bounds.max - bounds.min).maxCoeff();
  if (size <= LARGEST_BODY) return;
  std::ostringstream remark;
  remark
      << std::setprecision(3) << "the body is " << size
      << " m large, as lengths in mesh files are taken for metres: beside the file's name write scale: 0.001 where it "
         "is in millimetres";
  remarks->push_back(remark.str());
}

}  // namespace

std::vector<std::string> remarksOn(const Scene& scene, const CutMesh& mesh) {
  std::vector<std::string> remarks;
  remarkOnUnit(scene, mesh, &remarks);
  remarkOnRegions(scene, mesh, &remarks);
  const std::vector<int> held = heldNodes(mesh.mesh(), scene.boundary);
  remarkOnClamps(scene, mesh, held, &remarks);
  remarkOnLoads(scene, mesh, &remarks);
  const bool is_held = std::any_of(held.begin(), held.end(), [](int clamp) { return clamp >= 0; });
  if (!is_held && !scene.contact && !scene.gravity.isZero(0))
    remarks.push_back("nothing holds the body, neither a clamp nor contact: it falls");
  return remarks;
}

std::vector<std::string> remarksOnShapes(const DeformableBody& body) {
  std::vector<std::string> remarks = remarksOn(body.obstacles());
  for (std::size_t tool = 0; tool < body.tools(); ++tool)
    for (const std::string& remark : remarksOn(body.toolForm(tool).shapes)) remarks.push_back(remark);
  return remarks;
}

}  // namespace incision

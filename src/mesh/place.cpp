#include "incision/mesh/place.h"

#include <algorithm>
#include <array>
#include <sstream>

#include "incision/base/input_error.h"
#include "incision/base/limits.h"
#include "incision/base/printable.h"
#include "incision/base/sort_once.h"
#include "incision/base/suggestion.h"
#include "incision/base/yaml_reader.h"

namespace incision {
namespace {

/// The groups of a name, of which there may be one in each dimension.
std::vector<const PhysicalGroup*> groupsOf(const Place& place, const TetMesh& mesh) {
  std::vector<const PhysicalGroup*> found;
  std::vector<std::string> names;
  for (const PhysicalGroup& group : mesh.groups) {
    if (group.name == place.group) found.push_back(&group);
    if (std::find(names.begin(), names.end(), group.name) == names.end()) names.push_back(group.name);
  }
  if (!found.empty()) return found;
  const std::string allowed = names.empty() ? "none, the mesh has no physical groups" : printable(joined(names));
  throw InputError((place.said_at.empty() ? "" : place.said_at + ".group: ") + "'" + printable(place.group) + "'" +
                   suggestion(place.group, names) + " (allowed: " + allowed + ")");
}

/// All that the groups of a name have of one kind, ascending, each once.
template <class Value>
std::vector<Value> ofGroups(const Place& place, const TetMesh& mesh, std::vector<Value> PhysicalGroup::*kind) {
  std::vector<Value> all;
  for (const PhysicalGroup* group : groupsOf(place, mesh))
    all.insert(all.end(), (group->*kind).begin(), (group->*kind).end());
  sortOnce(&all);
  return all;
}

std::array<int, 3> triangleOf(const TetMesh& mesh, const ElementFace& at) {
  std::array<int, 3> nodes;
  for (int i = 0; i < 3; ++i) nodes[i] = mesh.elements[at.element][FACE_NODES[at.face][i]];
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

template <class Test>
std::vector<ElementFace> boundaryFaces(const MeshTopology& topology, const Test& isThere) {
  std::vector<ElementFace> faces;
  for (int e = 0; e < static_cast<int>(topology.neighbours.size()); ++e)
    for (int f = 0; f < 4; ++f)
      if (topology.neighbours[e][f] < 0 && isThere(ElementFace{e, f})) faces.push_back({e, f});
  return faces;
}

}  // namespace

Place parsePlace(const YamlMap& map) {
  if (map.has("group") == map.has("box")) map.whole().fail("needs a group or a box (allowed: one of the two)");
  Place place;
  if (const auto group = map.find("group")) place.group = group->text(MAX_NAME);
  if (const auto box = map.find("box")) place.box = parseRestBox(*box);
  place.said_at = map.whole().where();
  return place;
}

std::vector<int> nodesAt(const Place& place, const TetMesh& mesh) {
  if (!place.group.empty()) return ofGroups(place, mesh, &PhysicalGroup::nodes);
  std::vector<int> nodes;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    if (place.box.contains(mesh.nodes[n])) nodes.push_back(static_cast<int>(n));
  return nodes;
}

std::vector<int> elementsAt(const Place& place, const TetMesh& mesh) {
  if (!place.group.empty()) return ofGroups(place, mesh, &PhysicalGroup::elements);
  std::vector<int> elements;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto& [a, b, c, d] = mesh.elements[e];
    const Vec3 centroid = (mesh.nodes[a] + mesh.nodes[b] + mesh.nodes[c] + mesh.nodes[d]) / 4;
    if (place.box.contains(centroid)) elements.push_back(static_cast<int>(e));
  }
  return elements;
}

std::vector<ElementFace> boundaryFacesAt(const Place& place, const TetMesh& mesh, const MeshTopology& topology) {
  if (place.group.empty()) {
    return boundaryFaces(topology, [&](const ElementFace& at) {
      const std::array<int, 3> nodes = triangleOf(mesh, at);
      return std::all_of(nodes.begin(), nodes.end(), [&](int n) { return place.box.contains(mesh.nodes[n]); });
    });
  }
  const auto triangles = ofGroups(place, mesh, &PhysicalGroup::triangles);
  const auto elements = ofGroups(place, mesh, &PhysicalGroup::elements);
  return boundaryFaces(topology, [&](const ElementFace& at) {
    return std::binary_search(elements.begin(), elements.end(), at.element) ||
           std::binary_search(triangles.begin(), triangles.end(), triangleOf(mesh, at));
  });
}

std::string describe(const Place& place) {
  if (!place.group.empty()) return "group '" + printable(place.group) + "'";
  std::ostringstream text;
  const Vec3 &a = place.box.min, &b = place.box.max;
  text << "box [[" << a[0] << ", " << a[1] << ", " << a[2] << "], [" << b[0] << ", " << b[1] << ", " << b[2] << "]]";
  return text.str();
}

}  // namespace incision

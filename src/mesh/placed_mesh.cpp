#include "incision/mesh/placed_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "group_builder.h"
#include "incision/base/input_error.h"
#include "incision/base/limits.h"
#include "incision/base/printable.h"
#include "incision/base/yaml_reader.h"
#include "incision/mesh/mesh_io.h"
#include "limits.h"

namespace incision {
namespace {

/// A mesh's unit [m], from a nanometre up: what a body measures is within these.
constexpr Range UNIT = {1e-9, 1e9};

/// Most nodes, and most elements, of meshes together: every index into four times as many stays within an int.
constexpr std::size_t MAX_JOINED = 100'000'000;

/// Roll, pitch and yaw turn about the fixed x, then y, then z axis, as in a URDF.
void parsePose(const YamlValue& value, PlacedMesh* mesh) {
  const std::vector<YamlValue> numbers = value.list(6);
  const auto number = [&](std::size_t i) { return numbers[i].number({-MAX_COORDINATE, MAX_COORDINATE}); };
  const auto turn = [&](std::size_t i, const Vec3& axis) { return Eigen::AngleAxisd(number(i), axis); };
  mesh->position = {number(0), number(1), number(2)};
  mesh->rotation = (turn(5, Vec3::UnitZ()) * turn(4, Vec3::UnitY()) * turn(3, Vec3::UnitX())).toRotationMatrix();
}

PlacedMesh parsePlacedMesh(const std::string& name, const YamlValue& value) {
  const YamlMap map = value.map({"file", "scale", "pose"});
  PlacedMesh mesh;
  mesh.name = name;
  mesh.said_at = value.where();
  mesh.file = map.at("file").path();
  mesh.scale = map.number("scale", mesh.scale, UNIT);
  if (const auto pose = map.find("pose")) parsePose(*pose, &mesh);
  return mesh;
}

void check(const TetMesh& mesh, const PlacedMesh& at) {
  for (const Vec3& X : mesh.nodes)
    if (!(X.cwiseAbs().maxCoeff() <= MAX_COORDINATE))
      throw InputError(at.said_at + ": scale and pose put a node beyond 1e9 m (allowed: within 1e9 m of the origin)");
  for (const auto& [a, b, c, d] : mesh.elements)
    if (isDegenerate(mesh.nodes[a], mesh.nodes[b], mesh.nodes[c], mesh.nodes[d]) ||
        sixVolumes(mesh.nodes[a], mesh.nodes[b], mesh.nodes[c], mesh.nodes[d]) < 0)
      throw InputError(at.said_at + ": so scaled and placed, an element is too small for its distance from the origin");
}

/// The numbers of the groups are left to joined().
void renameGroups(const std::string& name, TetMesh* mesh) {
  for (PhysicalGroup& group : mesh->groups) group.name = name + "/" + group.name;
  PhysicalGroup whole;
  whole.name = name;
  whole.dimension = 3;
  whole.elements.resize(mesh->elements.size());
  std::iota(whole.elements.begin(), whole.elements.end(), 0);
  whole.nodes = nodesOf(*mesh, whole.elements);
  mesh->groups.push_back(std::move(whole));
}

PhysicalGroup shifted(PhysicalGroup group, int nodes, int elements) {
  for (int& n : group.nodes) n += nodes;
  for (auto& triangle : group.triangles)
    for (int& n : triangle) n += nodes;
  for (int& e : group.elements) e += elements;
  return group;
}

void numberGroups(std::vector<PhysicalGroup>* groups) {
  std::stable_sort(groups->begin(), groups->end(),
                   [](const PhysicalGroup& a, const PhysicalGroup& b) { return a.dimension < b.dimension; });
  std::array<int, 4> last = {0, 0, 0, 0};
  for (PhysicalGroup& group : *groups) group.tag = ++last[group.dimension];
}

}  // namespace

std::vector<PlacedMesh> parsePlacedMeshes(const YamlMap& body) {
  std::vector<PlacedMesh> meshes;
  if (const auto scale = body.find("scale"); scale && !body.has("mesh"))
    scale->fail("is the unit of a mesh (allowed: beside body.mesh; each of body.meshes has its own)");
  if (const auto mesh = body.find("mesh")) {
    meshes.emplace_back();
    meshes.back().file = mesh->path();
    meshes.back().scale = body.number("scale", 1, UNIT);
    meshes.back().said_at = body.whole().where() + ".scale";
  }
  if (const auto named = body.find("meshes"))
    for (const auto& [name, value] : named->named(MAX_MESHES)) meshes.push_back(parsePlacedMesh(name, value));
  return meshes;
}

TetMesh placed(TetMesh mesh, const PlacedMesh& at) {
  const bool stays = at.scale == 1 && at.rotation == Mat3::Identity() && at.position == Vec3::Zero();
  if (!stays) {
    for (Vec3& X : mesh.nodes) X = at.rotation * (at.scale * X) + at.position;
    check(mesh, at);
  }
  if (!at.name.empty()) renameGroups(at.name, &mesh);
  return mesh;
}

TetMesh joined(const std::vector<TetMesh>& meshes) {
  std::size_t nodes = 0, elements = 0;
  for (const TetMesh& mesh : meshes) {
    nodes += mesh.nodes.size();
    elements += mesh.elements.size();
  }
  if (nodes > MAX_JOINED || elements > MAX_JOINED)
    throw InputError("body.meshes: " + std::to_string(nodes) + " nodes and " + std::to_string(elements) +
                     " elements (allowed: up to " + std::to_string(MAX_JOINED) + " of each in all)");
  TetMesh all;
  all.nodes.reserve(nodes);
  all.elements.reserve(elements);
  for (const TetMesh& mesh : meshes) {
    const int first_node = static_cast<int>(all.nodes.size()), first_element = static_cast<int>(all.elements.size());
    all.nodes.insert(all.nodes.end(), mesh.nodes.begin(), mesh.nodes.end());
    for (const auto& [a, b, c, d] : mesh.elements)
      all.elements.push_back({a + first_node, b + first_node, c + first_node, d + first_node});
    for (const PhysicalGroup& group : mesh.groups) all.groups.push_back(shifted(group, first_node, first_element));
  }
  numberGroups(&all.groups);
  return all;
}

TetMesh readPlacedMeshes(const std::vector<PlacedMesh>& meshes, std::vector<std::string>* notes) {
  std::vector<TetMesh> all;
  for (const PlacedMesh& mesh : meshes) {
    MeshRepairs repairs;
    all.push_back(placed(readGmsh(mesh.file, &repairs), mesh));
    if (!notes) continue;
    for (const std::string& sentence : sentences(repairs)) notes->push_back(printable(mesh.file) + ": " + sentence);
  }
  return meshes.size() == 1 && meshes[0].name.empty() ? std::move(all[0]) : joined(all);
}

}  // namespace incision

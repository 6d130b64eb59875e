#include "group_builder.h"

#include <algorithm>
#include <array>

#include "incision/base/sort_once.h"

namespace incision {
namespace {

constexpr int SURFACE = 2, VOLUME = 3;

/// Sorts what a group has, and leaves out what the body has not.
void tidy(const TetMesh& mesh, const std::vector<char>& used, PhysicalGroup* group) {
  sortOnce(&group->elements);
  if (!group->elements.empty()) group->nodes = nodesOf(mesh, group->elements);
  const auto unused = [&](int n) { return !used[n]; };
  auto& nodes = group->nodes;
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(), unused), nodes.end());
  sortOnce(&nodes);
  auto& triangles = group->triangles;
  const auto apart = [&](const auto& triangle) { return std::any_of(triangle.begin(), triangle.end(), unused); };
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(), apart), triangles.end());
  sortOnce(&triangles);
}

}  // namespace

std::vector<int> nodesOf(const TetMesh& mesh, const std::vector<int>& elements) {
  std::vector<char> used(mesh.nodes.size(), 0);
  for (int e : elements)
    for (int n : mesh.elements[e]) used[n] = 1;
  std::vector<int> nodes;
  for (std::size_t n = 0; n < used.size(); ++n)
    if (used[n]) nodes.push_back(static_cast<int>(n));
  return nodes;
}

PhysicalGroup& GroupBuilder::group(int dimension, int number) {
  PhysicalGroup& group = groups_[{dimension, number}];
  group.dimension = dimension;
  group.tag = number;
  return group;
}

bool GroupBuilder::name(int dimension, int number, const std::string& name) {
  PhysicalGroup& named = group(dimension, number);
  if (!named.name.empty()) return false;
  named.name = name;
  return true;
}

void GroupBuilder::addElement(int dimension, const std::vector<int>& numbers, const std::vector<int>& corners) {
  for (int number : numbers) {
    PhysicalGroup& joined = group(dimension, number);
    joined.nodes.insert(joined.nodes.end(), corners.begin(), corners.end());
    if (dimension != SURFACE || corners.size() != 3) continue;
    std::array<int, 3> triangle = {corners[0], corners[1], corners[2]};
    std::sort(triangle.begin(), triangle.end());
    joined.triangles.push_back(triangle);
  }
}

void GroupBuilder::addTetrahedron(const std::vector<int>& numbers, int element) {
  for (int number : numbers) group(VOLUME, number).elements.push_back(element);
}

void GroupBuilder::renumberElements(const std::vector<int>& now) {
  for (auto& [key, group] : groups_)
    for (int& e : group.elements) e = now[e];
}

std::vector<PhysicalGroup> GroupBuilder::finish(const TetMesh& mesh) {
  std::vector<PhysicalGroup> all;
  if (groups_.empty()) return all;
  const std::vector<char> used = usedNodes(mesh);
  for (auto& [key, group] : groups_) {
    if (group.name.empty()) group.name = std::to_string(group.tag);
    tidy(mesh, used, &group);
    all.push_back(std::move(group));
  }
  return all;
}

}  // namespace incision

#include "incision/mesh/place.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "incision/mesh/grid_mesh.h"
#include "incision/mesh/node_order.h"
#include "support/section.h"

namespace incision {
namespace {

Place groupPlace(const std::string& name) {
  Place place;
  place.group = name;
  return place;
}

Place parsedPlace(const YamlValue& value) { return parsePlace(value.map({"group", "box"})); }

/// Two by two by two cells of half a metre, with a group of the nodes, triangles or elements at x = 0.
struct Cells : ::testing::Test {
  TetMesh mesh = gridMesh({{2, 2, 2}, Vec3::Ones(), Vec3::Zero()});
  MeshTopology topology = buildTopology(mesh);
  Place left = Place(Vec3(-1, -1, -1), Vec3(1e-6, 2, 2));
  Place lower_half = Place(Vec3(-1, -1, -1), Vec3(2, 2, 0.5));

  void addGroup(const std::string& name, int dimension, const Place& at) {
    PhysicalGroup group;
    group.name = name;
    group.dimension = dimension;
    group.tag = static_cast<int>(mesh.groups.size()) + 1;
    if (dimension < 3) group.nodes = nodesAt(at, mesh);
    if (dimension == 2)
      for (const ElementFace& face : boundaryFacesAt(at, mesh, topology)) {
        std::array<int, 3> nodes;
        for (int i = 0; i < 3; ++i) nodes[i] = mesh.elements[face.element][FACE_NODES[face.face][i]];
        std::sort(nodes.begin(), nodes.end());
        group.triangles.push_back(nodes);
      }
    std::sort(group.triangles.begin(), group.triangles.end());
    if (dimension == 3) {
      group.elements = elementsAt(at, mesh);
      for (int e : group.elements)
        group.nodes.insert(group.nodes.end(), mesh.elements[e].begin(), mesh.elements[e].end());
      std::sort(group.nodes.begin(), group.nodes.end());
      group.nodes.erase(std::unique(group.nodes.begin(), group.nodes.end()), group.nodes.end());
    }
    mesh.groups.push_back(group);
  }
};

std::vector<std::pair<int, int>> pairs(const std::vector<ElementFace>& faces) {
  std::vector<std::pair<int, int>> all;
  for (const ElementFace& face : faces) all.emplace_back(face.element, face.face);
  return all;
}

TEST(Place, IsAGroupOrABox) {
  const Place group = parsedPlace(test::section("boundary.0", "{group: skin}"));
  EXPECT_EQ(group.group, "skin");
  EXPECT_EQ(describe(group), "group 'skin'");
  const Place box = parsedPlace(test::section("boundary.0", "{box: [[0, 1, 2], [3, 4, 5]]}"));
  EXPECT_EQ(box.group, "");
  EXPECT_EQ(box.box.max, Vec3(3, 4, 5));
  EXPECT_EQ(describe(box), "box [[0, 1, 2], [3, 4, 5]]");
  test::expectRefused(parsedPlace, "boundary.0",
                      {{"{}", ": needs a group or a box"},
                       {"{group: a, box: [[0, 0, 0], [1, 1, 1]]}", ": needs a group or a box"},
                       {"{group: ''}", ".group: ''"},
                       {"{box: [[1, 0, 0], [0, 1, 1]]}", ".box: a lower corner above the upper"}});
}

TEST_F(Cells, ABoxHasTheNodesInItAndThoseOnItsSides) {
  const std::vector<int> nodes = nodesAt(left, mesh);
  ASSERT_EQ(nodes.size(), 9u);
  EXPECT_TRUE(std::is_sorted(nodes.begin(), nodes.end()));
  for (int n : nodes) EXPECT_EQ(mesh.nodes[n].x(), 0);
  EXPECT_EQ(nodesAt(lower_half, mesh).size(), 18u);
}

TEST_F(Cells, ABoxHasTheElementsWhoseCentroidsAreInIt) {
  EXPECT_EQ(elementsAt(lower_half, mesh).size(), 4u * 6);
  // A Kuhn tetrahedron's centroid has the coordinates 1/4, 1/2 and 3/4 of its cell: two of six have z at 1/4.
  EXPECT_EQ(elementsAt(Place(Vec3(-1, -1, -1), Vec3(2, 2, 0.13)), mesh).size(), 4u * 2);
}

TEST_F(Cells, ABoxHasTheBoundaryFacesWithAllNodesInIt) {
  const auto faces = boundaryFacesAt(left, mesh, topology);
  EXPECT_EQ(faces.size(), 8u);
  for (const auto& [e, f] : faces) EXPECT_LT(topology.neighbours[e][f], 0);
  EXPECT_EQ(boundaryFacesAt(Place(Vec3(-1, -1, -1), Vec3(2, 2, 2)), mesh, topology).size(), 48u);
}

TEST_F(Cells, AGroupHasWhatTheMeshSays) {
  addGroup("wall", 2, left);
  addGroup("base", 3, lower_half);
  EXPECT_EQ(nodesAt(groupPlace("wall"), mesh), nodesAt(left, mesh));
  EXPECT_TRUE(elementsAt(groupPlace("wall"), mesh).empty());
  EXPECT_EQ(elementsAt(groupPlace("base"), mesh), elementsAt(lower_half, mesh));
  EXPECT_EQ(nodesAt(groupPlace("base"), mesh), nodesAt(lower_half, mesh));
}

TEST_F(Cells, AGroupOfSurfacesHasItsBoundaryFacesAndOneOfVolumesThoseOfItsElements) {
  addGroup("wall", 2, left);
  addGroup("base", 3, lower_half);
  EXPECT_EQ(pairs(boundaryFacesAt(groupPlace("wall"), mesh, topology)), pairs(boundaryFacesAt(left, mesh, topology)));
  // The lower half's bottom and its share of the four sides; its top is no boundary.
  EXPECT_EQ(boundaryFacesAt(groupPlace("base"), mesh, topology).size(), 8u + 4 * 4);
  // A triangle inside the body is in the group, but is no boundary face.
  const std::array<int, 4> nodes = mesh.elements[0];
  for (int f = 0; f < 4; ++f) {
    if (topology.neighbours[0][f] < 0) continue;
    PhysicalGroup inner;
    inner.name = "inner";
    inner.dimension = 2;
    inner.triangles = {{nodes[FACE_NODES[f][0]], nodes[FACE_NODES[f][1]], nodes[FACE_NODES[f][2]]}};
    std::sort(inner.triangles[0].begin(), inner.triangles[0].end());
    mesh.groups = {inner};
    EXPECT_TRUE(boundaryFacesAt(groupPlace("inner"), mesh, topology).empty());
  }
}

TEST_F(Cells, AllGroupsOfANameAreOnePlace) {
  addGroup("part", 2, left);
  addGroup("part", 2, Place(Vec3(1 - 1e-6, -1, -1), Vec3(2, 2, 2)));
  addGroup("part", 3, lower_half);
  EXPECT_EQ(nodesAt(groupPlace("part"), mesh).size(), 9u + 9 + 18 - 12);
  EXPECT_EQ(boundaryFacesAt(groupPlace("part"), mesh, topology).size(), 8u + 8 + 24 - 8);
}

TEST_F(Cells, AGroupThatTheMeshHasNotIsRefusedWithAGuess) {
  const auto complaint = [&](const Place& place) {
    std::string message;
    try {
      nodesAt(place, mesh);
    } catch (const InputError& error) {
      message = error.what();
    }
    EXPECT_THROW(elementsAt(place, mesh), InputError);
    EXPECT_THROW(boundaryFacesAt(place, mesh, topology), InputError);
    return message;
  };
  Place place = parsedPlace(test::section("boundary.0", "{group: wal}"));
  EXPECT_EQ(complaint(place), "scene.yaml: boundary.0.group: 'wal' (allowed: none, the mesh has no physical groups)");
  addGroup("wall", 2, left);
  addGroup("base", 3, lower_half);
  addGroup("wall", 3, lower_half);
  EXPECT_EQ(complaint(place), "scene.yaml: boundary.0.group: 'wal', did you mean wall? (allowed: wall, base)");
}

TEST_F(Cells, OrderingTheElementsCarriesTheGroupsAlong) {
  std::mt19937 generator(3);
  std::shuffle(mesh.elements.begin(), mesh.elements.end(), generator);
  topology = buildTopology(mesh);
  addGroup("base", 3, lower_half);
  addGroup("wall", 2, left);
  const std::vector<int> before = mesh.groups[0].elements;
  orderElements(&mesh);
  topology = buildTopology(mesh);
  EXPECT_NE(mesh.groups[0].elements, before);
  EXPECT_EQ(mesh.groups[0].elements, elementsAt(lower_half, mesh));
  EXPECT_EQ(nodesAt(groupPlace("base"), mesh), nodesAt(lower_half, mesh));
  EXPECT_EQ(pairs(boundaryFacesAt(groupPlace("wall"), mesh, topology)), pairs(boundaryFacesAt(left, mesh, topology)));
}

}  // namespace
}  // namespace incision

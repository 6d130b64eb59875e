// Physical groups as Gmsh's files have them.
#include <gtest/gtest.h>

#include <string>

#include "incision/base/input_error.h"
#include "incision/mesh/mesh_io.h"
#include "support/mesh_text.h"

namespace incision {
namespace {

const std::string NAMES = R"($PhysicalNames
5
0 1 "tip"
2 1 "skin"
2 2 "left "side""
3 1 "top"
3 9 "nothing"
$EndPhysicalNames
)";

// Two tetrahedra on either side of the face 10 20 30; node 99 is that between others. One is in the groups 1 and 4.
const std::string GROUPS_V2_2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + NAMES + R"($Nodes
6
10 0 0 0
20 1 0 0
99 5 5 5
30 0 1 0
40 0 0 1
5 0.25 0.25 -1
$EndNodes
$Elements
11
1 15 2 1 1 40
2 15 2 1 1 99
3 1 2 7 1 10 20
4 8 2 7 1 20 30 99
5 2 2 1 1 5 30 20
6 9 2 2 1 10 20 30 99 99 99
7 3 2 3 1 10 20 5 30
8 2 2 0 1 10 20 40
9 4 2 4 1 10 20 30 40
9 4 2 1 1 10 20 30 40
10 4 2 4 2 20 10 30 5
$EndElements
)";

const std::string GROUPS_V4_1 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + NAMES + R"($Entities
1 1 4 2
1 0 0 0 1 1
1 0 0 0 1 1 1 1 -7 2 1 -1
1 0 0 0 1 1 1 1 1 0
2 1.797693134862316e+308 0 0 -1.797693134862316e+308 1 1 1 -2 1 3
3 0 0 0 1 1 1 1 3 0
4 0 0 0 1 1 1 0 0
1 0 0 0 1 1 1 2 1 4 0
2 0 0 0 1 1 1 1 4 0
$EndEntities
$Nodes
1 6 5 99
3 1 0 6
10
20
99
30
40
5
0 0 0
1 0 0
5 5 5
0 1 0
0 0 1
0.25 0.25 -1
$EndNodes
$Elements
9 10 1 11
0 1 15 2
1 40
2 99
1 1 1 1
3 10 20
1 1 8 1
4 20 30 99
2 1 2 1
5 5 30 20
2 2 9 1
6 10 20 30 99 99 99
2 3 3 1
7 10 20 5 30
2 4 2 1
8 10 20 40
3 1 4 1
9 10 20 30 40
3 2 4 1
10 20 10 30 5
$EndElements
)";

/// A group in a line: its dimension, number and name, its nodes, triangles and elements.
std::string asText(const PhysicalGroup& group) {
  std::ostringstream text;
  text << group.dimension << ' ' << group.tag << ' ' << group.name << ':';
  for (int n : group.nodes) text << ' ' << n;
  text << " |";
  for (const auto& [a, b, c] : group.triangles) text << ' ' << a << '-' << b << '-' << c;
  text << " |";
  for (int e : group.elements) text << ' ' << e;
  return text.str();
}

std::vector<std::string> asTexts(const TetMesh& mesh) {
  std::vector<std::string> texts;
  for (const PhysicalGroup& group : mesh.groups) texts.push_back(asText(group));
  return texts;
}

const std::vector<std::string> GROUPS = {
    "0 1 tip: 4 | |",     "1 7 7: 0 1 3 | |",       "2 1 skin: 1 3 5 | 1-3-5 |", "2 2 left \"side\": 0 1 3 | 0-1-3 |",
    "2 3 3: 0 1 3 5 | |", "3 1 top: 0 1 3 4 | | 0", "3 4 4: 0 1 3 4 5 | | 0 1",  "3 9 nothing: | |"};

TEST(PhysicalGroups, AreThoseOfTheFileInBothVersions) {
  for (const std::string& text : {GROUPS_V2_2, GROUPS_V4_1}) {
    MeshRepairs repairs;
    const TetMesh mesh = read(text, &repairs);
    EXPECT_EQ(mesh.elements, (std::vector<std::array<int, 4>>{{0, 1, 3, 4}, {1, 0, 3, 5}}));
    EXPECT_EQ(asTexts(mesh), GROUPS);
    EXPECT_EQ(repairs.repeated_elements, &text == &GROUPS_V2_2 || text == GROUPS_V2_2 ? 1 : 0);
    EXPECT_EQ(repairs.skipped_elements, 8);
  }
}

TEST(PhysicalGroups, KeepTheirElementsWhenThoseAreTurned) {
  EXPECT_EQ(asTexts(read(replaced(GROUPS_V2_2, "4 2 20 10 30 5", "4 2 10 20 30 5"))), GROUPS);
  EXPECT_EQ(asTexts(read(replaced(GROUPS_V4_1, "10 20 10 30 5", "10 10 20 30 5"))), GROUPS);
}

TEST(PhysicalGroups, FollowTheirElementsWhereARepeatedOneIsLeftOut) {
  // The one between the first element and its repetition moves up.
  const std::string text =
      replaced(replaced(replaced(GROUPS_V2_2, "99 5 5 5", "99 0.2 -1 0.2"), "9 4 2 1 1 10 20 30 40\n", ""),
               "10 4 2 4 2 20 10 30 5\n", "10 4 2 4 2 20 10 30 5\n9 4 2 1 1 40 10 20 30\n11 4 2 6 2 10 20 40 99\n");
  MeshRepairs repairs;
  const TetMesh mesh = read(replaced(text, "$Elements\n11", "$Elements\n12"), &repairs);
  EXPECT_EQ(repairs.repeated_elements, 1);
  ASSERT_EQ(mesh.elements.size(), 3u);
  ASSERT_EQ(mesh.groups.size(), 9u);
  EXPECT_EQ(asText(mesh.groups[5]), "3 1 top: 0 1 3 4 | | 0");
  EXPECT_EQ(asText(mesh.groups[7]), "3 6 6: 0 1 2 4 | | 2");
}

TEST(PhysicalGroups, OfTheFileNeedNoNames) {
  const TetMesh mesh = read(replaced(GROUPS_V4_1, NAMES, ""));
  ASSERT_EQ(mesh.groups.size(), 7u);
  EXPECT_EQ(asText(mesh.groups[0]), "0 1 1: 4 | |");
  EXPECT_EQ(asText(mesh.groups[6]), "3 4 4: 0 1 3 4 5 | | 0 1");
  EXPECT_TRUE(read(replaced(GROUPS_V4_1,
                            GROUPS_V4_1.substr(GROUPS_V4_1.find("$Entities"),
                                               GROUPS_V4_1.find("$Nodes") - GROUPS_V4_1.find("$Entities")),
                            ""))
                  .groups.size() == 5u);  // those that have a name
}

TEST(PhysicalGroups, NamesMayComeLast) {
  const std::string end = "$EndElements\n";
  EXPECT_EQ(asTexts(read(replaced(replaced(GROUPS_V2_2, NAMES, ""), end, end + NAMES))), GROUPS);
}

TEST(PhysicalGroups, WhatIsWrongWithThemIsSaidWithItsLine) {
  const std::vector<std::array<std::string, 4>> spoilt = {
      {"2.2", "0 1 \"tip\"", "4 1 \"tip\"", "a.msh:6: dimension: must be 0, 1, 2 or 3"},
      {"2.2", "0 1 \"tip\"", "0 1 tip", "a.msh:6: the name of the physical group must be in quotes: \"tip\""},
      {"2.2", "0 1 \"tip\"", "0 1 \"", "a.msh:6: the name of the physical group must be in quotes"},
      {"2.2", "0 1 \"tip\"", "0 2147483648 \"tip\"", "a.msh:6: physical group: must be at most 2147483647"},
      {"2.2", "0 1 \"tip\"", "2 1 \"tip\"", "a.msh:7: physical group 1 of dimension 2 has a name already"},
      {"2.2", "$PhysicalNames\n5", "$PhysicalNames\n6", "a.msh:11: $PhysicalNames ends too early"},
      {"2.2", "$PhysicalNames\n5", "$PhysicalNames\n99999", "a.msh:5: number of names: 99999 cannot be in"},
      {"2.2", "5 2 2 1 1 5 30 20", "5 2 2 1 1 5 30 21", "a.msh:27: element 5 uses node 21, which is not among"},
      {"2.2", "5 2 2 1 1 5 30 20", "5 2 2 1 1 5 30 5", "a.msh:27: element 5 uses a node twice"},
      {"2.2", "5 2 2 1 1 5 30 20", "5 2 2 1 1 5 30", "a.msh:27: node is missing"},
      {"2.2", "5 2 2 1 1 5 30 20", "5 2 2 1 1 5 30 20 10", "a.msh:27: the line should have ended"},
      {"2.2", "5 2 2 1 1", "5 2 2 -2147483648 1", "a.msh:27: physical group: \"-2147483648\" must be at least"},
      {"4.1", "1 1 4 2", "1 1 5 2", "a.msh:22: $Entities ends too early"},
      {"4.1", "1 1 4 2", "1 1 99999 2", "a.msh:13: number of entities: 99999 cannot be in"},
      {"4.1", "1 0 0 0 1 1 1 1 -7 2 1 -1", "1 0 0 0 1 1", "a.msh:15: coordinate is missing"},
      {"4.1", "1 0 0 0 1 1 1 1 -7 2 1 -1", "1 0 0 0 1 1 1 3 -7", "a.msh:15: physical group is missing"},
      {"4.1", "$Entities\n1", "$Entitie\n1", "a.msh:12: \"$Entitie\" is never closed"}};
  for (const auto& [version, from, to, error] : spoilt) {
    const std::string what = errorOf(replaced(version == "2.2" ? GROUPS_V2_2 : GROUPS_V4_1, from, to));
    EXPECT_EQ(what.substr(0, error.size()), error) << from << " → " << to;
  }
  EXPECT_EQ(errorOf(GROUPS_V2_2 + NAMES).substr(0, 32), "a.msh:35: $PhysicalNames is give");
  EXPECT_EQ(errorOf(GROUPS_V4_1 + "$Entities\n0 0 0 0\n$EndEntities").find("$Entities is given twice"), 10u);
}

}  // namespace
}  // namespace incision

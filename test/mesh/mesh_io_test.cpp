#include "incision/mesh/mesh_io.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>

#include "incision/base/input_error.h"
#include "support/mesh_text.h"

namespace incision {
namespace {

// Two tetrahedra on either side of the face 10 20 30, a triangle, and the node 99 that no tetrahedron uses.
const std::string V2_2 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
1
3 1 "body"
$EndPhysicalNames
$Nodes
6
10 0 0 0
20 1 0 0
99 5 5 5
30 0 1 0
4000000000000 0 0 1
5 0.25 0.25 -1e0
$EndNodes
$Elements
3
7 2 2 1 1 10 20 30
1 4 2 1 1 10 20 30 4000000000000
3 4 3 1 1 -2 20 10 30 5
$EndElements
)";

// The same mesh; its first block of nodes has parametric coordinates.
const std::string V4_1 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$Entities
0 0 0 1
1 0 0 0 1 1 1 0 0
$EndEntities
$Nodes
2 6 5 4000000000000
2 1 1 2
10
20
0 0 0 0.5 0.5
1 0 0 0.5 0.5
3 1 0 4
99
30
4000000000000
5
5 5 5
0 1 0
0 0 1
0.25 0.25 -1e0
$EndNodes
$Elements
2 3 1 7
2 1 2 1
7 10 20 30
3 1 4 2
1 10 20 30 4000000000000
3 20 10 30 5
$EndElements
)";

/// One thing spoilt in a good file, and what the error must then say.
struct Spoilt {
  std::string from, to, error;
};

void expectErrors(const std::string& good, const std::vector<Spoilt>& spoilt) {
  for (const auto& [from, to, error] : spoilt) {
    const std::string what = errorOf(replaced(good, from, to));
    EXPECT_EQ(what.substr(0, error.size()), error) << "in place of \"" << from << "\": \"" << to << "\"";
  }
}

void expectTheTwoTetrahedra(const TetMesh& mesh, const MeshRepairs& repairs, int repeated = 0) {
  ASSERT_EQ(mesh.nodes.size(), 6u);
  EXPECT_EQ(mesh.nodes[2], Vec3(5, 5, 5));
  EXPECT_EQ(mesh.nodes[5], Vec3(0.25, 0.25, -1));
  EXPECT_EQ(mesh.elements, (std::vector<std::array<int, 4>>{{0, 1, 3, 4}, {1, 0, 3, 5}}));
  EXPECT_EQ(repairs.reoriented, 0);
  EXPECT_EQ(repairs.unreferenced_nodes, 1);
  EXPECT_EQ(repairs.skipped_elements, 1);
  EXPECT_EQ(repairs.repeated_elements, repeated);
  EXPECT_EQ(repairs.coincident_nodes, 0);
}

TEST(MeshIo, BothVersionsGiveTheMeshInTheFilesOrder) {
  for (const std::string& text : {V2_2, V4_1}) {
    MeshRepairs repairs;
    const TetMesh mesh = read(text, &repairs);
    expectTheTwoTetrahedra(mesh, repairs);
  }
}

TEST(MeshIo, LineEndsAndBlankLinesMakeNoDifference) {
  for (const std::string& text : {V2_2, V4_1}) {
    std::string windows;
    for (char c : text) windows += c == '\n' ? std::string(" \t\r\n\r\n") : std::string(1, c);
    MeshRepairs repairs;
    const TetMesh mesh = read(windows, &repairs);
    expectTheTwoTetrahedra(mesh, repairs);
  }
}

TEST(MeshIo, TheLastLineNeedsNoEnd) { EXPECT_EQ(read(V2_2.substr(0, V2_2.size() - 1)).elements.size(), 2u); }

TEST(MeshIo, InvertedElementsAreTurned) {
  MeshRepairs repairs;
  const TetMesh mesh = read(replaced(V2_2, "20 10 30 5", "10 20 30 5"), &repairs);
  EXPECT_EQ(repairs.reoriented, 1);
  for (int e : {0, 1}) EXPECT_GT(elementVolume(mesh, e), 0);
}

TEST(MeshIo, ElementsWithEqualNumbersAreTwo) {
  EXPECT_EQ(read(replaced(V2_2, "3 4 3 1 1 -2", "1 4 3 1 1 -2")).elements.size(), 2u);
  EXPECT_EQ(read(replaced(V4_1, "3 20 10 30 5", "1 20 10 30 5")).elements.size(), 2u);
}

TEST(MeshIo, AnElementThatIsRepeatedCountsOnce) {
  // Also in another order of its nodes.
  const std::string again = "\n1 4 0 10 20 30 4000000000000\n8 4 0 20 30 10 4000000000000\n3 4 3 1 1 -2";
  MeshRepairs repairs;
  const TetMesh mesh = read(replaced(replaced(V2_2, "\n3 4 3 1 1 -2", again), "\n3\n7", "\n5\n7"), &repairs);
  expectTheTwoTetrahedra(mesh, repairs, 2);
}

TEST(MeshIo, TenNodeTetrahedraAreReadByTheirCorners) {
  // Node 99 stands for all of the six in the middles of the edges.
  std::string text =
      replaced(V2_2, "1 4 2 1 1 10 20 30 4000000000000", "1 11 2 1 1 10 20 30 4000000000000 99 99 99 99 99 99");
  MeshRepairs repairs;
  const TetMesh mesh = read(text, &repairs);
  expectTheTwoTetrahedra(mesh, repairs);
  EXPECT_EQ(repairs.second_order_elements, 1);
  EXPECT_EQ(errorOf(replaced(text, "99 99 99 99 99 99", "99 99 99 99 99 98")),
            "a.msh:20: element 1 uses node 98, which is not among the nodes");
}

TEST(MeshIo, TetrahedraOfHigherOrderAreRefusedWithTheCommandThatLowersIt) {
  for (const std::string type : {"29", "30", "31"}) {
    const std::string what = errorOf(replaced(V2_2, "1 4 2 1 1", "1 " + type + " 2 1 1"));
    EXPECT_EQ(what.find("a.msh:20: tetrahedra of "), 0u) << what;
    EXPECT_NE(what.find("gmsh -3 -order 1"), std::string::npos) << what;
  }
}

TEST(MeshIo, ElementsWithAVolumeThatAreNoTetrahedraAreCountedAndRefused) {
  const std::string text = replaced(replaced(V2_2, "\n3\n7", "\n6\n7"), "$EndElements",
                                    "8 6 0 10 20 30 99 99 99\n9 5 0 1 2 3 4 5 6 7 8\n10 18 0 1 2\n$EndElements");
  EXPECT_EQ(errorOf(text).find("a.msh:22: hexahedra: 1, prisms: 2, the first of them here, but only tetrahedra"), 0u)
      << errorOf(text);
  for (int type : {5, 6, 7, 12, 13, 14, 17, 18, 19})
    EXPECT_NE(errorOf(replaced(V4_1, "3 1 4 2", "3 1 " + std::to_string(type) + " 2")).find("only tetrahedra"),
              std::string::npos);
}

TEST(MeshIo, PartsThatTouchWithoutBeingJoinedAreTold) {
  // A third element of its own, at node 10 and near node 20.
  std::string text = replaced(V2_2, "\n6\n10", "\n10\n200 0 0 0\n201 1 1e-10 0\n202 0 -1 0\n203 0 0 -3\n10");
  text = replaced(replaced(text, "\n3\n7", "\n4\n7"), "$EndElements", "9 4 0 200 201 202 203\n$EndElements");
  MeshRepairs repairs;
  read(text, &repairs);
  EXPECT_EQ(repairs.coincident_nodes, 2);
  EXPECT_EQ(repairs.coincident_pair, (std::array<std::int64_t, 2>{200, 10}));
  const std::vector<std::string> said = sentences(repairs);
  const auto joins = [](const std::string& line) { return line.find("Coherence Mesh;") != std::string::npos; };
  EXPECT_EQ(std::count_if(said.begin(), said.end(), joins), 1);
  read(replaced(replaced(text, "200 0 0 0", "200 0 0 -0.1"), "201 1 1e-10 0", "201 1 1e-4 0"), &repairs);
  EXPECT_EQ(repairs.coincident_nodes, 0);
}

TEST(MeshIo, EveryRepairIsASentenceOfItsOwn) {
  EXPECT_TRUE(sentences(MeshRepairs()).empty());
  EXPECT_EQ(sentences({1, 2, 3, 4, 5, 6, {7, 8}}).size(), 5u);  // of skipped surfaces there is nothing to say
}

TEST(MeshIo, NodesAtOnePlaceStayApart) {
  // Node 99 takes the place of node 10 in the second element: a crack along the face between the two.
  const std::string text = replaced(replaced(V2_2, "99 5 5 5", "99 0 0 0"), "20 10 30 5", "20 99 30 5");
  const TetMesh mesh = read(text);
  EXPECT_EQ(mesh.nodes[0], mesh.nodes[2]);
  for (const auto& neighbours : buildTopology(mesh).neighbours)
    EXPECT_EQ(neighbours, (std::array<int, 4>{-1, -1, -1, -1}));
}

TEST(MeshIo, SlenderElementsAreAcceptedAndFlatOnesRefused) {
  EXPECT_EQ(read(replaced(V2_2, "4000000000000 0 0 1", "4000000000000 0 0 1e-6")).elements.size(), 2u);
  for (const std::string height : {"0", "1e-14", "-1e-14"})
    EXPECT_EQ(errorOf(replaced(V2_2, "4000000000000 0 0 1", "4000000000000 0 0 " + height)).substr(0, 38),
              "a.msh:20: element 1 is degenerate: it ");
}

TEST(MeshIo, ElementsTooSmallForTheirVolumeToBeANumberAreRefused) {
  std::string text = replaced(V2_2, "20 1 0 0", "20 1e-108 0 0");
  text = replaced(text, "30 0 1 0", "30 0 1e-108 0");
  text = replaced(text, "4000000000000 0 0 1", "4000000000000 0 0 1e-107");
  EXPECT_EQ(errorOf(text).substr(0, 37), "a.msh:20: element 1 is degenerate: it");
}

TEST(MeshIo, TheFormatMustBeOneThatIsRead) {
  expectErrors(V2_2, {{"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", "", "a.msh:5: $Nodes is given twice or out of order"},
                      {"$MeshFormat", "# vtk DataFile", "a.msh:1: a VTK file"},
                      {"2.2 0 8", "2.2 1 8", "a.msh:2: the file is binary"},
                      {"2.2 0 8", "4.0 0 8", "a.msh:2: this is another version"},
                      {"2.2 0 8", "nan 0 8", "a.msh:2: version: \"nan\" is not a finite number"},
                      {"2.2 0 8", "2.2 0", "a.msh:2: data size is missing"},
                      {"2.2 0 8", "2.2 0 8 8", "a.msh:2: the line should have ended before \"8\""},
                      {"$EndMeshFormat", "$Nodes", "a.msh:3: expected $EndMeshFormat"}});
  EXPECT_EQ(errorOf("$Comments\n$EndComments\n"), "a.msh:2: the file ends without a section $MeshFormat");
}

TEST(MeshIo, SectionsMustBeWholeAndInOrder) {
  const std::size_t nodes = V2_2.find("$Nodes"), elements = V2_2.find("$Elements");
  EXPECT_EQ(errorOf(V2_2.substr(0, nodes)), "a.msh:7: the file ends without a section $Nodes");
  EXPECT_EQ(errorOf(V2_2.substr(0, elements)), "a.msh:16: the file ends without a section $Elements");
  EXPECT_EQ(errorOf(V2_2 + V2_2.substr(elements)).substr(0, 34), "a.msh:23: $Elements is given twice");
  EXPECT_EQ(errorOf(V2_2 + "rubbish"),
            "a.msh:23: expected a section of a Gmsh ASCII file, such as $Comments, not \"rubbish\"");
  EXPECT_EQ(errorOf(V2_2 + "$NodeData\n1\n"), "a.msh:23: \"$NodeData\" is never closed by \"$EndNodeData\"");
}

TEST(MeshIo, AFileCutOffAnywhereIsRefused) {
  for (const std::string& text : {V2_2, V4_1}) {
    const std::size_t whole = text.rfind("$EndElements") + std::string("$EndElements").size();
    for (std::size_t size = 0; size < whole; ++size)
      EXPECT_EQ(errorOf(text.substr(0, size)).substr(0, 6), "a.msh:") << "after " << size << " bytes";
  }
}

TEST(MeshIo, CountsAreHeldAgainstTheFile) {
  expectErrors(V2_2,
               {{"\n6\n", "\n5\n", "a.msh:15: expected $EndNodes, not \"5 0.25"},
                {"\n6\n", "\n7\n", "a.msh:16: $Nodes ends too early"},
                {"\n6\n", "\n2000000000\n", "a.msh:9: number of nodes: 2000000000 cannot be in the "},
                {"\n6\n", "\n9223372036854775807\n", "a.msh:9: number of nodes: 9223372036854775807 cannot be"},
                {"\n6\n", "\n9223372036854775808\n", "a.msh:9: number of nodes: \"9223372036854775808\" does not"},
                {"\n6\n", "\n-6\n", "a.msh:9: number of nodes: \"-6\" must be at least 0"},
                {"\n6\n", "\n6.0\n", "a.msh:9: number of nodes: \"6.0\" is not a whole number"},
                {"\n3\n7", "\n2\n7", "a.msh:21: expected $EndElements"},
                {"\n3\n7", "\n4\n7", "a.msh:22: $Elements ends too early"},
                {"\n3\n7", "\n99999999\n7", "a.msh:18: number of elements: 99999999 cannot be"}});
}

TEST(MeshIo, BadNodesAreRefused) {
  expectErrors(V2_2, {{"20 1 0 0", "20 nan 0 0", "a.msh:11: x: \"nan\" is not a finite number"},
                      {"20 1 0 0", "20 1 -inf 0", "a.msh:11: y: \"-inf\" is not a finite number"},
                      {"20 1 0 0", "20 1 0 1e999", "a.msh:11: z: \"1e999\" is not a finite number"},
                      {"20 1 0 0", "20 1 0 2e9", "a.msh:11: coordinates must be within 1e9 of"},
                      {"20 1 0 0", "20 1 0 0x1", "a.msh:11: z: \"0x1\" is not a number"},
                      {"20 1 0 0", "20 1 0 1,5", "a.msh:11: z: \"1,5\" is not a number"},
                      {"20 1 0 0", "20 1 0", "a.msh:11: z is missing at the end of the line"},
                      {"20 1 0 0", "20 1 0 0 0", "a.msh:11: the line should have ended before \"0\""},
                      {"20 1 0 0", "10 1 0 0", "a.msh:11: node 10 is given twice"},
                      {"20 1 0 0", "0 1 0 0", "a.msh:11: node: \"0\" must be at least 1"},
                      {"20 1 0 0", "-20 1 0 0", "a.msh:11: node: \"-20\" must be at least 1"},
                      {"20 1 0 0", "2e1 1 0 0", "a.msh:11: node: \"2e1\" is not a whole number"},
                      {"20 1 0 0", "\x01\xff 1 0 0", "a.msh:11: node: \"\?\?\" is not a whole number"}});
}

TEST(MeshIo, BadElementsAreRefused) {
  const std::string second = "3 4 3 1 1 -2 20 10 30 5";
  expectErrors(V2_2, {{second, "3 4 2 1 1 20 10 30 6", "a.msh:21: element 3 uses node 6, which is not among the nodes"},
                      {second, "3 4 2 1 1 20 10 20 5", "a.msh:21: element 3 uses node 20 twice"},
                      {second, "3 4 2 1 1 20 10 30", "a.msh:21: node is missing at the end of the line"},
                      {second, "3 4 2 1 1 20 10 30 5 5", "a.msh:21: the line should have ended before \"5\""},
                      {second, "3 4 9223372036854775807 1 1 20 10 30 5", "a.msh:21: tag is missing"},
                      {second, "3 4 -1 20 10 30 5", "a.msh:21: number of tags: \"-1\" must be at least 0"},
                      {second, "3 71 2 1 1 20 10 30 5", "a.msh:21: element type 71 is none that can be read"},
                      {second, "3 4 0 10 20 30 99",
                       "a.msh:21: element 3 overlaps element 1 in line 20: they lie on the same side of the face of "
                       "nodes 10 20 30"}});
}

TEST(MeshIo, AFaceOfThreeElementsIsNamedByItsLastLine) {
  std::string text = replaced(V2_2, "\n3\n7", "\n4\n7");
  text = replaced(text, "$EndElements", "9 4 0 10 20 30 99\n$EndElements");
  EXPECT_EQ(
      errorOf(text),
      "a.msh:22: element 9 shares the face of nodes 10 20 30 with element 1 in line 20 and element 3 in line 21: a "
      "face belongs to one element or two");
}

TEST(MeshIo, AMeshWithoutTetrahedraIsRefused) {
  const std::size_t elements = V2_2.find("$Elements");
  const std::string head = V2_2.substr(0, elements);
  EXPECT_EQ(errorOf(head + "$Elements\n1\n7 2 0 10 20 30\n$EndElements").substr(0, 67),
            "a.msh:20: no tetrahedra among 1 elements: did gmsh report errors? (");
  EXPECT_EQ(errorOf(head + "$Elements\n0\n$EndElements").substr(0, 67),
            "a.msh:19: no tetrahedra among 0 elements: did gmsh report errors? (");
}

TEST(MeshIo, BlocksOfVersion41MustAddUp) {
  expectErrors(V4_1, {{"2 6 5", "2 7 5", "a.msh:23: 1 of the nodes announced are missing"},
                      {"2 6 5", "2 5 5", "a.msh:15: the block has 4 items, but only 3 are left"},
                      {"2 6 5", "1 6 5", "a.msh:14: 4 of the nodes announced are missing"},
                      {"2 6 5", "3 6 5", "a.msh:24: $Nodes ends too early"},
                      {"2 6 5", "99999999 6 5", "a.msh:9: number of blocks: 99999999 cannot be"},
                      {"2 6 5", "2 99999999 5", "a.msh:9: number of items: 99999999 cannot be"},
                      {"2 1 1 2", "2 1 2 2", "a.msh:10: parametric: must be 0 or 1"},
                      {"2 1 1 2", "4 1 1 2", "a.msh:10: dimension of the entity: must be 0, 1, 2 or 3"},
                      {"2 1 1 2", "2 1 0 2", "a.msh:13: the line should have ended before \"0.5 0.5\""},
                      {"2 1 1 2", "2 1 1 -2", "a.msh:10: items in the block: \"-2\" must be at least 0"},
                      {"10\n20\n", "10\n10\n", "a.msh:14: node 10 is given twice"},
                      {"10\n20\n", "10 20\n20\n", "a.msh:11: the line should have ended before \"20\""},
                      {"2 3 1 7", "2 4 1 7", "a.msh:31: 1 of the elements announced are missing"},
                      {"2 3 1 7", "2 2 1 7", "a.msh:29: the block has 2 items, but only 1 are left"},
                      {"3 1 4 2", "3 1 4 1", "a.msh:30: 1 of the elements announced are missing"},
                      {"3 1 4 2", "2 1 4 2", "a.msh:29: dimension of the entity: 2, but its elements are tetrahedra"},
                      {"3 1 4 2", "3 1 11 2", "a.msh:30: node is missing at the end of the line"}});
}

TEST(MeshIo, FilesThatCannotBeReadAreNamed) {
  EXPECT_THROW(readGmsh("/no/such/file.msh"), InputError);
  EXPECT_THROW(readGmsh(std::filesystem::temp_directory_path().string()), InputError);
}

TEST(MeshIo, ShippedMeshesReadWithoutRepairs) {
  const auto root = std::filesystem::path(__FILE__).parent_path().parent_path().parent_path();
  const std::map<std::string, std::size_t> elements = {
      {"organ", 5909}, {"animal", 3930}, {"figure", 1319}, {"liver", 12757}};
  for (const auto& [name, count] : elements) {
    MeshRepairs repairs;
    const TetMesh mesh = readGmsh((root / "config/meshes" / (name + ".msh")).string(), &repairs);
    EXPECT_EQ(mesh.elements.size(), count) << name;
    EXPECT_EQ(repairs.reoriented + repairs.unreferenced_nodes + repairs.skipped_elements, 0) << name;
  }
}

}  // namespace
}  // namespace incision

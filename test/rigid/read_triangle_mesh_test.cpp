#include "incision/rigid/read_triangle_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "incision/base/input_error.h"
#include "support/solid_meshes.h"

namespace incision::test {
namespace {

Eigen::AlignedBox3d boxRound(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& vertex : mesh.vertices) box.extend(vertex);
  return box;
}

void expectAngle(const TriangleMesh& mesh, double scale) {
  EXPECT_EQ(mesh.triangles.size(), angleMesh().triangles.size());
  EXPECT_LT((boxRound(mesh).min() - scale * boxRound(angleMesh()).min()).norm(), 1e-6 * scale);
  EXPECT_LT((boxRound(mesh).max() - scale * boxRound(angleMesh()).max()).norm(), 1e-6 * scale);
  EXPECT_NEAR(volumeOf(mesh), std::pow(scale, 3) * volumeOf(angleMesh()), 1e-6 * std::pow(scale, 3));
}

std::string refusalOf(const std::string& bytes, const std::string& format) {
  try {
    parseTriangleMesh(bytes, format);
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "";
}

TEST(ReadTriangleMesh, AllFormatsGiveTheSameTriangles) {
  expectAngle(parseTriangleMesh(asTextStl(angleMesh()), ".stl"), 1);
  expectAngle(parseTriangleMesh(asBinaryStl(angleMesh()), ".stl"), 1);
  expectAngle(parseTriangleMesh(asObj(angleMesh()), ".obj"), 1);
  expectAngle(parseTriangleMesh(asCollada(angleMesh()), ".dae"), 1);
}

TEST(ReadTriangleMesh, CutsPolygonsIntoTriangles) {
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nl 1 3\np 2\n";
  EXPECT_EQ(parseTriangleMesh(obj, ".obj").triangles.size(), 2u);
}

TEST(ReadTriangleMesh, TakesColladasUnitAndNotItsUpAxis) {
  for (const char* up : {"X_UP", "Y_UP", "Z_UP"}) {
    SCOPED_TRACE(up);
    expectAngle(
        parseTriangleMesh(asCollada(angleMesh(), 0.001, "<node><instance_geometry url='#g'/></node>", up), ".dae"),
        0.001);
  }
}

TEST(ReadTriangleMesh, PutsColladasNodesWhereTheyStand) {
  const std::string geometry = "<instance_geometry url='#g'/>";
  const TriangleMesh nested = parseTriangleMesh(
      asCollada(angleMesh(), 0.01,
                "<node id='a'><translate>100 0 0</translate><rotate>0 0 1 90</rotate><node id='b'><scale>2 2 2</scale>"
                "<translate>0 0 50</translate>" +
                    geometry + "</node></node>"),
      ".dae");
  // (x, y, z) goes to (1 − 2y, 2x, 2z + 1) of centimetres made metres.
  EXPECT_LT((boxRound(nested).min() - Vec3(1 - 0.02, 0, 1)).norm(), 1e-6);
  EXPECT_LT((boxRound(nested).max() - Vec3(1, 0.02, 1.008)).norm(), 1e-6);
}

TEST(ReadTriangleMesh, TakesEveryInstanceOfANode) {
  const std::string library =
      "<library_nodes><node id='twice'><node id='c'><instance_geometry url='#g'/></node>"
      "<node id='d'><translate>3 0 0</translate><instance_geometry url='#g'/></node></node></library_nodes>";
  const std::string nodes =
      "<node id='a'><instance_node url='#twice'/></node>"
      "<node id='b'><translate>0 5 0</translate><instance_node url='#twice'/></node>";
  const TriangleMesh four = parseTriangleMesh(asCollada(angleMesh(), 1, nodes, "Z_UP", library), ".dae");
  EXPECT_EQ(four.triangles.size(), 4 * angleMesh().triangles.size());
  EXPECT_LT((boxRound(four).max() - Vec3(4, 6, 0.4)).norm(), 1e-6);
}

TEST(ReadTriangleMesh, InstancesThatGoInACircleAreRefused) {
  const std::string circle =
      "<library_nodes><node id='x'><instance_node url='#y'/></node><node id='y'><node><instance_node url='#x'/></node>"
      "</node></library_nodes>";
  EXPECT_EQ(refusalOf(asCollada(angleMesh(), 1, "<node><instance_node url='#x'/></node>", "Z_UP", circle), ".dae")
                .find("has nodes that go in a circle"),
            0u);
}

TEST(ReadTriangleMesh, InstancesThatMultiplyAreRefused) {
  std::string library = "<library_nodes><node id='n0'><instance_geometry url='#g'/></node>";
  for (int i = 1; i < 40; ++i) {
    const std::string instance = "<instance_node url='#n" + std::to_string(i - 1) + "'/>";
    library += "<node id='n" + std::to_string(i) + "'>" + instance + instance + "</node>";
  }
  EXPECT_EQ(refusalOf(asCollada(angleMesh(), 1, "<node><instance_node url='#n39'/></node>", "Z_UP",
                                library + "</library_nodes>"),
                      ".dae"),
            "has too many nodes (allowed: up to 100000)");
}

TEST(ReadTriangleMesh, DeepNestingDoesNotExhaustTheStack) {
  std::string nodes;
  for (int i = 0; i < 200'000; ++i) nodes += "<node>";
  EXPECT_EQ(refusalOf(asCollada(angleMesh(), 1, nodes), ".dae"),
            "has elements too deep in others (allowed: up to 200)");
}

TEST(ReadTriangleMesh, WhatIsNoMeshIsRefusedInOneLine) {
  for (const char* format : {".stl", ".obj", ".dae"})
    for (const std::string& bytes : {std::string(), std::string("\0\0\0", 3), std::string("no mesh\nat all"),
                                     asBinaryStl(angleMesh()).substr(0, 120), std::string("solid s\nendsolid s\n")})
      EXPECT_NE(refusalOf(bytes, format), "") << format << " " << bytes;
  EXPECT_EQ(refusalOf("", ".wrl"), "is of no format that is read (allowed: .stl, .obj or .dae)");
}

TEST(ReadTriangleMesh, AHeaderThatPromisesMoreThanThereIsIsRefused) {
  std::string bytes = asBinaryStl(angleMesh());
  for (int i = 80; i < 84; ++i) bytes[static_cast<std::size_t>(i)] = '\xff';
  EXPECT_NE(refusalOf(bytes, ".stl"), "");
}

TEST(ReadTriangleMesh, ACountThatFitsOnlyIn32BitsIsRefused) {
  std::string bytes = asBinaryStl(angleMesh());
  bytes[83] = static_cast<char>(bytes[83] | 0x80);
  EXPECT_EQ(refusalOf(bytes, ".stl"), "has a count of " + std::to_string((1U << 31) + angleMesh().triangles.size()) +
                                          " triangles, for which it is too short");
}

TEST(ReadTriangleMesh, ColladasCountsOfMoreThanTheTextHoldsAreRefused) {
  const std::string good = asCollada(angleMesh());
  for (const char* number : {"4294967295", "-15", "99999999999999999999999", "&#57;9", " 9", "0x1"})
    for (std::size_t at = good.find("count='"); at != std::string::npos; at = good.find("count='", at + 1)) {
      std::string bad = good;
      const std::size_t begin = at + std::string("count='").size();
      bad.replace(begin, bad.find('\'', begin) - begin, number);
      EXPECT_EQ(refusalOf(bad, ".dae").find("has the count '"), 0u) << number;
    }
  for (const char* corners : {"4 9000000000", "4 1000 1000 1000", "4 -4"}) {
    std::string bad = good;
    bad.insert(bad.find("<p>"), std::string("<vcount>") + corners + "</vcount>");
    EXPECT_NE(refusalOf(bad, ".dae").find("vcount '"), std::string::npos) << corners;
  }
  std::string bad = good;
  bad.replace(bad.find("stride='3'"), std::string("stride='3'").size(), "stride='4000000000'");
  EXPECT_EQ(refusalOf(bad, ".dae"), "has the stride '4000000000' (allowed: whole numbers up to 1000)");
}

TEST(ReadTriangleMesh, ColladasIndicesThatAreNoNumbersAreRefused) {
  const std::string good = asCollada(angleMesh());
  for (const char* wrong : {"x", "\xff", "&#49;", "<!-- -->", "1.5", "<p>"}) {
    std::string bad = good;
    bad.insert(bad.find("<p>") + std::string("<p>0 ").size(), wrong);
    EXPECT_EQ(refusalOf(bad, ".dae").find("has indices <p> with '"), 0u) << wrong;
  }
}

TEST(ReadTriangleMesh, VerticesThatAreNotFiniteAreRefused) {
  TriangleMesh bad = angleMesh();
  bad.vertices[3].y() = std::nan("");
  EXPECT_EQ(refusalOf(asBinaryStl(bad), ".stl"), "has a vertex that is not finite (allowed: numbers)");
  bad.vertices[3].y() = 1e300;
  EXPECT_EQ(refusalOf(asBinaryStl(bad), ".stl"), "has a vertex that is not finite (allowed: numbers)");
}

TEST(ReadTriangleMesh, MoreTrianglesThanTheLimitAreRefused) {
  std::string bytes = asBinaryStl(angleMesh());
  const std::string triangle = bytes.substr(84, 50);
  const auto count = static_cast<std::uint32_t>(MAX_TRIANGLES + 1);
  std::memcpy(&bytes[80], &count, sizeof count);
  bytes.resize(84);
  for (std::uint32_t i = 0; i < count; ++i) bytes += triangle;
  EXPECT_EQ(refusalOf(bytes, ".stl"), "has too many triangles (allowed: up to 1000000)");
}

}  // namespace
}  // namespace incision::test

// What gmsh itself makes of geometries and of STL files.
#include <gtest/gtest.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "incision/base/input_error.h"
#include "incision/mesh/mesh_io.h"
#include "incision/mesh/place.h"

namespace incision {
namespace {

namespace fs = std::filesystem;

/// A folder of the test's own, in which gmsh runs.
class Gmsh : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("gmsh --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "needs gmsh";
    folder_ = fs::path(::testing::TempDir()) / ("gmsh_" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override {
    if (!folder_.empty()) fs::remove_all(folder_);
  }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  void write(const std::string& name, const std::string& text) const { std::ofstream(file(name)) << text; }

  /// Whether gmsh did what it was asked for.
  bool gmsh(const std::string& arguments) const {
    return std::system(("cd '" + folder_.string() + "' && gmsh -v 1 " + arguments + " > log.txt 2>&1").c_str()) == 0;
  }

  fs::path folder_;
};

/// A triangle of an STL file; its normal is not looked at.
void writeTriangle(std::ostream& out, const Vec3& a, const Vec3& b, const Vec3& c) {
  out << "facet normal 0 0 0\nouter loop\n";
  for (const Vec3& X : {a, b, c}) out << "vertex " << X.x() << ' ' << X.y() << ' ' << X.z() << '\n';
  out << "endloop\nendfacet\n";
}

/// A sphere in bands of triangles, as STL.
std::string sphere(const Vec3& centre, double radius) {
  constexpr int BANDS = 10, SLICES = 20;
  std::ostringstream out;
  out.precision(12);
  const auto point = [&](int band, int slice) -> Vec3 {
    const double theta = M_PI * band / BANDS, phi = 2 * M_PI * (slice % SLICES) / SLICES;
    const double flat = band % BANDS == 0 ? 0 : std::sin(theta);
    return centre + radius * Vec3(flat * std::cos(phi), flat * std::sin(phi), std::cos(theta));
  };
  for (int b = 0; b < BANDS; ++b)
    for (int s = 0; s < SLICES; ++s) {
      if (b + 1 < BANDS) writeTriangle(out, point(b, s), point(b + 1, s), point(b + 1, s + 1));
      if (b > 0) writeTriangle(out, point(b, s), point(b + 1, s + 1), point(b, s + 1));
    }
  return out.str();
}

double volumeOf(const TetMesh& mesh, const std::vector<int>& elements) {
  double volume = 0;
  for (int e : elements) volume += elementVolume(mesh, e);
  return volume;
}

double volumeOf(const TetMesh& mesh) {
  double volume = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) volume += elementVolume(mesh, static_cast<int>(e));
  return volume;
}

double ball(double radius) { return 4 * M_PI / 3 * radius * radius * radius; }

Place group(const std::string& name) {
  Place place;
  place.group = name;
  return place;
}

/// Two cubes that share a face, with groups of every dimension, some of which overlap.
const std::string CUBES = R"(
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Box(2) = {1, 0, 0, 1, 1, 1};
Coherence;
Physical Volume("left") = {1};
Physical Volume("both") = {1, 2};
left() = Surface In BoundingBox {-0.1, -0.1, -0.1, 0.1, 1.1, 1.1};
Physical Surface("wall") = {left()};
Physical Surface("turned wall") = {-left(0)};
Physical Curve(7) = Curve In BoundingBox {-0.1, -0.1, -0.1, 0.1, 1.1, 0.1};
Physical Point("corner") = Point In BoundingBox {-0.1, -0.1, -0.1, 0.1, 0.1, 0.1};
Mesh.MeshSizeMin = 0.5;
Mesh.MeshSizeMax = 0.5;
)";

TEST_F(Gmsh, GroupsAreThoseOfTheGeometryInBothVersionsAndOrders) {
  write("cubes.geo", CUBES);
  for (const std::string options :
       {"-format msh22", "-format msh41", "-format msh22 -order 2", "-format msh41 -order 2"}) {
    ASSERT_TRUE(gmsh("-3 cubes.geo -o cubes.msh " + options));
    MeshRepairs repairs;
    const TetMesh mesh = readGmsh(file("cubes.msh"), &repairs);
    const MeshTopology topology = buildTopology(mesh);
    const bool second_order = options.find("order") != std::string::npos,
               repeats = options.find("22") != std::string::npos;
    EXPECT_NEAR(volumeOf(mesh), 2, 1e-12) << options;
    EXPECT_NEAR(volumeOf(mesh, elementsAt(group("left"), mesh)), 1, 1e-12) << options;
    EXPECT_NEAR(volumeOf(mesh, elementsAt(group("both"), mesh)), 2, 1e-12) << options;
    EXPECT_EQ(repairs.repeated_elements > 0, repeats) << options;
    EXPECT_EQ(repairs.second_order_elements > 0, second_order) << options;
    EXPECT_EQ(repairs.unreferenced_nodes > 0, second_order) << options;
    for (const std::string name : {"wall", "turned wall"}) {
      std::vector<std::pair<int, int>> faces, in_box;
      for (const auto& [e, f] : boundaryFacesAt(group(name), mesh, topology)) faces.emplace_back(e, f);
      for (const auto& [e, f] : boundaryFacesAt(Place(Vec3(-1, -1, -1), Vec3(1e-9, 2, 2)), mesh, topology))
        in_box.emplace_back(e, f);
      EXPECT_FALSE(faces.empty());
      EXPECT_EQ(faces, in_box) << options;
    }
    EXPECT_EQ(nodesAt(group("7"), mesh).size(), 3u) << options;
    for (int n : nodesAt(group("7"), mesh)) EXPECT_EQ(mesh.nodes[n].head<1>()[0], 0);
    ASSERT_EQ(nodesAt(group("corner"), mesh).size(), 1u) << options;
    EXPECT_EQ(mesh.nodes[nodesAt(group("corner"), mesh)[0]], Vec3(0, 0, 0));
  }
}

TEST_F(Gmsh, TheCommandsThatErrorsNameMakeMeshesThatCanBeRead) {
  write("cubes.geo", CUBES);
  ASSERT_TRUE(gmsh("-3 cubes.geo -o good.msh -format msh41"));
  for (const std::string options : {"-format msh1", "-format msh40", "-format msh22 -bin", "-format msh41 -bin"}) {
    ASSERT_TRUE(gmsh("good.msh -save -o in.msh " + options));
    EXPECT_THROW(readGmsh(file("in.msh")), InputError) << options;
    ASSERT_TRUE(gmsh("in.msh -save -format msh22 -o out.msh"));
    EXPECT_NEAR(volumeOf(readGmsh(file("out.msh"))), 2, 1e-12) << options;
  }
  ASSERT_TRUE(gmsh("-3 -order 3 cubes.geo -o in.msh -format msh41"));
  EXPECT_THROW(readGmsh(file("in.msh")), InputError);
}

TEST_F(Gmsh, PartsThatTouchAreJoinedByTheHintsCommand) {
  std::string apart = CUBES;
  apart.replace(apart.find("Coherence;"), 10, "");
  write("apart.geo", apart);
  ASSERT_TRUE(gmsh("-3 apart.geo -o in.msh -format msh22"));
  MeshRepairs repairs;
  readGmsh(file("in.msh"), &repairs);
  EXPECT_GE(repairs.coincident_nodes, 9);
  write("join.geo", "Merge \"in.msh\"; Coherence Mesh;\n");
  ASSERT_TRUE(gmsh("join.geo -save -format msh22 -o out.msh"));
  EXPECT_NEAR(volumeOf(readGmsh(file("out.msh"), &repairs)), 2, 1e-12);
  EXPECT_EQ(repairs.coincident_nodes, 0);
}

/// With the script for STL files.
class StlToMesh : public Gmsh {
 protected:
  /// Runs the script on these shells, given in centimetres. Whether gmsh met no error.
  bool fill(const std::string& shells) const {
    write("surface.stl", "solid s\n" + shells + "endsolid s\n");
    std::stringstream script;
    script << std::ifstream(std::string(INCISION_SOURCE_DIR) + "/config/meshes/stl_to_mesh.geo").rdbuf();
    std::string text = script.str();
    set("UNIT = 1;", "UNIT = 0.01;", &text);
    set("ELEMENT_SIZE = 0.008;", "ELEMENT_SIZE = 0.002;", &text);
    write("stl_to_mesh.geo", text);
    return gmsh("-3 -format msh22 stl_to_mesh.geo -o body.msh");
  }

  TetMesh meshOf(const std::string& shells) const {
    EXPECT_TRUE(fill(shells));
    return readGmsh(file("body.msh"));
  }

 private:
  static void set(const std::string& from, const std::string& to, std::string* text) {
    const std::size_t at = text->find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text->replace(at, from.size(), to);
  }
};

/// A sphere's facets leave out some of it: 5 % of ten bands, and a little more once it is meshed anew.
constexpr double LEFT_OUT = 0.1;

void expectVolume(const TetMesh& mesh, double cubic_centimetres) {
  EXPECT_NEAR(volumeOf(mesh) * 1e6, cubic_centimetres, LEFT_OUT * cubic_centimetres);
}

TEST_F(StlToMesh, ASphereIsFilled) { expectVolume(meshOf(sphere(Vec3::Zero(), 1)), ball(1)); }

TEST_F(StlToMesh, TwoSpheresAreTwoBodies) {
  const TetMesh mesh = meshOf(sphere(Vec3::Zero(), 1) + sphere(Vec3(3, 0.3, 0), 0.8));
  expectVolume(mesh, ball(1) + ball(0.8));
}

TEST_F(StlToMesh, ASphereInAnotherIsACavity) {
  const double solid = volumeOf(meshOf(sphere(Vec3::Zero(), 1)));
  const double hollow = volumeOf(meshOf(sphere(Vec3::Zero(), 1) + sphere(Vec3(0.1, 0, 0), 0.6)));
  EXPECT_NEAR((solid - hollow) * 1e6, ball(0.6), LEFT_OUT * ball(0.6));
}

TEST_F(StlToMesh, ASphereInACavityIsABodyAgainBesideAnother) {
  const TetMesh mesh = meshOf(sphere(Vec3(3, 0, 0), 0.9) + sphere(Vec3(0.1, 0, 0), 0.4) + sphere(Vec3::Zero(), 1) +
                              sphere(Vec3(0.1, 0, 0), 0.7));
  expectVolume(mesh, ball(0.9) + ball(1) - ball(0.7) + ball(0.4));
}

TEST_F(StlToMesh, WhatIsNotClosedIsAnErrorOfGmshThatTheReaderAsksFor) {
  const std::string closed = sphere(Vec3::Zero(), 1);
  EXPECT_FALSE(fill(closed.substr(closed.find("facet normal", 1))));  // a triangle is missing
  try {
    readGmsh(file("body.msh"));
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did gmsh report errors?"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace incision

#include "incision/rigid/closed_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>

#include "incision/base/input_error.h"
#include "support/solid_meshes.h"

namespace incision::test {
namespace {

struct Closed {
  ClosedMesh mesh;
  std::string remark;
};
Closed closed(const TriangleMesh& mesh) {
  Closed closed;
  closed.mesh = closeMesh(mesh, &closed.remark);
  return closed;
}

/// Whether every triangle has neighbours that have it as theirs, along the same edge the other way round.
bool isWhole(const ClosedMesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto other = static_cast<std::size_t>(mesh.neighbours[t][k]);
      bool mutual = false;
      for (int l = 0; l < 3; ++l)
        mutual = mutual || (mesh.neighbours[other][l] == static_cast<int>(t) &&
                            mesh.triangles[other][l] == mesh.triangles[t][(k + 1) % 3] &&
                            mesh.triangles[other][(l + 1) % 3] == mesh.triangles[t][k]);
      if (!mutual) return false;
    }
  return true;
}

/// Each triangle with vertices of its own, as STL has them.
TriangleMesh soupOf(const TriangleMesh& mesh) {
  TriangleMesh soup;
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    const int first = static_cast<int>(soup.vertices.size());
    for (const int v : triangle) soup.vertices.push_back(mesh.vertices[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

std::string refusalOf(const TriangleMesh& mesh) {
  try {
    closed(mesh);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const TriangleMesh LONG_BOX = boxMesh(Vec3(1, 2, 3));

TEST(ClosedMesh, JoinsTheVerticesOfAFileThatRepeatsThem) {
  TriangleMesh soup = soupOf(LONG_BOX);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> rounding(-1e-7, 1e-7);
  for (Vec3& vertex : soup.vertices) vertex += Vec3(rounding(random), rounding(random), rounding(random));
  const Closed box = closed(soup);
  EXPECT_EQ(box.mesh.vertices.size(), 8u);
  EXPECT_EQ(box.mesh.triangles.size(), 12u);
  EXPECT_TRUE(isWhole(box.mesh));
  EXPECT_EQ(box.remark, "");
}

TEST(ClosedMesh, LooksOutwardsHoweverTheFileTurnsItsTriangles) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    std::mt19937 random(seed);
    TriangleMesh mesh = seed == 1 ? LONG_BOX : torusMesh(1, 0.3, 10);
    for (std::array<int, 3>& triangle : mesh.triangles)
      if (seed == 2 || random() % 2 == 0) std::swap(triangle[0], triangle[1]);
    const Closed turned = closed(mesh);
    EXPECT_TRUE(isWhole(turned.mesh));
    EXPECT_GT(volumeOf(turned.mesh), seed == 1 ? 5.999 : 1.5);
    EXPECT_EQ(turned.remark, "");
  }
}

TEST(ClosedMesh, WhatIsThereTwiceCountsOnce) {
  const Closed twice = closed(together({LONG_BOX, LONG_BOX}));
  EXPECT_EQ(twice.mesh.triangles.size(), 12u);
  EXPECT_NEAR(volumeOf(twice.mesh), 6, 1e-12);
}

TEST(ClosedMesh, ACavityIsFilled) {
  TriangleMesh inner = boxMesh(Vec3(0.5, 0.5, 0.5));
  for (std::array<int, 3>& triangle : inner.triangles) std::swap(triangle[0], triangle[1]);
  const Closed hollow = closed(together({LONG_BOX, inner}));
  EXPECT_EQ(hollow.mesh.shells(), 2);
  EXPECT_NEAR(volumeOf(hollow.mesh), 6 + 0.125, 1e-12);
}

TEST(ClosedMesh, CubesThatMeetAtAnEdgeOrACornerStayTwo) {
  for (const Vec3& place : {Vec3(1, 1, 0), Vec3(1, 1, 1)}) {
    const Closed cubes = closed(together({boxMesh(Vec3(1, 1, 1)), boxMesh(Vec3(1, 1, 1), place)}));
    EXPECT_EQ(cubes.mesh.shells(), 2);
    EXPECT_EQ(cubes.mesh.vertices.size(), 16u);
    EXPECT_TRUE(isWhole(cubes.mesh));
    EXPECT_EQ(cubes.remark, "");
  }
}

TEST(ClosedMesh, ClosesHolesAndSaysSo) {
  TriangleMesh open = LONG_BOX;
  open.triangles.erase(open.triangles.begin());
  const Closed three = closed(open);
  EXPECT_TRUE(isWhole(three.mesh));
  EXPECT_NEAR(volumeOf(three.mesh), 6, 1e-12);
  EXPECT_EQ(three.remark, "1 hole closed, the widest 2.23607 m");

  TriangleMesh cut = sphereMesh(1, 20);
  const auto is_high = [&](const std::array<int, 3>& t) {
    return cut.vertices[t[0]].z() > 0.6 && cut.vertices[t[1]].z() > 0.6 && cut.vertices[t[2]].z() > 0.6;
  };
  cut.triangles.erase(std::remove_if(cut.triangles.begin(), cut.triangles.end(), is_high), cut.triangles.end());
  const Closed flat = closed(cut);
  EXPECT_TRUE(isWhole(flat.mesh));
  EXPECT_EQ(flat.remark.find("1 hole closed, the widest "), 0u) << flat.remark;
  EXPECT_LT(volumeOf(flat.mesh), 4.0);
}

TEST(ClosedMesh, AVertexOnAnotherTrianglesEdgeLeavesNoGap) {
  // The upper face's diagonal is halved on one side only.
  TriangleMesh mesh = boxMesh(Vec3(1, 1, 1));
  const int middle = static_cast<int>(mesh.vertices.size());
  mesh.vertices.emplace_back(0, 0, 0.5);
  auto face = std::find(mesh.triangles.begin(), mesh.triangles.end(), std::array<int, 3>{4, 5, 6});
  ASSERT_NE(face, mesh.triangles.end());
  *face = {4, 5, middle};
  mesh.triangles.push_back({5, 6, middle});
  const Closed box = closed(mesh);
  EXPECT_TRUE(isWhole(box.mesh));
  EXPECT_NEAR(volumeOf(box.mesh), 1, 1e-12);
}

TEST(ClosedMesh, SheetsThatEncloseNothingAreLeftOutAndSaidToBe) {
  const TriangleMesh sheet = {{{5, 0, 0}, {6, 0, 0}, {6, 1, 0}, {5, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const Closed beside = closed(together({LONG_BOX, sheet}));
  EXPECT_EQ(beside.mesh.shells(), 1);
  EXPECT_NE(beside.remark.find("1 sheet left out, which enclosed nothing"), std::string::npos) << beside.remark;
  EXPECT_EQ(refusalOf(sheet), "encloses nothing (allowed: surfaces that bound a solid)");
}

TEST(ClosedMesh, WhatHasNoOutsideIsRefused) {
  TriangleMesh strip;  // Möbius's
  const int n = 12;
  for (int i = 0; i < n; ++i)
    for (const double side : {-0.3, 0.3}) {
      const double turn = M_PI * i / n;
      strip.vertices.push_back(onCircle(1 + side * std::cos(turn), i, n, side * std::sin(turn)));
    }
  for (int i = 0; i < n; ++i) {
    const bool last = i == n - 1;
    const int a = 2 * i, b = 2 * i + 1, c = last ? 1 : 2 * i + 2, d = last ? 0 : 2 * i + 3;
    strip.triangles.push_back({a, b, d});
    strip.triangles.push_back({a, d, c});
  }
  EXPECT_EQ(refusalOf(strip).find("one side of its surface goes over into the other"), 0u) << refusalOf(strip);
}

TEST(ClosedMesh, WhatHasNoExtentIsRefused) {
  const std::string refusal = "has no extent (allowed: surfaces of a solid)";
  EXPECT_EQ(refusalOf({}), refusal);
  EXPECT_EQ(refusalOf({{Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(1, 1, 1)}, {{0, 1, 2}}}), refusal);
}

TEST(ClosedMesh, MoreShellsThanTheLimitAreRefused) {
  std::vector<TriangleMesh> boxes;
  for (int i = 0; i <= MAX_SHELLS; ++i) boxes.push_back(boxMesh(Vec3(1, 1, 1), Vec3(2 * i, 0, 0)));
  EXPECT_EQ(refusalOf(together(boxes)), "has 1001 separate surfaces (allowed: up to 1000)");
  boxes.pop_back();
  EXPECT_EQ(refusalOf(together(boxes)), "");
}

// Whatever the triangles are: what comes out is whole, or refused.
TEST(ClosedMesh, IsWholeOrRefusedForTrianglesAtRandom) {
  int whole = 0;
  for (unsigned seed = 0; seed < 3000; ++seed) {
    std::mt19937 random(seed);
    TriangleMesh mesh;
    const unsigned vertices = 4 + random() % 5, triangles = 1 + random() % 16;
    for (unsigned i = 0; i < vertices; ++i) mesh.vertices.emplace_back(random() % 3, random() % 3, random() % 3);
    for (unsigned i = 0; i < triangles; ++i)
      mesh.triangles.push_back({static_cast<int>(random() % vertices), static_cast<int>(random() % vertices),
                                static_cast<int>(random() % vertices)});
    try {
      const Closed some = closed(mesh);
      EXPECT_TRUE(isWhole(some.mesh)) << seed;
      EXPECT_GT(some.mesh.shells(), 0);
      ++whole;
    } catch (const InputError&) {
    }
  }
  EXPECT_GT(whole, 100);
}

}  // namespace
}  // namespace incision::test

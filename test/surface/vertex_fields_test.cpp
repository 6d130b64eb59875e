#include "incision/surface/vertex_fields.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "incision/mesh/grid_mesh.h"

namespace incision {
namespace {

const TetMesh CUBE = gridMesh({{4, 4, 4}, Vec3::Constant(2), Vec3::Constant(-1)});

TEST(VertexNormals, PointOutwardAtUnitLength) {
  const CutMesh mesh(CUBE);
  const Surface surface = buildSurface(mesh);
  std::vector<Vec3> x = surfacePositions(surface, mesh.mesh().nodes);
  const std::vector<Vec3> of_cube = vertexNormals(surface, x);
  int on_faces = 0;
  for (std::size_t v = 0; v < x.size(); ++v) {
    EXPECT_NEAR(of_cube[v].norm(), 1, 1e-14);
    EXPECT_GT(of_cube[v].dot(x[v]), 0);
    if ((x[v].cwiseAbs().array() > 1 - 1e-9).count() > 1) continue;
    EXPECT_NEAR(of_cube[v].cwiseAbs().maxCoeff(), 1, 1e-14);
    ++on_faces;
  }
  EXPECT_EQ(on_faces, 6 * 9);
}

TEST(VertexMeans, AreThoseOfTheTrianglesRoundAVertexByTheirAreas) {
  const CutMesh mesh(CUBE);
  const Surface surface = buildSurface(mesh);
  std::vector<Vec3> x = surfacePositions(surface, mesh.mesh().nodes);
  for (Vec3& point : x) point.z() *= 1 + 0.3 * point.x();  // so that areas differ
  std::vector<double> values;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) values.push_back(static_cast<double>(t * t % 17));
  const std::vector<double> means = vertexMeans(surface, x, values);
  for (std::size_t v = 0; v < x.size(); v += 7) {
    double sum = 0, area = 0;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      const auto& [a, b, c] = surface.triangles[t];
      if (a != static_cast<int>(v) && b != static_cast<int>(v) && c != static_cast<int>(v)) continue;
      const double of_triangle = 0.5 * (x[b] - x[a]).cross(x[c] - x[a]).norm();
      sum += of_triangle * values[t];
      area += of_triangle;
    }
    EXPECT_NEAR(means[v], sum / area, 1e-12 * 17);
  }
}

TEST(VertexFields, OfWhatIsFlattenedToAPointAreFinite) {
  const CutMesh mesh(CUBE);
  const Surface surface = buildSurface(mesh);
  const std::vector<Vec3> x(surface.vertices.size(), Vec3::Ones());
  for (const Vec3& normal : vertexNormals(surface, x)) EXPECT_EQ(normal, Vec3::Zero());
  for (double mean : vertexMeans(surface, x, std::vector<double>(surface.triangles.size(), 3))) EXPECT_EQ(mean, 3);
}

}  // namespace
}  // namespace incision

#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "incision/rigid/triangle_mesh.h"

namespace incision::test {

/// That a mesh of triangles encloses, closed or not [m³].
template <typename Mesh>
double volumeOf(const Mesh& mesh) {
  double volume = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    volume += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c])) / 6;
  return volume;
}

/// A grid of points that a surface is spanned between, closed round or not: triangles of (i, j), (i + 1, j), … .
template <typename At>
TriangleMesh spanned(int rows, int columns, const At& at) {
  TriangleMesh mesh;
  const auto add = [&](const Vec3& point) {
    mesh.vertices.push_back(point);
    return static_cast<int>(mesh.vertices.size()) - 1;
  };
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const int a = add(at(i, j)), b = add(at(i + 1, j)), c = add(at(i + 1, j + 1)), d = add(at(i, j + 1));
      for (const std::array<int, 3>& triangle : {std::array<int, 3>{a, b, c}, {a, c, d}}) {
        const Vec3 &x = mesh.vertices[triangle[0]], &y = mesh.vertices[triangle[1]], &z = mesh.vertices[triangle[2]];
        const bool is_point = (x - y).norm() < 1e-12 || (y - z).norm() < 1e-12 || (z - x).norm() < 1e-12;
        if (!is_point) mesh.triangles.push_back(triangle);
      }
    }
  return mesh;
}

inline Vec3 onCircle(double radius, int i, int count, double z) {
  const double angle = 2 * M_PI * (i % count) / count;
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

inline TriangleMesh sphereMesh(double radius, int rings) {
  return spanned(2 * rings, rings, [&](int i, int j) {
    const double down = M_PI * j / rings;
    const double r = j == 0 || j == rings ? 0 : radius * std::sin(down);
    return onCircle(r, i, 2 * rings, -radius * std::cos(down));
  });
}

inline TriangleMesh cylinderMesh(double radius, double length, int sides) {
  return spanned(sides, 3, [&](int i, int j) {
    return onCircle(j == 0 || j == 3 ? 0 : radius, i, sides, j < 2 ? -length / 2 : length / 2);
  });
}

/// Round the z axis.
inline TriangleMesh torusMesh(double radius, double thin, int sides) {
  return spanned(2 * sides, sides, [&](int i, int j) {
    const Vec3 at = onCircle(thin, j, sides, 0);
    return onCircle(radius + at.x(), i, 2 * sides, at.y());
  });
}

/// Between two polygons that are alike and turn counterclockwise as seen from above.
inline TriangleMesh prismMesh(const std::vector<Eigen::Vector2d>& polygon, const std::vector<std::array<int, 3>>& faces,
                              double low, double high) {
  TriangleMesh mesh;
  const int n = static_cast<int>(polygon.size());
  for (const double z : {low, high})
    for (const Eigen::Vector2d& corner : polygon) mesh.vertices.emplace_back(corner.x(), corner.y(), z);
  for (const auto& [a, b, c] : faces) {
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({n + a, n + b, n + c});
  }
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    mesh.triangles.push_back({i, j, n + j});
    mesh.triangles.push_back({i, n + j, n + i});
  }
  return mesh;
}

inline TriangleMesh boxMesh(const Vec3& size, const Vec3& centre = Vec3::Zero()) {
  const Vec3 h = size / 2;
  TriangleMesh mesh = prismMesh({{-h.x(), -h.y()}, {h.x(), -h.y()}, {h.x(), h.y()}, {-h.x(), h.y()}},
                                {{0, 1, 2}, {0, 2, 3}}, -h.z(), h.z());
  for (Vec3& vertex : mesh.vertices) vertex += centre;
  return mesh;
}

/// Legs of 1 m by 0.3 m along x and y, 0.4 m high.
inline TriangleMesh angleMesh() {
  return prismMesh({{0, 0}, {1, 0}, {1, 0.3}, {0.3, 0.3}, {0.3, 1}, {0, 1}},
                   {{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {3, 4, 5}}, 0, 0.4);
}

inline TriangleMesh together(const std::vector<TriangleMesh>& meshes) {
  TriangleMesh all;
  for (const TriangleMesh& mesh : meshes) {
    const int first = static_cast<int>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const auto& [a, b, c] : mesh.triangles) all.triangles.push_back({first + a, first + b, first + c});
  }
  return all;
}

inline std::string asTextStl(const TriangleMesh& mesh) {
  std::ostringstream text;
  text.precision(9);
  text << "solid s\n";
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (const int v : triangle) text << "vertex " << mesh.vertices[v].transpose() << '\n';
    text << "endloop\nendfacet\n";
  }
  return text.str() + "endsolid s\n";
}

inline std::string asBinaryStl(const TriangleMesh& mesh) {
  std::string bytes(80, ' ');
  const auto append = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);  // on a little-endian machine
  };
  append(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) append(0.0F);
    for (const int v : triangle)
      for (const double x : mesh.vertices[v]) append(static_cast<float>(x));
    append(std::uint16_t{0});
  }
  return bytes;
}

inline std::string asObj(const TriangleMesh& mesh) {
  std::ostringstream text;
  text.precision(9);
  text << "mtllib materials.mtl\no thing\n";
  for (const Vec3& vertex : mesh.vertices) text << "v " << vertex.transpose() << '\n';
  text << "usemtl red\n";
  for (const auto& [a, b, c] : mesh.triangles) text << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
  return text.str();
}

/// A COLLADA file whose unit is `unit` [m], with these nodes in its scene; "<instance_geometry url='#g'/>" is the mesh.
inline std::string asCollada(const TriangleMesh& mesh, double unit = 1,
                             const std::string& nodes = "<node id='n'><instance_geometry url='#g'/></node>",
                             const std::string& up = "Z_UP", const std::string& library = "") {
  std::ostringstream text, positions, indices;
  positions.precision(9);
  for (const Vec3& vertex : mesh.vertices) positions << vertex.transpose() << ' ';
  for (const auto& [a, b, c] : mesh.triangles) indices << a << ' ' << b << ' ' << c << ' ';
  text << "<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'>"
       << "<asset><unit name='u' meter='" << unit << "'/><up_axis>" << up << "</up_axis></asset>"
       << "<library_geometries><geometry id='g'><mesh><source id='p'><float_array id='a' count='"
       << 3 * mesh.vertices.size() << "'>" << positions.str()
       << "</float_array><technique_common><accessor source='#a' "
       << "count='" << mesh.vertices.size() << "' stride='3'><param name='X' type='float'/><param name='Y' "
       << "type='float'/><param name='Z' type='float'/></accessor></technique_common></source><vertices id='v'><input "
       << "semantic='POSITION' source='#p'/></vertices><triangles count='" << mesh.triangles.size() << "'><input "
       << "semantic='VERTEX' source='#v' offset='0'/><p>" << indices.str() << "</p></triangles></mesh></geometry>"
       << "</library_geometries>" << library << "<library_visual_scenes><visual_scene id='s'>" << nodes
       << "</visual_scene></library_visual_scenes><scene><instance_visual_scene url='#s'/></scene></COLLADA>";
  return text.str();
}

}  // namespace incision::test

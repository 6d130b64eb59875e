#include "incision/rigid/mesh_solid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "least_width.h"
#include "limits.h"

namespace incision {
namespace {

/// Faces whose normals differ by less [rad] have one plane: of a round solid there are then some hundreds, that lie
/// outside of it by less than a thousandth of its radius.
constexpr double SAME_PLANE = 0.05;

/// So many faces, the largest, may have a plane of their own.
constexpr std::size_t MOST_PLANES = 20'000;

/// Of the grid, along its longest edge: it takes as long to fill as the tree to make, and up to 128 KB.
constexpr int MOST_CELLS = 32;

/// As many cells as triangles, more or less.
int cellsFor(std::size_t triangles) {
  return std::clamp(2 * static_cast<int>(std::cbrt(static_cast<double>(triangles))), 4, MOST_CELLS);
}

}  // namespace

MeshSolid::MeshSolid(ClosedMesh mesh) : mesh_(std::move(mesh)), tree_(&mesh_) {
  for (const std::array<int, 3>& triangle : mesh_.triangles)
    for (const int v : triangle) {
      box_.extend(mesh_.vertices[v]);
      reach_ = std::max(reach_, mesh_.vertices[v].norm());
    }
  extent_ = box_.sizes().maxCoeff();
  findNormals();
  is_convex_ = findConvex();
  findPlanes();
  std::vector<Vec3> normals;
  for (const Plane& plane : planes_) normals.push_back(plane.normal);
  thickness_ = leastWidth([this](const Vec3& n) { return reachAlong(n); }, normals);
  grid_ = DistanceGrid(box_, cellsFor(mesh_.triangles.size()),
                       [this](const Vec3& point) { return distanceTo(point).distance; });
}

void MeshSolid::findNormals() {
  const auto corner = [&](std::size_t t, int k) { return mesh_.vertices[mesh_.triangles[t][k % 3]]; };
  const auto longest = [&](std::size_t t) {
    std::array<double, 3> length;
    for (int k = 0; k < 3; ++k) length[k] = (corner(t, k + 1) - corner(t, k)).norm();
    return static_cast<int>(std::max_element(length.begin(), length.end()) - length.begin());
  };
  const double flat = ALIKE * extent_;
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    const Vec3 area = (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0));
    const int k = longest(t);
    const bool is_sliver = area.norm() <= flat * (corner(t, k + 1) - corner(t, k)).norm();
    face_normals_.push_back(is_sliver ? Vec3(Vec3::Zero()) : area.normalized());
  }
  vertex_normals_.assign(mesh_.vertices.size(), Vec3::Zero());
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    Vec3 normal = face_normals_[t];
    // A triangle without an area belongs to the face beside it that has its longest edge.
    if (normal.isZero(0)) normal = face_normals_[mesh_.neighbours[t][longest(t)]];
    for (int k = 0; k < 3; ++k) {
      const Vec3 a = corner(t, k + 1) - corner(t, k), b = corner(t, k + 2) - corner(t, k);
      vertex_normals_[mesh_.triangles[t][k]] += std::atan2(a.cross(b).norm(), a.dot(b)) * normal;
    }
  }
}

/// Whether no triangle beside another rises above it. What is closed and nowhere hollow is convex.
bool MeshSolid::findConvex() const {
  if (mesh_.shells() > 1) return false;
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
    for (const int other : mesh_.neighbours[t])
      for (const int v : mesh_.triangles[other])
        if (face_normals_[t].dot(mesh_.vertices[v] - mesh_.vertices[mesh_.triangles[t][0]]) > ALIKE * extent_)
          return false;
  return true;
}

/// Those of the largest faces come first.
void MeshSolid::findPlanes() {
  const auto area = [&](int t) {
    const auto& [a, b, c] = mesh_.triangles[t];
    return (mesh_.vertices[b] - mesh_.vertices[a]).cross(mesh_.vertices[c] - mesh_.vertices[a]).norm();
  };
  std::vector<std::pair<double, int>> by_area;
  for (int t = 0; t < static_cast<int>(mesh_.triangles.size()); ++t) by_area.emplace_back(-area(t), t);
  std::sort(by_area.begin(), by_area.end());
  by_area.resize(std::min(by_area.size(), MOST_PLANES));
  for (const auto& [minus_area, t] : by_area) {
    const Vec3& normal = face_normals_[t];
    const bool is_there = std::any_of(planes_.begin(), planes_.end(), [&](const Plane& plane) {
      return plane.normal.dot(normal) > std::cos(SAME_PLANE);
    });
    if (!is_there && !normal.isZero(0)) planes_.push_back({normal, reachAlong(normal)});
  }
}

Vec3 MeshSolid::pseudonormal(int triangle, const TriangleTree::Feature& feature) const {
  using Feature = TriangleTree::Feature;
  const std::array<int, 3>& across = mesh_.neighbours[triangle];
  const auto allRound = [&](int t) {
    return face_normals_[mesh_.neighbours[t][0]] + face_normals_[mesh_.neighbours[t][1]] +
           face_normals_[mesh_.neighbours[t][2]];
  };
  if (feature.kind == Feature::VERTEX) return vertex_normals_[mesh_.triangles[triangle][feature.corner]];
  const Vec3& own = face_normals_[triangle];
  if (own.isZero(0)) return allRound(triangle);
  if (feature.kind == Feature::FACE) return own;
  const Vec3& other = face_normals_[across[feature.corner]];
  return other.isZero(0) ? Vec3(own + allRound(across[feature.corner])) : Vec3(own + other);
}

/// Of a shell, where it is nearer than `most` [m].
SolidDistance MeshSolid::distanceToShell(int shell, const Vec3& point, double most) const {
  using Feature = TriangleTree::Feature;
  const TriangleTree::Nearest nearest = tree_.nearest(shell, point, most);
  if (nearest.triangle < 0) return {std::numeric_limits<double>::infinity(), Vec3::UnitZ()};
  const Vec3 pseudo = pseudonormal(nearest.triangle, nearest.feature), away = point - nearest.point;
  // Where a surface goes through itself the pseudonormal may be another side's; what is beyond its box is outside.
  const bool is_inside = pseudo.dot(away) < 0 && tree_.shellBox(shell).contains(point);
  const double distance = std::sqrt(nearest.squared_distance), side = is_inside ? -1 : 1;
  const Vec3& face = face_normals_[nearest.triangle];
  // Where two triangles are one plane, the edge between them is none.
  const bool is_flat = nearest.feature.kind != Feature::VERTEX && face.dot(pseudo) > (1 - 1e-12) * pseudo.norm() &&
                       is_inside == (face.dot(away) < 0);
  if (is_flat) return {face.dot(point - mesh_.vertices[mesh_.triangles[nearest.triangle][0]]), face};
  // Nearer than this the way there has no digits left.
  if (distance > 1e-9 * extent_) return {side * distance, side / distance * away};
  return {side * distance, pseudo.isZero(0) ? Vec3(Vec3::UnitZ()) : Vec3(pseudo.normalized())};
}

SolidDistance MeshSolid::distanceTo(const Vec3& point) const {
  SolidDistance least{std::numeric_limits<double>::infinity(), Vec3::UnitZ()};
  for (int shell = 0; shell < mesh_.shells(); ++shell) {
    const double room = tree_.shellBox(shell).squaredExteriorDistance(point);
    if (least.distance < 0 ? room > 0 : room >= least.distance * least.distance) continue;
    const double most = least.distance < 0 ? std::numeric_limits<double>::infinity() : least.distance;
    const SolidDistance found =
        distanceToShell(shell, point, room > 0 ? most : std::numeric_limits<double>::infinity());
    if (found.distance < least.distance) least = found;
  }
  return least;
}

SolidDistance MeshSolid::distanceAgainst(const Vec3& point, const Vec3& n) const {
  SolidDistance nearest{-std::numeric_limits<double>::infinity(), -n};
  if (!is_convex_) {
    const TriangleTree::Exit exit = tree_.firstExit(point, -n, LEAST_OPPOSITION, face_normals_);
    if (exit.triangle < 0) return nearest;
    const Vec3& normal = face_normals_[exit.triangle];
    return {exit.along * normal.dot(n), normal};
  }
  for (const Plane& plane : planes_) {
    const double distance = plane.normal.dot(point) - plane.offset;
    if (-plane.normal.dot(n) > LEAST_OPPOSITION && distance > nearest.distance) nearest = {distance, plane.normal};
  }
  return nearest;
}

void MeshSolid::check(const std::string& where) const {
  for (const double size : box_.sizes()) checkLength(size, where + ": the mesh's size");
  checkCoordinate(reach_, where + ": the mesh reaches to");
}

Drawing MeshSolid::drawing() const {
  return {Drawing::Primitive::MESH, Vec3::Ones(), "",
          std::make_shared<TriangleMesh>(TriangleMesh{mesh_.vertices, mesh_.triangles})};
}

}  // namespace incision

#include "incision/rigid/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace incision {
namespace {

constexpr int LEAF = 4;  // triangles: fewer take more memory, more take longer

// Every box is split into halves of its triangles, so that a tree is as deep as the logarithm of their number, and what
// waits to be looked into is one box a level.
constexpr int MAX_WAITING = 64;

/// Boxes that wait to be looked into, the last one first.
class Waiting {
 public:
  void push(int node, double bound) { entries_[count_++] = {node, bound}; }
  bool pop(int* node, double* bound) {
    if (count_ == 0) return false;
    *node = entries_[--count_].node;
    *bound = entries_[count_].bound;
    return true;
  }

 private:
  struct Entry {
    int node;
    double bound;
  };
  std::array<Entry, MAX_WAITING> entries_;
  int count_ = 0;
};

using Corners = std::array<Vec3, 3>;
using Feature = TriangleTree::Feature;

/// The nearest point of a triangle and what it lies on; of a triangle without an area none, as its neighbours have its
/// edges (Ericson, "Real-Time Collision Detection", 2005, 5.1.5).
bool nearestOn(const Corners& corners, const Vec3& p, Vec3* point, Feature* feature) {
  const auto& [a, b, c] = corners;
  const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  const auto is = [&](const Vec3& at, Feature::Kind kind, int corner) {
    *point = at;
    *feature = {kind, corner};
    return true;
  };
  if (!(va + vb + vc > 0)) return false;
  if (d1 <= 0 && d2 <= 0) return is(a, Feature::VERTEX, 0);
  if (d3 >= 0 && d4 <= d3) return is(b, Feature::VERTEX, 1);
  if (d6 >= 0 && d5 <= d6) return is(c, Feature::VERTEX, 2);
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return is(a + d1 / (d1 - d3) * ab, Feature::EDGE, 0);
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return is(a + d2 / (d2 - d6) * ac, Feature::EDGE, 2);
  if (va <= 0 && d4 >= d3 && d5 >= d6) {
    return is(b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), Feature::EDGE, 1);
  }
  const double sum = va + vb + vc;
  return is(a + vb / sum * ab + vc / sum * ac, Feature::FACE, 0);
}

Corners cornersOf(const ClosedMesh& mesh, int triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

/// Whether the ray meets the box nearer than `most`. A ray in the plane of a side has NaN there, which counts as met.
bool meets(const Eigen::AlignedBox3d& box, const Vec3& from, const Vec3& inverse, double most) {
  double begin = 0, end = most;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (box.min()[axis] - from[axis]) * inverse[axis], b = (box.max()[axis] - from[axis]) * inverse[axis];
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  return begin <= end;
}

/// How far along the ray it meets the triangle; negative where it does not (Möller and Trumbore, 1997).
double alongRay(const Corners& corners, const Vec3& from, const Vec3& d) {
  const auto& [a, b, c] = corners;
  const Vec3 ab = b - a, ac = c - a, across = d.cross(ac);
  const double determinant = ab.dot(across);
  if (determinant == 0) return -1;
  const Vec3 to = from - a, q = to.cross(ab);
  const double u = to.dot(across) / determinant, v = d.dot(q) / determinant;
  // A ray through an edge must not slip between its two triangles.
  constexpr double ROUNDING = 1e-12;
  return u >= -ROUNDING && v >= -ROUNDING && u + v <= 1 + ROUNDING ? ac.dot(q) / determinant : -1;
}

double reachOf(const Eigen::AlignedBox3d& box, const Vec3& n) {
  return n.dot(box.center()) + n.cwiseAbs().dot(box.sizes()) / 2;
}

}  // namespace

/// Orders triangles and their boxes.
class TriangleTree::Builder {
 public:
  Builder(ClosedMesh* mesh, std::vector<Node>* nodes) : mesh_(mesh), nodes_(nodes), order_(mesh->triangles.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    centres_.reserve(order_.size());
    for (int t = 0; t < static_cast<int>(order_.size()); ++t) centres_.push_back(boxOf(t).center());
    nodes->resize(static_cast<std::size_t>(mesh->shells()));
    for (int s = 0; s < mesh->shells(); ++s) build(s, mesh->shell_start[s], mesh->shell_start[s + 1]);
    reorder();
  }

 private:
  Eigen::AlignedBox3d boxOf(int triangle) const {
    Eigen::AlignedBox3d box;
    for (const int v : mesh_->triangles[triangle]) box.extend(mesh_->vertices[v]);
    return box;
  }

  void build(int node, int begin, int end) {
    Eigen::AlignedBox3d box, centres;
    for (int i = begin; i < end; ++i) {
      box.extend(boxOf(order_[i]));
      centres.extend(centres_[order_[i]]);
    }
    (*nodes_)[node] = {box, begin, end - begin};
    if (end - begin <= LEAF) return;
    int axis = 0;
    centres.sizes().maxCoeff(&axis);
    const int middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](int s, int t) {
      return centres_[s][axis] != centres_[t][axis] ? centres_[s][axis] < centres_[t][axis] : s < t;
    });
    const int first = static_cast<int>(nodes_->size());
    nodes_->resize(nodes_->size() + 2);
    (*nodes_)[node].first = first;
    (*nodes_)[node].count = 0;
    build(first, begin, middle);
    build(first + 1, middle, end);
  }

  void reorder() {
    const ClosedMesh old = *mesh_;
    std::vector<int> place(order_.size());
    for (std::size_t i = 0; i < order_.size(); ++i) place[order_[i]] = static_cast<int>(i);
    for (std::size_t i = 0; i < order_.size(); ++i) {
      mesh_->triangles[i] = old.triangles[order_[i]];
      for (int k = 0; k < 3; ++k) mesh_->neighbours[i][k] = place[old.neighbours[order_[i]][k]];
    }
  }

  ClosedMesh* mesh_;
  std::vector<Node>* nodes_;
  std::vector<int> order_;
  std::vector<Vec3> centres_;
};

TriangleTree::TriangleTree(ClosedMesh* mesh) : mesh_(mesh) { Builder(mesh, &nodes_); }

TriangleTree::Nearest TriangleTree::nearest(int shell, const Vec3& point, double most) const {
  Nearest nearest;
  nearest.squared_distance = most * most;
  Waiting waiting;
  waiting.push(shell, 0);
  int at = 0;
  double bound = 0;
  while (waiting.pop(&at, &bound)) {
    if (bound >= nearest.squared_distance) continue;
    const Node& node = nodes_[at];
    if (node.count == 0) {
      const double a = nodes_[node.first].box.squaredExteriorDistance(point);
      const double b = nodes_[node.first + 1].box.squaredExteriorDistance(point);
      const int far = a > b ? 0 : 1;
      waiting.push(node.first + far, std::max(a, b));
      waiting.push(node.first + 1 - far, std::min(a, b));
    }
    for (int t = node.first; t < node.first + node.count; ++t) {
      Vec3 foot;
      Feature feature;
      if (!nearestOn(cornersOf(*mesh_, t), point, &foot, &feature)) continue;
      const double squared = (point - foot).squaredNorm();
      if (squared < nearest.squared_distance) nearest = {t, feature, foot, squared};
    }
  }
  return nearest;
}

TriangleTree::Exit TriangleTree::firstExit(const Vec3& point, const Vec3& d, double least,
                                           const std::vector<Vec3>& normals) const {
  Exit exit;
  const Vec3 inverse = d.cwiseInverse();
  for (int shell = 0; shell < mesh_->shells(); ++shell) {
    Waiting waiting;
    waiting.push(shell, 0);
    int at = 0;
    double unused = 0;
    while (waiting.pop(&at, &unused)) {
      const Node& node = nodes_[at];
      if (!meets(node.box, point, inverse, exit.along)) continue;
      if (node.count == 0) {
        waiting.push(node.first, 0);
        waiting.push(node.first + 1, 0);
      }
      for (int t = node.first; t < node.first + node.count; ++t) {
        if (!(normals[t].dot(d) > least)) continue;
        const double along = alongRay(cornersOf(*mesh_, t), point, d);
        if (along >= 0 && along < exit.along) exit = {t, along};
      }
    }
  }
  return exit;
}

double TriangleTree::reachAlong(const Vec3& n) const {
  double most = -std::numeric_limits<double>::infinity();
  for (int shell = 0; shell < mesh_->shells(); ++shell) {
    Waiting waiting;
    waiting.push(shell, reachOf(nodes_[shell].box, n));
    int at = 0;
    double bound = 0;
    while (waiting.pop(&at, &bound)) {
      if (bound <= most) continue;
      const Node& node = nodes_[at];
      if (node.count == 0) {
        const double a = reachOf(nodes_[node.first].box, n), b = reachOf(nodes_[node.first + 1].box, n);
        const int near = a < b ? 0 : 1;
        waiting.push(node.first + near, std::min(a, b));
        waiting.push(node.first + 1 - near, std::max(a, b));
      }
      for (int t = node.first; t < node.first + node.count; ++t)
        for (const Vec3& corner : cornersOf(*mesh_, t)) most = std::max(most, n.dot(corner));
    }
  }
  return most;
}

}  // namespace incision

#include "incision/tool/stroke.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace incision {
namespace {

/// Triangles of the sweep kept for one element; the oldest go first. A blade that crosses an element in more sweeps
/// than this moves by less than the element's snap.
constexpr std::size_t MAX_TRIANGLES = 1024;

/// Twice the area of a sweep, as a share of the edge's length squared, below which it has no direction: the edge moved
/// along itself.
constexpr double MIN_SWEEP = 1e-9;

/// Rim of a triangle, as a share of it, that counts as inside: consecutive sweeps share an edge, and a point on it must
/// not fall between.
constexpr double RIM = 1e-9;

/// How far outside an element, in its own coordinates, the sweep is followed. An element must be followed before the
/// edge enters it: between two sweeps the tissue moves, and what it moves by would be missing from the swept surface.
constexpr double MARGIN = 0.5;

/// Map from the body to an element's coordinates as one part sees them.
class PartFrame {
 public:
  PartFrame(const Part& part, const std::vector<Vec3>& x) : origin_(x[part.copies[0]]) {
    Mat3 edges;
    for (int k = 0; k < 3; ++k) edges.col(k) = x[part.copies[k + 1]] - origin_;
    edges.computeInverseWithCheck(inverse_, invertible_, 0.0);
  }
  bool invertible() const { return invertible_; }
  Barycentric toElement(const Vec3& point) const {
    Barycentric b;
    b.tail<3>() = inverse_ * (point - origin_);
    b[0] = 1 - b.tail<3>().sum();
    return b;
  }

 private:
  Vec3 origin_;
  Mat3 inverse_;
  bool invertible_ = false;
};

Eigen::AlignedBox3d boxOf(const Part& part, const std::vector<Vec3>& x) {
  Eigen::AlignedBox3d box(x[part.copies[0]]);
  for (int I = 1; I < 4; ++I) box.extend(x[part.copies[I]]);
  return box;
}

/// Whether all points lie beyond one face of the element, by more than `margin`.
bool outside(const std::array<Barycentric, 4>& points, double margin) {
  for (int I = 0; I < 4; ++I)
    if (std::all_of(points.begin(), points.end(), [&](const Barycentric& b) { return b[I] < -margin; })) return true;
  return false;
}

/// Whether a line through `point` along `direction` meets a triangle, all in an element's affine coordinates. Triangles
/// that share an edge leave no gap between them, at whatever distance and angle they pass the point.
bool isBehind(const std::array<Barycentric, 3>& triangle, const Barycentric& point, const Vec3& direction) {
  std::array<double, 3> side;  // twice the areas that the point's image cuts the triangle's into
  for (int i = 0; i < 3; ++i) {
    const Vec3 a = (triangle[i] - point).tail<3>(), b = (triangle[(i + 1) % 3] - point).tail<3>();
    side[i] = a.cross(b).dot(direction);
  }
  const double area = side[0] + side[1] + side[2], rim = RIM * std::abs(area), sense = area < 0 ? -1 : 1;
  return area != 0 && std::all_of(side.begin(), side.end(), [&](double s) { return sense * s >= -rim; });
}

}  // namespace

Insertion Stroke::sweep(const Edge& from, const Edge& to, const std::vector<Vec3>& x, CutMesh* mesh) {
  const Vec3 area = (to[1] - from[0]).cross(to[0] - from[1]);
  if (area.norm() < MIN_SWEEP * (from[1] - from[0]).squaredNorm()) return {};
  normal_ = area.dot(normal_) < 0 ? -area.normalized() : area.normalized();
  record(from, to, x, *mesh);
  if (met_.empty()) return {};
  CrackField crack = field(from, to, x, *mesh);
  std::vector<int> owned;
  crack.contains = [&](int part, const Barycentric& point) {
    const auto& copies = mesh->parts()[part].copies;
    if (!covers(mesh->parts()[part], point, crack.phi)) return false;
    owned.insert(owned.end(), copies.begin(), copies.end());
    return true;
  };
  const int before = mesh->numCopies();
  const Insertion done = mesh->insert(crack);
  if (!done.changed()) return done;
  crack_ = done.crack;
  for (int c : owned) phi_.emplace(c, crack.phi[c]);
  for (int c = before; c < mesh->numCopies(); ++c)
    if (const auto parent = phi_.find(mesh->copyParent(c)); parent != phi_.end()) phi_.emplace(c, parent->second);
  return done;
}

/// Remembers the swept surface in every element it may pass through. Each sweep starts where the last one left the
/// element's material, so the surface has no gaps however the tissue moves under the blade.
void Stroke::record(const Edge& from, const Edge& to, const std::vector<Vec3>& x, const CutMesh& mesh) {
  met_.clear();
  ++sweeps_;
  Eigen::AlignedBox3d reach;
  for (const Edge* edge : {&from, &to})
    for (const Vec3& end : *edge) reach.extend(end);
  for (std::size_t p = 0; p < mesh.parts().size(); ++p) {
    const Part& part = mesh.parts()[p];
    Eigen::AlignedBox3d box = boxOf(part, x);
    const Vec3 room = MARGIN * box.sizes();
    if (!reach.intersects(Eigen::AlignedBox3d(box.min() - room, box.max() + room))) continue;
    const PartFrame frame(part, x);
    if (!frame.invertible()) continue;
    const ElementEdge start = {frame.toElement(from[0]), frame.toElement(from[1])};
    const ElementEdge end = {frame.toElement(to[0]), frame.toElement(to[1])};
    const std::array<Barycentric, 4> corners = {start[0], start[1], end[1], end[0]};
    if (outside(corners, MARGIN)) continue;
    met_.push_back(static_cast<int>(p));
    begun_ = begun_ || !outside(corners, 0);
    Swept& swept = swept_[part.element];
    if (swept.last_sweep == sweeps_) continue;  // by another part of the element
    swept.add(swept.last_sweep == sweeps_ - 1 ? swept.edge : start, end);
    swept.last_sweep = sweeps_;
  }
}

void Stroke::Swept::add(const ElementEdge& start, const ElementEdge& end) {
  triangles.push_back({start[0], start[1], end[1]});
  triangles.push_back({start[0], end[1], end[0]});
  while (triangles.size() > MAX_TRIANGLES) triangles.pop_front();
  edge = end;
}

/// Distances kept where the stroke owns them, elsewhere those from the plane of this sweep.
CrackField Stroke::field(const Edge& from, const Edge& to, const std::vector<Vec3>& x, const CutMesh& mesh) const {
  const Vec3 centre = (from[0] + from[1] + to[0] + to[1]) / 4;
  CrackField crack;
  crack.crack = crack_;
  crack.parts = met_;
  crack.phi.assign(mesh.numCopies(), 0);
  for (int p : met_)
    for (int c : mesh.parts()[p].copies) {
      if (const auto own = phi_.find(c); own != phi_.end()) {
        crack.phi[c] = own->second;
        continue;
      }
      const double phi = normal_.dot(x[c] - centre);
      crack.phi[c] = std::abs(phi) < SNAP * mesh.shortestEdge(mesh.copyNode(c)) ? 0 : phi;
    }
  return crack;
}

/// Whether the sweep so far passed the point of a part, seen along the gradient of φ.
bool Stroke::covers(const Part& part, const Barycentric& point, const std::vector<double>& phi) const {
  const auto found = swept_.find(part.element);
  if (found == swept_.end()) return false;
  Vec3 across;
  for (int k = 0; k < 3; ++k) across[k] = phi[part.copies[k + 1]] - phi[part.copies[0]];
  const std::deque<Triangle>& triangles = found->second.triangles;
  return std::any_of(triangles.begin(), triangles.end(),
                     [&](const Triangle& triangle) { return isBehind(triangle, point, across); });
}

bool touches(const Edge& edge, const std::vector<Vec3>& x, const CutMesh& mesh) {
  Eigen::AlignedBox3d reach(edge[0]);
  reach.extend(edge[1]);
  return std::any_of(mesh.parts().begin(), mesh.parts().end(), [&](const Part& part) {
    if (!reach.intersects(boxOf(part, x))) return false;
    const PartFrame frame(part, x);
    if (!frame.invertible()) return false;
    const Barycentric a = frame.toElement(edge[0]), b = frame.toElement(edge[1]);
    double first = 0, last = 1;  // of the edge, what lies in the element
    for (int I = 0; I < 4; ++I) {
      if (a[I] < 0 && b[I] < 0) return false;
      if (a[I] < 0) first = std::max(first, a[I] / (a[I] - b[I]));
      if (b[I] < 0) last = std::min(last, a[I] / (a[I] - b[I]));
    }
    return first <= last;
  });
}

}  // namespace incision

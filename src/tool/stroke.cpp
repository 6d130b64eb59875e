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

/// Map from the body to an element's coordinates as one part sees them.
class PartFrame {
 public:
  PartFrame(const Part& part, const std::vector<Vec3>& x) : origin_(x[part.copies[0]]) {
    for (int k = 0; k < 3; ++k) edges_.col(k) = x[part.copies[k + 1]] - origin_;
    edges_.computeInverseWithCheck(inverse_, invertible_, 0.0);
  }
  bool invertible() const { return invertible_; }
  Barycentric toElement(const Vec3& point) const {
    Barycentric b;
    b.tail<3>() = inverse_ * (point - origin_);
    b[0] = 1 - b.tail<3>().sum();
    return b;
  }
  Vec3 toBody(const Barycentric& b) const { return origin_ + edges_ * b.tail<3>(); }

 private:
  Vec3 origin_;
  Mat3 edges_, inverse_;
  bool invertible_ = false;
};

Eigen::AlignedBox3d boxOf(const Part& part, const std::vector<Vec3>& x) {
  Eigen::AlignedBox3d box(x[part.copies[0]]);
  for (int I = 1; I < 4; ++I) box.extend(x[part.copies[I]]);
  return box;
}

/// Whether all points lie beyond one face of the element.
template <std::size_t N>
bool outside(const std::array<Barycentric, N>& points) {
  for (int I = 0; I < 4; ++I)
    if (std::all_of(points.begin(), points.end(), [I](const Barycentric& b) { return b[I] < 0; })) return true;
  return false;
}

/// Whether the foot of a point on a triangle's plane lies in the triangle.
bool isAbove(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& point) {
  const Vec3 normal = (b - a).cross(c - a);
  const double area = normal.squaredNorm();
  const double wa = (c - b).cross(point - b).dot(normal), wb = (a - c).cross(point - c).dot(normal),
               wc = (b - a).cross(point - a).dot(normal);
  return area > 0 && std::min({wa, wb, wc}) >= -RIM * area;
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
    if (!covers(part, point, x, *mesh)) return false;
    const auto& copies = mesh->parts()[part].copies;
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

/// Remembers the swept surface in every element it may pass through.
void Stroke::record(const Edge& from, const Edge& to, const std::vector<Vec3>& x, const CutMesh& mesh) {
  met_.clear();
  Eigen::AlignedBox3d swept;
  for (const Edge* edge : {&from, &to})
    for (const Vec3& end : *edge) swept.extend(end);
  int recorded = -1;  // parts of an element follow each other only by chance; one record an element is enough
  for (std::size_t p = 0; p < mesh.parts().size(); ++p) {
    const Part& part = mesh.parts()[p];
    if (!swept.intersects(boxOf(part, x))) continue;
    const PartFrame frame(part, x);
    if (!frame.invertible()) continue;
    const std::array<Barycentric, 4> corners = {frame.toElement(from[0]), frame.toElement(from[1]),
                                                frame.toElement(to[1]), frame.toElement(to[0])};
    if (outside(corners)) continue;
    met_.push_back(static_cast<int>(p));
    if (part.element == recorded) continue;
    recorded = part.element;
    std::deque<Triangle>& triangles = swept_[part.element];
    triangles.push_back({corners[0], corners[1], corners[2]});
    triangles.push_back({corners[0], corners[2], corners[3]});
    while (triangles.size() > MAX_TRIANGLES) triangles.pop_front();
  }
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

bool Stroke::covers(int part, const Barycentric& point, const std::vector<Vec3>& x, const CutMesh& mesh) const {
  const auto found = swept_.find(mesh.parts()[part].element);
  if (found == swept_.end()) return false;
  const PartFrame frame(mesh.parts()[part], x);
  return std::any_of(found->second.begin(), found->second.end(), [&](const Triangle& t) {
    return isAbove(frame.toBody(t[0]), frame.toBody(t[1]), frame.toBody(t[2]), frame.toBody(point));
  });
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

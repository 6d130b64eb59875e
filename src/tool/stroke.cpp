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

/// How far from an element, in its own coordinates, a sweep still counts as passing it. A crack that is one plane in
/// each element runs beside the swept surface by what that bends within one, and so through elements that the surface
/// itself just misses.
constexpr double MARGIN = 0.5;

/// How far the edge must move through the tissue, as a share of its length, for a sweep to have a direction; an edge
/// that moves along itself moves by rounding.
constexpr double MIN_SWEEP = 1e-9;

/// Rim of a triangle, as a share of it, that counts as inside: consecutive sweeps share an edge, and a point on it must
/// not fall between.
constexpr double RIM = 1e-9;

/// Map between the body and an element's coordinates as one part sees them.
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

/// Whether all points lie beyond one face of the element, by more than `margin`.
bool outside(const std::array<Barycentric, 4>& points, double margin) {
  for (int I = 0; I < 4; ++I)
    if (std::all_of(points.begin(), points.end(), [&](const Barycentric& b) { return b[I] < -margin; })) return true;
  return false;
}

/// The point of the line through an edge that is nearest to `point`.
Vec3 nearest(const Edge& edge, const Vec3& point) {
  const Vec3 along = edge[1] - edge[0];
  return edge[0] + (point - edge[0]).dot(along) / along.squaredNorm() * along;
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
  start(x);
  for (int c = static_cast<int>(last_x_.size()); c < mesh->numCopies(); ++c)
    last_x_.push_back(last_x_[mesh->copyParent(c)]);
  record(from, to, x, *mesh);
  last_x_ = x;
  if (met_.empty()) return {};
  measure(to, x, *mesh);
  CrackField crack = field(*mesh);
  crack.contains = [&](int part, const Barycentric& point) { return covers(mesh->parts()[part], point, crack.phi); };
  const int before = mesh->numCopies();
  const Insertion done = mesh->insert(crack);
  if (!done.changed()) return done;
  crack_ = done.crack;
  for (int part : done.parts)
    for (int c : mesh->parts()[part].copies) distances_.at(c < before ? c : mesh->copyParent(c)).settled = true;
  for (int c = before; c < mesh->numCopies(); ++c)
    if (const auto parent = distances_.find(mesh->copyParent(c)); parent != distances_.end())
      distances_.emplace(c, Distance(parent->second));
  return done;
}

/// Remembers the swept surface in every element it passes. It starts where the last sweep left the element's material,
/// so the surface has no gaps however the tissue moves under the blade.
void Stroke::record(const Edge& from, const Edge& to, const std::vector<Vec3>& x, const CutMesh& mesh) {
  met_.clear();
  met_normal_.clear();
  const Vec3 direction = (to[1] - to[0]).normalized();
  const double least = MIN_SWEEP * (to[1] - to[0]).norm();
  Eigen::AlignedBox3d reach;
  for (const Edge* edge : {&from, &to})
    for (const Vec3& end : *edge) reach.extend(end);
  for (std::size_t p = 0; p < mesh.parts().size(); ++p) {
    const Part& part = mesh.parts()[p];
    const Eigen::AlignedBox3d box = boxOf(part, x).merged(boxOf(part, last_x_));
    const Vec3 room = MARGIN * box.sizes();
    if (!reach.intersects(Eigen::AlignedBox3d(box.min() - room, box.max() + room))) continue;
    const PartFrame was(part, last_x_), is(part, x);
    if (!was.invertible() || !is.invertible()) continue;
    const std::array<Barycentric, 4> corners = {was.toElement(from[0]), was.toElement(from[1]), is.toElement(to[1]),
                                                is.toElement(to[0])};
    if (outside(corners, MARGIN)) continue;
    const Vec3 centre = is.toBody(Barycentric::Constant(0.25));
    const Edge carried = {is.toBody(corners[0]), is.toBody(corners[1])};
    const Vec3 normal = direction.cross(nearest(to, centre) - nearest(carried, centre));
    if (!(normal.norm() > least)) continue;
    begun_ = begun_ || !outside(corners, 0);
    met_.push_back(static_cast<int>(p));
    met_normal_.push_back(normal);
    std::deque<Triangle>& triangles = swept_[part.element];
    triangles.push_back({corners[0], corners[1], corners[2]});
    triangles.push_back({corners[0], corners[2], corners[3]});
    while (triangles.size() > MAX_TRIANGLES) triangles.pop_front();
  }
  turnAlike();
}

/// Turns the normals to the side of the last sweep's: a blade that goes back must not swap the crack's sides.
void Stroke::turnAlike() {
  Vec3 sum = Vec3::Zero();
  for (Vec3& normal : met_normal_) {
    if (normal.dot(sum.isZero(0) ? normal_ : sum) < 0) normal = -normal;
    sum += normal;
  }
  if (!sum.isZero(0)) normal_ = sum.normalized();
}

/// Measures the copies of the parts the sweep passes, but for the settled ones, from a plane through the edge as it
/// stands now, with the mean normal of the parts round the copy.
void Stroke::measure(const Edge& to, const std::vector<Vec3>& x, const CutMesh& mesh) {
  std::unordered_map<int, Vec3> normals;
  for (std::size_t i = 0; i < met_.size(); ++i)
    for (int c : mesh.parts()[met_[i]].copies) normals.try_emplace(c, Vec3::Zero()).first->second += met_normal_[i];
  for (const auto& [c, normal] : normals) {
    Distance& distance = distances_[c];
    if (distance.settled) continue;
    const double phi = normal.normalized().dot(x[c] - to[0]);
    distance.phi = std::abs(phi) < SNAP * mesh.shortestEdge(mesh.copyNode(c)) ? 0 : phi;
  }
}

/// The crack in all elements of the sweep so far: a copy that is measured anew can change what it means for elements
/// that the blade has left behind, and neighbours must agree.
CrackField Stroke::field(const CutMesh& mesh) const {
  CrackField crack;
  crack.crack = crack_;
  crack.phi.assign(mesh.numCopies(), 0);
  for (const auto& [copy, distance] : distances_) crack.phi[copy] = distance.phi;
  for (const auto& [element, unused] : swept_)
    for (int p = element; p >= 0; p = mesh.parts()[p].next) {
      const auto& copies = mesh.parts()[p].copies;
      if (std::all_of(copies.begin(), copies.end(), [&](int c) { return distances_.count(c) > 0; }))
        crack.parts.push_back(p);
    }
  std::sort(crack.parts.begin(), crack.parts.end());
  return crack;
}

/// Whether the sweep so far passed the point of a part, seen along the gradient of φ.
bool Stroke::covers(const Part& part, const Barycentric& point, const std::vector<double>& phi) const {
  const auto found = swept_.find(part.element);
  if (found == swept_.end()) return false;
  Vec3 across;
  for (int k = 0; k < 3; ++k) across[k] = phi[part.copies[k + 1]] - phi[part.copies[0]];
  const std::deque<Triangle>& triangles = found->second;
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

#include "incision/tool/blade/ties.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace incision {
namespace {

/// How far from a section's plane, in elements, the sweep of another crack still frees it. That of its own does
/// wherever it passes the element: a crack that is one plane in each element strays from a curved path.
constexpr double REACH = 0.5;

/// How near to a point, in elements, one that is not swept has to be: two spacings of the points of a section.
constexpr double NEAR = 0.2;

/// Finds three points of equal weight with the mean m and the second moments C = Σ aₖ aₖᵀ of all unswept ones: m + √2
/// (a₁ cos θ + a₂ sin θ) for θ = 0, 2π/3, 4π/3. What is tied there resists every linear opening as the whole does.
void findAnchors(Tie* tie) {
  const double count = static_cast<double>(tie->unswept.size());
  Barycentric mean = Barycentric::Zero();
  for (const Barycentric& point : tie->unswept) mean += point / count;
  Eigen::Matrix4d moments = Eigen::Matrix4d::Zero();
  for (const Barycentric& point : tie->unswept) moments += (point - mean) * (point - mean).transpose() / count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> axes(moments);  // ascending
  for (int k = 0; k < 3; ++k) {
    const double angle = 2 * M_PI * k / 3;
    tie->anchors[k] = mean;
    for (int a = 0; a < 2; ++a)
      tie->anchors[k] += std::sqrt(2 * std::max(0.0, axes.eigenvalues()[3 - a])) *
                         (a == 0 ? std::cos(angle) : std::sin(angle)) * axes.eigenvectors().col(3 - a);
  }
  tie->section.point = mean;
}

}  // namespace

void Tie::countSeparated(const CutMesh& mesh) {
  const Part &plus = mesh.parts()[section.plus], &minus = mesh.parts()[section.minus];
  int now = 0;
  for (int I = 0; I < 4; ++I) now += plus.copies[I] != minus.copies[I];
  if (now > separated) share_then = share();
  separated = now;
}

void Ties::addSection(int crack, int part, const CutMesh& mesh, bool progressive) {
  const Polytope& polytope = mesh.polytope(part);
  const Facet* facet = facetOf(polytope, crack);
  if (!facet) return;  // it was severed
  const int element = mesh.parts()[part].element;
  const auto resting = [&](const Barycentric& b) { return atRest(mesh, element, b); };
  Tie tie;
  tie.area = vectorArea(polytope, *facet, resting).norm();
  if (!progressive) {
    memory_.area += tie.area;
    return;
  }
  tie.section = sectionOf(mesh, part, *facet);
  tie.size = materials_.size(element);
  tie.steepness = materials_.stiffness(element);
  const Vec3 on_plane = resting(tie.section.point);
  for (int I = 0; I < 4; ++I) tie.distance[I] = tie.section.across.dot(resting(Barycentric::Unit(I)) - on_plane);
  tie.unswept = spread(cornersOf(polytope, *facet));
  tie.points = tie.unswept.size();
  memory_.ties.push_back(std::move(tie));
}

/// Takes out the points that a triangle lies behind or before, seen along the normal.
void Ties::mark(Span<const SweptTriangle> triangles, bool own_crack, Tie* tie) {
  const Vec3 across = gradient(tie->distance);
  const SweptShadow shadow(triangles, across, tie->unswept);
  if (shadow.isEmpty()) return;
  const auto isNear = [&](const SweptTriangle& triangle, const Barycentric& point) {
    const Vec3 normal = (triangle[1] - triangle[0]).tail<3>().cross((triangle[2] - triangle[0]).tail<3>());
    // point + t across lies in the triangle, and away by t |across|².
    const double t = normal.dot((triangle[0] - point).tail<3>()) / normal.dot(across);
    return std::abs(t) * across.squaredNorm() < REACH * tie->size;
  };
  const auto swept = std::remove_if(tie->unswept.begin(), tie->unswept.end(), [&](const Barycentric& point) {
    return shadow.covers(point, [&](const SweptTriangle& triangle) { return own_crack || isNear(triangle, point); });
  });
  if (swept == tie->unswept.end()) return;
  memory_.area += tie->area * static_cast<double>(tie->unswept.end() - swept) / static_cast<double>(tie->points);
  tie->unswept.erase(swept, tie->unswept.end());
  tie->moved = true;
}

void Ties::sweep(const std::unordered_map<int, std::vector<SweptTriangle>>& swept, std::optional<int> crack) {
  for (Tie& tie : memory_.ties)
    if (const auto found = swept.find(tie.section.element); found != swept.end())
      mark({found->second.data(), found->second.data() + found->second.size()}, tie.section.crack == crack, &tie);
  finishSweep();
}

/// Lets go of what has been swept, and finds where the rest is tied.
void Ties::finishSweep() {
  const auto free = [&](const Tie& tie) {
    if (tie.share() < LAST_SHARE) return false;
    memory_.area += tie.area * (1 - tie.share());
    return true;
  };
  memory_.ties.erase(std::remove_if(memory_.ties.begin(), memory_.ties.end(), free), memory_.ties.end());
  for (Tie& tie : memory_.ties)
    if (std::exchange(tie.moved, false)) findAnchors(&tie);
}

void Ties::changed(const CutMesh& mesh) {
  const auto torn = [&](Tie& tie) { return !findSides(mesh, &tie.section); };
  memory_.ties.erase(std::remove_if(memory_.ties.begin(), memory_.ties.end(), torn), memory_.ties.end());
  for (Tie& tie : memory_.ties) tie.countSeparated(mesh);
}

bool Ties::begin(const StepStart& start, std::vector<Spring>* springs) {
  for (const Tie& tie : memory_.ties) {
    const Part &plus = start.mesh.parts()[tie.section.plus], &minus = start.mesh.parts()[tie.section.minus];
    const double s = std::max((tie.share() - tie.share_then) / (1 - tie.share_then), FIRST_SHARE);
    const double stiffness = tie.steepness * (1 - s) / s * (1 - s) * tie.area / 3;
    for (const Barycentric& anchor : tie.anchors) {
      Spring& spring = springs->emplace_back();
      for (int I = 0; I < 4; ++I) spring.add(plus.copies[I], anchor[I]);
      for (int I = 0; I < 4; ++I) spring.add(minus.copies[I], -anchor[I]);
      spring.stiffness = stiffness * Mat3::Identity();
      spring.force = -stiffness * (at(plus, anchor, start.motion.x) - at(minus, anchor, start.motion.x));
    }
  }
  return !memory_.ties.empty();
}

Ties::Ahead Ties::ahead(int element, const Barycentric& point) const {
  Ahead found;
  for (const Tie& tie : memory_.ties) {
    if (tie.section.element != element || std::abs(tie.distance.dot(point)) > REACH * tie.size) continue;
    found.section = &tie.section;
    // In affine coordinates an element is one wide.
    const Vec3 across = gradient(tie.distance).normalized();
    found.unswept = std::any_of(tie.unswept.begin(), tie.unswept.end(), [&](const Barycentric& other) {
      const Vec3 away = (other - point).tail<3>();
      return (away - away.dot(across) * across).squaredNorm() < NEAR * NEAR;
    });
    if (found.unswept) break;
  }
  return found;
}

void Ties::joinPieces(const CutMesh& mesh, const std::vector<int>& piece, DisjointSets* sets) const {
  const auto pieceOf = [&](int part) { return piece[mesh.parts()[part].copies[0]]; };
  for (const Tie& tie : memory_.ties) sets->join(pieceOf(tie.section.plus), pieceOf(tie.section.minus));
}

}  // namespace incision

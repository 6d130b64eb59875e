#include "incision/tool/blade/ties.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace incision {
namespace {

/// How far from a section's plane, in elements, the sweep of another crack still frees it. That of its own does
/// wherever it passes the element: a crack that is one plane in each element strays from a curved path.
constexpr double REACH = 0.5;

/// How near to a point, in elements, one that is not swept has to be: two spacings of the points of a section.
constexpr double NEAR = 0.2;

}  // namespace

void Ties::addSection(int crack, int part, const CutMesh& mesh) {
  const Polytope& polytope = mesh.polytope(part);
  const Facet* facet = facetOf(polytope, crack);
  if (!facet) return;  // it was severed
  const int element = mesh.parts()[part].element;
  const auto resting = [&](const Barycentric& b) { return atRest(mesh, element, b); };
  Tie tie;
  tie.area = vectorArea(polytope, *facet, resting).norm();
  if (!progressive_) {
    area_ += tie.area;
    return;
  }
  tie.section = sectionOf(mesh, part, *facet);
  tie.size = std::cbrt(6 * elementVolume(mesh.mesh(), element));
  tie.steepness = young_modulus_ / tie.size;
  const Vec3 on_plane = resting(tie.section.point);
  for (int I = 0; I < 4; ++I) tie.distance[I] = tie.section.across.dot(resting(Barycentric::Unit(I)) - on_plane);
  tie.left = spread(cornersOf(polytope, *facet));
  tie.count = tie.left.size();
  ties_.push_back(std::move(tie));
}

/// Takes out the points that the triangle lies behind or before, seen along the normal.
void Ties::mark(const SweptTriangle& triangle, bool own, Tie* tie) {
  const Vec3 across = gradient(tie->distance);
  const Vec3 normal = (triangle[1] - triangle[0]).tail<3>().cross((triangle[2] - triangle[0]).tail<3>());
  const auto swept = std::remove_if(tie->left.begin(), tie->left.end(), [&](const Barycentric& point) {
    if (!isBehind(triangle, point, across)) return false;
    // point + t across lies in the triangle, and away by t |across|².
    const double t = normal.dot((triangle[0] - point).tail<3>()) / normal.dot(across);
    return own || std::abs(t) * across.squaredNorm() < REACH * tie->size;
  });
  if (swept == tie->left.end()) return;
  area_ += tie->area * static_cast<double>(tie->left.end() - swept) / static_cast<double>(tie->count);
  tie->left.erase(swept, tie->left.end());
  tie->changed = true;
}

void Ties::sweep(const std::unordered_map<int, std::vector<SweptTriangle>>& swept, int crack) {
  for (Tie& tie : ties_)
    if (const auto found = swept.find(tie.section.element); found != swept.end())
      for (const SweptTriangle& triangle : found->second) mark(triangle, tie.section.crack == crack, &tie);
  update();
}

/// Lets go of what has been swept, and finds where the rest is held.
void Ties::update() {
  const auto free = [&](const Tie& tie) {
    if (tie.share() < LAST_SHARE) return false;
    area_ += tie.area * (1 - tie.share());
    return true;
  };
  ties_.erase(std::remove_if(ties_.begin(), ties_.end(), free), ties_.end());
  for (Tie& tie : ties_)
    if (std::exchange(tie.changed, false)) hold(&tie);
}

/// Three points of equal weight with the mean m and the second moments C = Σ aₖ aₖᵀ of all: m + √2 (a₁ cos θ + a₂ sin
/// θ) for θ = 0, 2π/3, 4π/3. What is held there resists every linear opening as the whole does.
void Ties::hold(Tie* tie) {
  const double count = static_cast<double>(tie->left.size());
  Barycentric mean = Barycentric::Zero();
  for (const Barycentric& point : tie->left) mean += point / count;
  Eigen::Matrix4d moments = Eigen::Matrix4d::Zero();
  for (const Barycentric& point : tie->left) moments += (point - mean) * (point - mean).transpose() / count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> axes(moments);  // ascending
  for (int k = 0; k < 3; ++k) {
    const double angle = 2 * M_PI * k / 3;
    tie->holds[k] = mean;
    for (int a = 0; a < 2; ++a)
      tie->holds[k] += std::sqrt(2 * std::max(0.0, axes.eigenvalues()[3 - a])) *
                       (a == 0 ? std::cos(angle) : std::sin(angle)) * axes.eigenvectors().col(3 - a);
  }
  tie->section.point = mean;
}

void Ties::topologyChanged(const CutMesh& mesh) {
  const auto torn = [&](Tie& tie) { return !findSides(mesh, &tie.section); };
  ties_.erase(std::remove_if(ties_.begin(), ties_.end(), torn), ties_.end());
}

void Ties::begin(const CutMesh& mesh, const std::vector<Vec3>& x) {
  for (Tie& tie : ties_) {
    const Part &plus = mesh.parts()[tie.section.plus], &minus = mesh.parts()[tie.section.minus];
    int apart = 0;
    for (int I = 0; I < 4; ++I) apart += plus.copies[I] != minus.copies[I];
    if (apart > tie.apart) tie.from = tie.share();
    tie.apart = apart;
    const double s = std::max((tie.share() - tie.from) / (1 - tie.from), FIRST_SHARE);
    const double stiffness = tie.steepness * (1 - s) / s * (1 - s) * tie.area / 3;
    for (int k = 0; k < 3; ++k) {
      Coupling& coupling = tie.couplings[k];
      coupling = Coupling();
      for (int I = 0; I < 4; ++I) coupling.add(plus.copies[I], tie.holds[k][I]);
      for (int I = 0; I < 4; ++I) coupling.add(minus.copies[I], -tie.holds[k][I]);
      coupling.stiffness = stiffness * Mat3::Identity();
      coupling.force = -stiffness * (at(plus, tie.holds[k], x) - at(minus, tie.holds[k], x));
    }
  }
}

void Ties::append(std::vector<Coupling>* couplings) const {
  for (const Tie& tie : ties_) couplings->insert(couplings->end(), tie.couplings.begin(), tie.couplings.end());
}

Ties::Ahead Ties::ahead(int element, const Barycentric& point) const {
  Ahead found;
  for (const Tie& tie : ties_) {
    if (tie.section.element != element || std::abs(tie.distance.dot(point)) > REACH * tie.size) continue;
    found.section = &tie.section;
    // In affine coordinates an element is one wide.
    const Vec3 across = gradient(tie.distance).normalized();
    found.unswept = std::any_of(tie.left.begin(), tie.left.end(), [&](const Barycentric& left) {
      const Vec3 away = (left - point).tail<3>();
      return (away - away.dot(across) * across).squaredNorm() < NEAR * NEAR;
    });
    if (found.unswept) break;
  }
  return found;
}

int Ties::joinPieces(const CutMesh& mesh, std::vector<int>* piece_of) const {
  const int count = 1 + *std::max_element(piece_of->begin(), piece_of->end());
  std::vector<int> joined(static_cast<std::size_t>(count));
  std::iota(joined.begin(), joined.end(), 0);
  for (const Tie& tie : ties_) {
    const int a = joined[(*piece_of)[mesh.parts()[tie.section.plus].copies[0]]];
    const int b = joined[(*piece_of)[mesh.parts()[tie.section.minus].copies[0]]];
    std::replace(joined.begin(), joined.end(), std::max(a, b), std::min(a, b));
  }
  std::vector<int> number(joined.size(), -1);
  int pieces = 0;
  for (int root : joined)
    if (number[root] < 0) number[root] = pieces++;
  for (int& piece : *piece_of) piece = number[joined[piece]];
  return pieces;
}

}  // namespace incision

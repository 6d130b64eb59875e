#include "incision/cut/part.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "incision/base/sort_once.h"
#include "incision/mesh/tet_mesh.h"

namespace incision {
namespace {

/// The affine coordinates (N_1, N_2, N_3): a right-handed image of the element in which V_e is 1/6.
Vec3 affine(const Barycentric& b) { return b.tail<3>(); }

/// Splits the corner lists of facets along the edges whose ends have opposite signs.
class Splitter {
 public:
  Splitter(const Polytope& polytope, const Eigen::Vector4d& phi, const std::vector<signed char>& signs)
      : polytope_(polytope), phi_(phi), signs_(signs) {
    corners_.reserve(2 * polytope.corners.size());
    corners_ = polytope.corners;
    for (auto* half : {&positive_, &negative_}) half->reserve(polytope.facets.size() + 1);
  }

  std::optional<Split> run(int crack) {
    for (const Facet& facet : polytope_.facets) clip(facet);
    std::vector<int> loop = sectionLoop();
    if (loop.size() < 3) return std::nullopt;
    Split result;
    for (int c : loop) result.section.push_back(corners_[c]);
    negative_.push_back({loop, -1, crack});
    std::reverse(loop.begin(), loop.end());
    positive_.push_back({loop, -1, crack});
    result.positive = compact(positive_);
    result.negative = compact(negative_);
    return result;
  }

 private:
  void clip(const Facet& facet) {
    Facet above{{}, facet.face, facet.crack}, below = above;
    bool any_above = false, any_below = false;
    const std::size_t n = facet.corners.size();
    for (auto* corners : {&above.corners, &below.corners}) corners->reserve(n + 2);
    for (std::size_t i = 0; i < n; ++i) {
      const int a = facet.corners[i], b = facet.corners[(i + 1) % n];
      if (signs_[a] >= 0) above.corners.push_back(a);
      if (signs_[a] <= 0) below.corners.push_back(a);
      any_above |= signs_[a] > 0;
      any_below |= signs_[a] < 0;
      if (signs_[a] * signs_[b] < 0) {
        const int c = crossing(a, b);
        above.corners.push_back(c);
        below.corners.push_back(c);
      }
    }
    // A facet wholly on the section goes with the positive half, as parts do.
    if ((any_above || !any_below) && above.corners.size() >= 3) positive_.push_back(std::move(above));
    if (any_below && below.corners.size() >= 3) negative_.push_back(std::move(below));
  }

  /// The corner where φ vanishes between two corners. Always reckoned from the positive end, so that all facets, and
  /// the neighbour across a face, get the same point.
  int crossing(int a, int b) {
    if (signs_[a] < 0) std::swap(a, b);
    const auto known = std::find_if(crossings_.begin(), crossings_.end(),
                                    [&](const Crossing& crossing) { return crossing.a == a && crossing.b == b; });
    if (known != crossings_.end()) return known->corner;
    const double at_a = phi_.dot(corners_[a]), at_b = phi_.dot(corners_[b]);
    const Barycentric point = corners_[a] + at_a / (at_a - at_b) * (corners_[b] - corners_[a]);
    crossings_.push_back({a, b, static_cast<int>(corners_.size())});
    corners_.push_back(point);
    return crossings_.back().corner;
  }

  bool liesOnSection(int c) const { return c >= static_cast<int>(signs_.size()) || signs_[c] == 0; }

  /// The rim that the positive facets leave open, counter-clockwise seen from the positive side.
  std::vector<int> sectionLoop() const {
    std::vector<std::pair<int, int>> edges, rim;
    for (const Facet& facet : positive_)
      for (std::size_t i = 0; i < facet.corners.size(); ++i) {
        const int a = facet.corners[i], b = facet.corners[(i + 1) % facet.corners.size()];
        if (liesOnSection(a) && liesOnSection(b)) edges.emplace_back(a, b);
      }
    sortOnce(&edges);
    for (const auto& [a, b] : edges) {
      if (std::binary_search(edges.begin(), edges.end(), std::pair(b, a))) continue;
      if (!rim.empty() && rim.back().first == a) return {};  // two ways on
      rim.emplace_back(a, b);
    }
    std::vector<int> loop;
    if (rim.empty()) return loop;
    for (int c = rim.front().first; loop.size() <= rim.size();) {
      loop.push_back(c);
      const auto step = std::lower_bound(rim.begin(), rim.end(), std::pair(c, -1));
      if (step == rim.end() || step->first != c) return {};
      c = step->second;
      if (c == loop.front()) break;
    }
    return loop.size() == rim.size() ? loop : std::vector<int>();
  }

  Polytope compact(const std::vector<Facet>& facets) const {
    Polytope half;
    half.facets = facets;
    std::vector<int> number(corners_.size(), -1);
    for (Facet& facet : half.facets)
      for (int& c : facet.corners) {
        if (number[c] < 0) {
          number[c] = static_cast<int>(half.corners.size());
          half.corners.push_back(corners_[c]);
        }
        c = number[c];
      }
    return half;
  }

  const Polytope& polytope_;
  const Eigen::Vector4d& phi_;
  const std::vector<signed char>& signs_;
  std::vector<Barycentric> corners_;
  struct Crossing {
    int a, b, corner;
  };
  std::vector<Crossing> crossings_;
  std::vector<Facet> positive_, negative_;
};

}  // namespace

const Facet* Polytope::onFace(int face) const {
  for (const Facet& facet : facets)
    if (facet.face == face) return &facet;
  return nullptr;
}

const Polytope& wholeElement() {
  static const Polytope whole = [] {
    Polytope p;
    for (int i = 0; i < 4; ++i) p.corners.push_back(Barycentric::Unit(i));
    for (int f = 0; f < 4; ++f) p.facets.push_back({{FACE_NODES[f].begin(), FACE_NODES[f].end()}, f, -1});
    return p;
  }();
  return whole;
}

// A tetrahedron with corners b_k and volume v has the moments ∫N = v s/4 and ∫N Nᵀ = v/20 (Σ_k b_k b_kᵀ + s sᵀ), with
// s = Σ_k b_k. The polytope is the fan of tetrahedra from its first corner; being convex, all of them count positive,
// so the centroid is a mean of corners even where rounding spoils a volume.
PolytopeMoments moments(const Polytope& polytope) {
  PolytopeMoments m{0, Barycentric::Zero(), Eigen::Matrix4d::Zero()};
  const Barycentric& apex = polytope.corners[0];
  for (const Facet& facet : polytope.facets) {
    if (std::find(facet.corners.begin(), facet.corners.end(), 0) != facet.corners.end()) continue;
    for (std::size_t i = 2; i < facet.corners.size(); ++i) {
      const std::array<Barycentric, 4> b = {apex, polytope.corners[facet.corners[0]],
                                            polytope.corners[facet.corners[i - 1]], polytope.corners[facet.corners[i]]};
      Mat3 edges;
      for (int k = 0; k < 3; ++k) edges.col(k) = affine(b[k + 1]) - affine(b[0]);
      const double v = std::abs(edges.determinant());
      const Barycentric s = b[0] + b[1] + b[2] + b[3];
      m.fraction += v;
      m.centroid += v / 4 * s;
      m.products += v / 20 * (s * s.transpose());
      for (const Barycentric& corner : b) m.products += v / 20 * (corner * corner.transpose());
    }
  }
  if (m.fraction > std::numeric_limits<double>::min()) {
    m.centroid /= m.fraction;
    return m;
  }
  // Too thin for the arithmetic: the least share that still carries mass and stiffness, at the mean of the corners.
  m.fraction = std::numeric_limits<double>::epsilon() * std::numeric_limits<double>::epsilon();
  m.centroid.setZero();
  for (const Barycentric& corner : polytope.corners)
    m.centroid += corner / static_cast<double>(polytope.corners.size());
  m.products = m.fraction * m.centroid * m.centroid.transpose();
  return m;
}

std::vector<signed char> cornerSigns(const Polytope& polytope, const Eigen::Vector4d& phi, double zero) {
  std::vector<signed char> signs;
  signs.reserve(polytope.corners.size());
  for (const Barycentric& b : polytope.corners) {
    const double value = phi.dot(b);
    signs.push_back(value > zero ? 1 : value < -zero ? -1 : 0);
  }
  return signs;
}

std::optional<Split> split(const Polytope& polytope, const Eigen::Vector4d& phi, const std::vector<signed char>& signs,
                           int crack) {
  return Splitter(polytope, phi, signs).run(crack);
}

Barycentric polygonCentroid(const std::vector<Barycentric>& polygon) {
  // Ratios of areas in one plane are the same in affine coordinates as in space.
  std::vector<Vec3> normals;
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    normals.push_back((affine(polygon[i - 1]) - affine(polygon[0])).cross(affine(polygon[i]) - affine(polygon[0])));
    normal += normals.back();
  }
  Barycentric weighted = Barycentric::Zero(), mean = Barycentric::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i)
    weighted += normals[i - 2].dot(normal) * (polygon[0] + polygon[i - 1] + polygon[i]) / 3;
  const double area = normal.squaredNorm();
  if (area > std::numeric_limits<double>::min()) return weighted / area;
  for (const Barycentric& point : polygon) mean += point;
  return mean / static_cast<double>(polygon.size());
}

}  // namespace incision

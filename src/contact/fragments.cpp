#include "incision/contact/fragments.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "incision/base/parallel.h"

namespace incision {
namespace {

/// Triangles that a thread takes together.
constexpr int CHUNK = 64;

/// Faces meet where their normals are against each other, by at least 72° from being at right angles… to 180°.
constexpr double MAX_COSINE = -0.3;

/// How deep inside a sample may be, in elements; deeper, it is nearer to what lies on the other side.
constexpr double MAX_DEPTH = 0.5;

/// How far, in elements, the search looks beyond its reach, so that it need not be repeated in each step.
constexpr double SKIN = 0.05;

/// What a triangle is wider, as a share of it, so that a point above an edge falls on one of its two sides.
constexpr double RIM = 1e-2;

/// A foot with more than this weight on a corner is that corner: twins, as on two faces born together, are one contact.
constexpr double TWIN = 0.98;

/// At rest closer than this, in elements, two points of a piece are neighbours, and what lies behind is material.
constexpr double NEAR_AT_REST = 3;

/// Cells further out are one: so far, numbers of cells are still exact.
constexpr double MAX_CELL = 1e15;

/// Gaps at rest, in elements, that are rounding: faces born together.
constexpr double SAME_PLANE = 1e-6;

/// Weights of the foot of p's perpendicular on a triangle, whose normal a has twice its area for length.
Vec3 footOf(const Vec3& p, const Vec3& p0, const Vec3& p1, const Vec3& p2, const Vec3& a) {
  const double square = a.squaredNorm();
  const double w1 = (p - p0).cross(p2 - p0).dot(a) / square, w2 = (p1 - p0).cross(p - p0).dot(a) / square;
  return {1 - w1 - w2, w1, w2};
}

Vec3 meanOf(const std::vector<Vec3>& values) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& value : values) sum += value;
  return sum / static_cast<double>(std::max<std::size_t>(1, values.size()));
}

Vec3 normalised(const Vec3& a) {
  const double length = a.norm();
  return length > 0 ? Vec3(a / length) : Vec3::Zero();
}

/// A point and its foot that share all weights but this much move as one: so near the end of a slit, or where the
/// surface meets itself at an edge, the material keeps them together.
constexpr double ONE_POINT = 0.05;

bool isOnePoint(const Spring& contact) {
  double sum = 0;
  for (int i = 0; i < contact.count; ++i) sum += std::abs(contact.weights[i]);
  return sum < ONE_POINT;
}

/// Whether it has no area at rest: such triangles close the surface between parts that neither hang together nor are
/// severed. Their corners may belong to several parts, to more copies than a spring has room for.
bool closesGap(const ContactSurface& surface, int triangle) {
  const auto& [a, b, c] = surface.surface->triangles[triangle];
  const auto& X = surface.rest;
  const double size = surface.size[a];
  return !((X[b] - X[a]).cross(X[c] - X[a]).norm() > MIN_OVERLAP * size * size);
}

}  // namespace

void FragmentFinder::surfaceChanged() {
  memory_.x.clear();
  memory_.best.clear();
}

void FragmentFinder::find(const ContactSurface& surface, const std::vector<Vec3>& x, const std::vector<Vec3>& ahead,
                          int threads, std::vector<Candidate>* candidates) {
  measure(surface, x, threads);
  searched_ = !isFresh(surface, x, ahead);
  if (searched_) search(surface, x, ahead, threads);
  for (const Pair& pair : memory_.best) {
    if (pair.triangle < 0) continue;
    const int twin = twinOf(surface, pair);
    if (twin >= 0 && twin < pair.sample) continue;
    const Pair now = placed(surface, x, pair);
    const auto& [a, b, c] = surface.surface->triangles[now.triangle];
    const int vertex = surface.samples[now.sample].vertex;
    const Vec3 nearer =
        ahead[vertex] - now.weights[0] * ahead[a] - now.weights[1] * ahead[b] - now.weights[2] * ahead[c];
    if (now.gap + normals_[now.triangle].dot(nearer) < MARGIN * surface.size[vertex])
      candidates->push_back(candidate(surface, now, twin < 0 ? 0.5 : 1));
  }
}

/// Whether the pairs found last still hold: no vertex has moved, or moves in this step, further than the search looked
/// beyond its reach. What all vertices have moved alike does not count.
bool FragmentFinder::isFresh(const ContactSurface& surface, const std::vector<Vec3>& x,
                             const std::vector<Vec3>& ahead) const {
  if (memory_.x.size() != x.size()) return false;
  const Vec3 shift = meanOf(x) - meanOf(memory_.x), mean_ahead = meanOf(ahead);
  double farthest = 0, fastest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    farthest = std::max(farthest, (x[i] - memory_.x[i] - shift).squaredNorm());
    fastest = std::max(fastest, (ahead[i] - mean_ahead).squaredNorm());
  }
  return std::sqrt(farthest) + std::sqrt(fastest) < SKIN * surface.mean_size;
}

void FragmentFinder::stepFailed() {
  if (searched_) std::swap(memory_, before_);
  searched_ = false;
}

void FragmentFinder::search(const ContactSurface& surface, const std::vector<Vec3>& x, const std::vector<Vec3>& ahead,
                            int threads) {
  std::swap(memory_, before_);
  memory_.x = x;
  reach_ = MAX_DEPTH * surface.mean_size;
  const Vec3 mean_ahead = meanOf(ahead);
  paths_.resize(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    paths_[i] = ahead[i] - mean_ahead;
    paths_[i] *= std::min(1.0, surface.mean_size / std::max(surface.mean_size, paths_[i].norm()));
  }
  fillGrid(surface, x);
  const int triangles = static_cast<int>(surface.surface->triangles.size());
  found_.resize((triangles + CHUNK - 1) / CHUNK);
  parallelFor(static_cast<int>(found_.size()), threads, [&](int chunk) {
    found_[chunk].clear();
    for (int t = chunk * CHUNK; t < std::min(triangles, (chunk + 1) * CHUNK); ++t)
      pairTriangle(surface, x, t, &found_[chunk]);
  });
  memory_.best.assign(surface.samples.size(), {0, -1, 0, Vec3::Zero()});
  for (const std::vector<Pair>& pairs : found_)
    for (const Pair& pair : pairs) {
      Pair& best = memory_.best[pair.sample];
      if (best.triangle < 0 || std::abs(pair.gap) < std::abs(best.gap)) best = pair;
    }
}

/// The pair with its gap and foot as they are at `x`.
FragmentFinder::Pair FragmentFinder::placed(const ContactSurface& surface, const std::vector<Vec3>& x,
                                            const Pair& pair) const {
  const auto& [a, b, c] = surface.surface->triangles[pair.triangle];
  const Vec3& p = x[surface.samples[pair.sample].vertex];
  return {pair.sample, pair.triangle, normals_[pair.triangle].dot(p - x[a]),
          footOf(p, x[a], x[b], x[c], (x[b] - x[a]).cross(x[c] - x[a]))};
}

/// The sample that has this one for its foot as this one has it, or −1.
int FragmentFinder::twinOf(const ContactSurface& surface, const Pair& pair) const {
  const auto cornerOver = [&](const Pair& over, int vertex) {
    for (int k = 0; k < 3; ++k)
      if (over.weights[k] > TWIN && (vertex < 0 || surface.surface->triangles[over.triangle][k] == vertex))
        return surface.surface->triangles[over.triangle][k];
    return -1;
  };
  const int foot = cornerOver(pair, -1);
  if (foot < 0) return -1;
  for (int s = surface.sample_start[foot]; s < surface.sample_start[foot + 1]; ++s)
    if (memory_.best[s].triangle >= 0 && cornerOver(memory_.best[s], surface.samples[pair.sample].vertex) >= 0)
      return s;
  return -1;
}

Candidate FragmentFinder::candidate(const ContactSurface& surface, const Pair& pair, double share) const {
  const ContactSurface::Sample& sample = surface.samples[pair.sample];
  Candidate made;
  made.sample = pair.sample;
  made.partner = Candidate::BODY;
  made.normal = normals_[pair.triangle];
  made.gap = pair.gap;
  made.drift.setZero();
  made.slip.setZero();
  made.normal_in_solid.setZero();
  made.size = surface.size[sample.vertex];
  made.stiffness = share * (CONTACT_STIFFNESS * surface.young_modulus[sample.vertex]) * sample.area / made.size;
  made.point = between(surface, pair);
  return made;
}

void FragmentFinder::measure(const ContactSurface& surface, const std::vector<Vec3>& x, int threads) {
  const auto& triangles = surface.surface->triangles;
  normals_.resize(triangles.size());
  areas_.resize(triangles.size());
  parallelFor(static_cast<int>(triangles.size()), threads, [&](int t) {
    const auto& [a, b, c] = triangles[t];
    areas_[t] = (x[b] - x[a]).cross(x[c] - x[a]);
    normals_[t] = normalised(areas_[t]);
  });
  sample_normals_.resize(surface.samples.size());
  parallelFor(static_cast<int>(sample_normals_.size()), threads, [&](int s) {
    Vec3 sum = Vec3::Zero();
    for (int k = surface.samples[s].first; k < surface.samples[s].last; ++k) sum += areas_[surface.around[k]];
    sample_normals_[s] = normalised(sum);
  });
}

FragmentFinder::Cell FragmentFinder::cellOf(const Vec3& point) const {
  return (point / cell_).array().floor().max(-MAX_CELL).min(MAX_CELL).cast<std::int64_t>();
}

/// Mixes the three numbers by odd constants of many bits.
int FragmentFinder::slotOf(const Cell& cell) const {
  const Eigen::Array<std::uint64_t, 3, 1> u = cell.cast<std::uint64_t>();
  const std::uint64_t h = (u[0] * 0x9E3779B97F4A7C15) ^ (u[1] * 0xC2B2AE3D27D4EB4F) ^ (u[2] * 0x165667B19E3779F9);
  return static_cast<int>(static_cast<std::size_t>(h ^ (h >> 29)) & (slots_ - 1));
}

/// Calls f(slot) for the cells that a box meets, or returns false where those are too many to be worth it.
template <typename Function>
bool FragmentFinder::forEachSlot(const Eigen::AlignedBox3d& box, const Function& f) const {
  const Cell first = cellOf(box.min()), last = cellOf(box.max());
  if ((last - first + 1).cast<double>().prod() > static_cast<double>(slots_ + 1)) return false;
  for (Cell cell = first; cell[0] <= last[0]; ++cell[0])
    for (cell[1] = first[1]; cell[1] <= last[1]; ++cell[1])
      for (cell[2] = first[2]; cell[2] <= last[2]; ++cell[2]) f(slotOf(cell));
  return true;
}

/// What a vertex passes in the step, beside what all do.
Eigen::AlignedBox3d FragmentFinder::pathOf(const std::vector<Vec3>& x, int vertex) const {
  const Vec3 end = x[vertex] + paths_[vertex];
  return {x[vertex].cwiseMin(end), x[vertex].cwiseMax(end)};
}

/// A hashed grid: cells that share a slot only cost time.
void FragmentFinder::fillGrid(const ContactSurface& surface, const std::vector<Vec3>& x) {
  cell_ = surface.mean_size;
  slots_ = 1;
  while (slots_ < 2 * surface.samples.size()) slots_ *= 2;
  samples_in_.sort(static_cast<int>(slots_), [&](const auto& add) {
    for (std::size_t s = 0; s < surface.samples.size(); ++s)
      forEachSlot(pathOf(x, surface.samples[s].vertex), [&](int slot) { add(slot, static_cast<int>(s)); });
  });
}

void FragmentFinder::pairTriangle(const ContactSurface& surface, const std::vector<Vec3>& x, int triangle,
                                  std::vector<Pair>* pairs) const {
  if (normals_[triangle].isZero(0) || closesGap(surface, triangle)) return;
  Eigen::AlignedBox3d box;
  for (int vertex : surface.surface->triangles[triangle]) box.extend(pathOf(x, vertex));
  const Eigen::AlignedBox3d room(box.min().array() - reach_, box.max().array() + reach_);
  const auto consider = [&](int sample) {
    Pair pair;
    if (room.intersects(pathOf(x, surface.samples[sample].vertex)) && meets(surface, x, triangle, sample, &pair))
      pairs->push_back(pair);
  };
  const bool done = forEachSlot(room, [&](int slot) {
    for (int sample : samples_in_[slot]) consider(sample);
  });
  // A triangle stretched out of all proportion.
  for (std::size_t s = 0; !done && s < surface.samples.size(); ++s) consider(static_cast<int>(s));
}

/// Whether a sample lies before or just behind a triangle that faces it, near enough to meet it in the step, with
/// nothing of its piece in between.
bool FragmentFinder::meets(const ContactSurface& surface, const std::vector<Vec3>& x, int triangle, int sample,
                           Pair* pair) const {
  const Vec3& n = normals_[triangle];
  if (!(n.dot(sample_normals_[sample]) < MAX_COSINE)) return false;
  const int vertex = surface.samples[sample].vertex;
  const auto& [a, b, c] = surface.surface->triangles[triangle];
  if (vertex == a || vertex == b || vertex == c) return false;
  const double size = surface.size[vertex], gap = n.dot(x[vertex] - x[a]);
  const double ahead = std::max({n.dot(paths_[a]), n.dot(paths_[b]), n.dot(paths_[c])}) - n.dot(paths_[vertex]);
  if (!(gap > -MAX_DEPTH * size && gap < (MARGIN + 2 * SKIN) * size + std::max(0.0, ahead))) return false;
  *pair = placed(surface, x, {sample, triangle, gap, Vec3::Zero()});
  if (!(pair->weights.minCoeff() > -RIM)) return false;
  if (surface.piece[triangle] != surface.vertex_piece[vertex]) return true;
  const auto& X = surface.rest;
  const Vec3 N = normalised((X[b] - X[a]).cross(X[c] - X[a])), from = X[vertex] - X[a];
  const bool behind = N.dot(from) < -SAME_PLANE * size && from.norm() < NEAR_AT_REST * size;
  return !behind && !isOnePoint(between(surface, *pair));
}

/// What a contact acts on: the sample's point less its foot.
Spring FragmentFinder::between(const ContactSurface& surface, const Pair& pair) {
  Spring contact;
  addVertex(surface.surface->vertices[surface.samples[pair.sample].vertex], 1, &contact);
  for (int k = 0; k < 3; ++k)
    addVertex(surface.surface->vertices[surface.surface->triangles[pair.triangle][k]], -pair.weights[k], &contact);
  return contact;
}

}  // namespace incision

#include <algorithm>
#include <cmath>

#include "incision/tool/blade/stroke.h"

namespace incision {
namespace {

/// The way, in edges of the mesh, over which a crack takes its direction. Over less, tissue that moves while a slow
/// blade goes on would turn it; over more, it would not follow a curve.
constexpr double SMOOTHING = 1;

/// A sweep is another crack's where it would give a node of this one a distance that is off by this much, in edges of
/// the mesh, and another normal, by more than this cosine: a path that curves within two elements is off by a quarter.
constexpr double CROSSING = 0.5, SAME_WAY = 0.5;

/// A vector or its opposite, whichever points to the side of another.
Vec3 alike(const Vec3& side, const Vec3& vector) { return vector.dot(side) < 0 ? Vec3(-vector) : vector; }

}  // namespace

/// The crack's normal at the copies passed, from the sweeps round them over the last edge. Normals add up as
/// vectors, turned alike: of an edge that trembles, what goes sideways cancels, and an edge that goes back keeps to its
/// crack.
void Stroke::findHeadings(const CutMesh& mesh) {
  std::unordered_map<int, std::pair<Vec3, int>> sums;
  for (const Passed& passed : passed_)
    for (int c : mesh.parts()[passed.part].copies) {
      auto& [sum, count] = sums.try_emplace(c, Vec3::Zero(), 0).first->second;
      sum += passed.normal;
      ++count;
    }
  for (const auto& [c, sum] : sums) {
    Vec3& way = memory_.ways.try_emplace(c, Vec3::Zero()).first->second;
    const Vec3 mean = alike(way.isZero(0) ? memory_.normal : way, sum.first / sum.second);
    way = std::exp(-mean.norm() / (SMOOTHING * mesh.shortestEdge(mesh.copyNode(c)))) * way + mean;
  }
  headings_.clear();
  for (const Passed& passed : passed_) {
    const auto& copies = mesh.parts()[passed.part].copies;
    Vec3 sum = Vec3::Zero();
    for (int c : copies) sum += alike(memory_.normal, memory_.ways.at(c));
    for (int c : copies) headings_.try_emplace(c, Vec3::Zero()).first->second += sum;
  }
  turnAlike();
}

/// Turns the headings to the side of the sweep so far: a blade that goes back must not swap the crack's sides.
void Stroke::turnAlike() {
  Vec3 sum = Vec3::Zero();
  for (const Passed& passed : passed_) sum += passed.normal;
  if (memory_.normal.isZero(0)) memory_.normal = sum.stableNormalized();
  sum.setZero();
  for (auto& [c, heading] : headings_) {
    heading = alike(memory_.normal, heading.stableNormalized());
    sum += heading;
  }
  if (sum.norm() > 0) memory_.normal = sum.normalized();
}

/// From the edge as it stands now, along the heading [m]. Not from the edge's end: where the edge turns, a heading of
/// the way so far is not quite at right angles to it, and the end may be far.
double Stroke::distanceNow(int copy, const Edge& to, const std::vector<Vec3>& x) const {
  return headings_.at(copy).dot(x[copy] - nearest(to, x[copy]));
}

/// Whether the sweep goes on, into a part that the crack has not split, in another direction than the crack's there.
bool Stroke::crossesItself(const Edge& to, const std::vector<Vec3>& x, const CutMesh& mesh) const {
  if (!memory_.crack) return false;
  return std::any_of(passed_.begin(), passed_.end(), [&](const Passed& passed) {
    if (!passed.within || facetOf(mesh.polytope(passed.part), *memory_.crack)) return false;
    const Part& part = mesh.parts()[passed.part];
    const double far = CROSSING * shortestEdge(part, mesh);
    return std::any_of(part.copies.begin(), part.copies.end(), [&](int c) {
      const auto known = memory_.distances.find(c);
      return known != memory_.distances.end() && known->second.settled &&
             known->second.normal.dot(headings_.at(c)) < SAME_WAY &&
             std::abs(known->second.phi - distanceNow(c, to, x)) > far;
    });
  });
}

/// Measures the copies of the parts the sweep passes, but for the settled ones.
void Stroke::measure(const Edge& to, const std::vector<Vec3>& x, const CutMesh& mesh) {
  for (const auto& [c, heading] : headings_) {
    if (heading.isZero(0)) continue;
    Distance& distance = memory_.distances[c];
    if (distance.settled) continue;
    const double phi = distanceNow(c, to, x);
    distance.phi = std::abs(phi) < SNAP * mesh.shortestEdge(mesh.copyNode(c)) ? 0 : phi;
    distance.normal = heading;
    if (known_parts_ > 0) measured_since_.push_back(c);
  }
}

}  // namespace incision

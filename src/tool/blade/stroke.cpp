#include "incision/tool/blade/stroke.h"

#include <algorithm>
#include <cmath>

#include "incision/cut/cut_here.h"

namespace incision {
namespace {

/// Triangles of the sweep kept for one element; the oldest go first. An element is cut by the first of the sweeps that
/// enter it; these tell what the last element of the way was.
constexpr std::size_t MAX_TRIANGLES = 128;

/// How far from an element, in its own coordinates, a sweep still counts as passing it. A crack that is one plane in
/// each element runs beside the swept surface by what that bends within one, and so through elements that the surface
/// itself just misses.
constexpr double MARGIN = 0.5;

/// How far from a cut element, in its own coordinates, a sweep still frees it: on a path that curves within two
/// elements the blade is beside the far end of the crack in one when it is well into the next.
constexpr double FREEING_MARGIN = 1;

/// How far the edge must move through the tissue, in edges of the mesh, to be followed: tissue that trembles round a
/// blade at rest is not cut, and a slow blade cuts in as many pieces as matter.
constexpr double MIN_MOTION = 0.01;

/// How far the edge must move across itself, as a share of its length, for a sweep to have a direction; an edge that
/// moves along itself moves by rounding.
constexpr double MIN_SWEEP = 1e-9;

/// The way, in edges of the mesh, over which a crack takes its direction. Over less, tissue that moves while a slow
/// blade goes on would turn it; over more, it would not follow a curve.
constexpr double SMOOTHING = 1;

/// A sweep is another crack's where it would give a node of this one a distance that is off by this much, in edges of
/// the mesh, and another normal, by more than this cosine: a path that curves within two elements is off by a quarter.
constexpr double CROSSING = 0.5, SAME_WAY = 0.5;

/// How far an edge goes on that has come out of the body, in elements: as far as a sweep may be from an element that it
/// passes.
constexpr double LEAVING = 0.5;

/// Whether all of a sweep, its corners given in an element's coordinates, lies outside the element by more than
/// `margin`. A long edge passes by many elements with its ends beyond different faces.
bool outside(const std::array<Barycentric, 4>& corners, double margin) {
  for (int I = 0; I < 4; ++I)
    if (std::all_of(corners.begin(), corners.end(), [&](const Barycentric& b) { return b[I] < -margin; })) return true;
  return !reaches({corners[0], corners[1], corners[2]}, margin) &&
         !reaches({corners[0], corners[2], corners[3]}, margin);
}

/// Whether a sweep within `reach`, its corners given in an element's coordinates, meets what cracks have left of the
/// element to a part. The rest of the element follows copies that are nowhere near the material: `was` and `is` tell
/// where that is before and after.
bool meetsMaterial(const CutMesh& mesh, int part, const std::array<Barycentric, 4>& corners, const PartFrame& was,
                   const PartFrame& is, const Eigen::AlignedBox3d& reach) {
  if (mesh.parts()[part].detail < 0) return true;
  const Polytope& polytope = mesh.polytope(part);
  Eigen::AlignedBox3d box;
  for (const Barycentric& b : polytope.corners) box.extend(was.toBody(b)).extend(is.toBody(b));
  return reach.intersects(box) && (reaches({corners[0], corners[1], corners[2]}, polytope) ||
                                   reaches({corners[0], corners[2], corners[3]}, polytope));
}

/// The point of the line through an edge that is nearest to `point`.
Vec3 nearest(const Edge& edge, const Vec3& point) {
  const Vec3 along = edge[1] - edge[0];
  return edge[0] + (point - edge[0]).dot(along) / along.squaredNorm() * along;
}

/// A severed face, not a section through the part.
bool liesInFace(const std::vector<Barycentric>& polygon) {
  for (int I = 0; I < 4; ++I)
    if (std::all_of(polygon.begin(), polygon.end(), [&](const Barycentric& b) { return b[I] == 0; })) return true;
  return false;
}

/// Whether a section of a part, or what it has in common with another on a face of the mesh, lies in a cut that was
/// there before, so that the blade runs in that one.
bool runsInSlit(const CutMesh& mesh, const Materials& materials, int p, const std::vector<Barycentric>& polygon,
                int growing) {
  const int element = mesh.parts()[p].element;
  const auto resting = [&](const Barycentric& b) { return atRest(mesh, element, b); };
  CutSought sought;
  sought.point = resting(polygonCentroid(polygon));
  sought.normal = vectorArea(polygon, resting);
  sought.distance = SLIT_REACH * materials.size(element);
  sought.cosine = SLIT_COSINE;
  sought.growing = growing;
  return isCutHere(mesh, p, sought);
}

/// A vector or its opposite, whichever points to the side of another.
Vec3 alike(const Vec3& side, const Vec3& vector) { return vector.dot(side) < 0 ? Vec3(-vector) : vector; }

double shortestEdge(const Part& part, const CutMesh& mesh) {
  double shortest = mesh.shortestEdge(mesh.copyNode(part.copies[0]));
  for (int I = 1; I < 4; ++I) shortest = std::min(shortest, mesh.shortestEdge(mesh.copyNode(part.copies[I])));
  return shortest;
}

}  // namespace

void Stroke::start(const Edge& edge, const std::vector<Vec3>& x) {
  if (!memory_.last_x.empty()) return;
  start_edge_ = edge;
  start_x_ = x;
}

Insertion Stroke::sweep(const Edge& to, const std::vector<Vec3>& x, const Materials& materials, MeshDoor* door,
                        Ties* ties) {
  const CutMesh& mesh = door->mesh();
  if (memory_.last_x.empty()) {
    memory_.from = start_edge_;
    memory_.last_x = start_x_;
  }
  for (int c = static_cast<int>(memory_.last_x.size()); c < mesh.numCopies(); ++c)
    memory_.last_x.push_back(memory_.last_x[mesh.copyParent(c)]);
  if (!record(to, x, mesh)) return {};
  memory_.from = to;
  memory_.last_x = x;
  if (passed_.empty()) return {};
  keepTriangles(mesh);
  ties->sweep(just_swept_, memory_.crack);
  findHeadings(mesh);
  if (crossesItself(to, x, mesh)) {
    memory_.crack = -1;
    memory_.distances.clear();
    memory_.ways.clear();
    findHeadings(mesh);
  }
  measure(to, x, mesh);
  if (!memory_.begun) return {};  // it is only near
  return cut(materials, door, ties);
}

/// The crack keeps the distances that it has.
Insertion Stroke::leave(const Edge& way, const std::vector<Vec3>& x, const Materials& materials, MeshDoor* door,
                        Ties* ties) {
  const double moved = std::max(way[0].norm(), way[1].norm());
  if (memory_.crack < 0 || !(moved > 0)) return {};
  const CutMesh& mesh = door->mesh();
  memory_.last_x = x;
  const double beyond = LEAVING * materials.meanSize() / moved;
  const Edge to = {memory_.from[0] + beyond * way[0], memory_.from[1] + beyond * way[1]};
  if (!record(to, x, mesh) || passed_.empty()) return {};
  keepTriangles(mesh);
  ties->sweep(just_swept_, memory_.crack);
  return cut(materials, door, ties);
}

/// Cuts what the crack meets and the sweep so far covers.
Insertion Stroke::cut(const Materials& materials, MeshDoor* door, Ties* ties) {
  const CutMesh& mesh = door->mesh();
  CrackField crack = field(mesh);
  crack.contains = [&](int part, const std::vector<Barycentric>& polygon) {
    return covers(mesh.parts()[part], polygon, crack.phi, ties->progressive()) &&
           !runsInSlit(mesh, materials, part, polygon, memory_.crack);
  };
  const int before = mesh.numCopies();
  const Insertion done = door->insert(crack);
  if (!done.changed()) return done;
  memory_.cracks += memory_.crack < 0;
  memory_.crack = done.crack;
  settle(done, before, mesh);
  ties->add(done, mesh, memory_.swept);
  return done;
}

/// Finds the parts that the sweep passes. It starts where the last sweep left the element's material, so the surface
/// has no gaps however the tissue moves under the blade. Returns false where the edge has hardly moved in any.
bool Stroke::record(const Edge& to, const std::vector<Vec3>& x, const CutMesh& mesh) {
  passed_.clear();
  beside_.clear();
  const Vec3 direction = (to[1] - to[0]).normalized();
  const double least = MIN_SWEEP * (to[1] - to[0]).norm();
  Eigen::AlignedBox3d reach;
  for (const Edge& edge : {memory_.from, to})
    for (const Vec3& end : edge) reach.extend(end);
  bool near = false, moved = false;
  for (std::size_t p = 0; p < mesh.parts().size(); ++p) {
    const Part& part = mesh.parts()[p];
    const Eigen::AlignedBox3d box = boxOf(part, x).merged(boxOf(part, memory_.last_x));
    const auto meets = [&](double margin) {
      const Vec3 room = margin * box.sizes();
      return reach.intersects(Eigen::AlignedBox3d(box.min() - room, box.max() + room));
    };
    if (!meets(part.detail >= 0 ? FREEING_MARGIN : MARGIN)) continue;
    const PartFrame was(part, memory_.last_x), is(part, x);
    if (!was.invertible() || !is.invertible()) continue;
    Passed passed;
    passed.part = static_cast<int>(p);
    passed.corners = {was.toElement(memory_.from[0]), was.toElement(memory_.from[1]), is.toElement(to[1]),
                      is.toElement(to[0])};
    if (outside(passed.corners, FREEING_MARGIN)) continue;
    if (!meets(MARGIN) || outside(passed.corners, MARGIN)) {
      if (part.detail >= 0) beside_.push_back(passed);
      continue;
    }
    const Edge carried = {is.toBody(passed.corners[0]), is.toBody(passed.corners[1])};
    near = true;
    moved = moved ||
            std::max((to[0] - carried[0]).norm(), (to[1] - carried[1]).norm()) > MIN_MOTION * shortestEdge(part, mesh);
    const Vec3 centre = is.toBody(Barycentric::Constant(0.25));
    passed.normal = direction.cross(nearest(to, centre) - nearest(carried, centre));
    if (!(passed.normal.norm() > least)) continue;
    passed.within = !outside(passed.corners, 0) && meetsMaterial(mesh, passed.part, passed.corners, was, is, reach);
    passed_.push_back(passed);
  }
  if (near && !moved) return false;
  memory_.begun =
      memory_.begun || std::any_of(passed_.begin(), passed_.end(), [](const Passed& passed) { return passed.within; });
  return true;
}

void Stroke::keepTriangles(const CutMesh& mesh) {
  just_swept_.clear();
  const auto keep = [&](const Passed& passed) {
    const std::array<Barycentric, 4>& c = passed.corners;
    std::vector<SweptTriangle>& triangles = just_swept_[mesh.parts()[passed.part].element];
    triangles.push_back({c[0], c[1], c[2]});
    triangles.push_back({c[0], c[2], c[3]});
  };
  for (const Passed& passed : passed_) keep(passed);
  for (const auto& [element, triangles] : just_swept_) {
    std::deque<SweptTriangle>& kept = memory_.swept[element];
    kept.insert(kept.end(), triangles.begin(), triangles.end());
    while (kept.size() > MAX_TRIANGLES) kept.pop_front();
  }
  for (const Passed& passed : beside_) keep(passed);
}

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
  if (memory_.crack < 0) return false;
  return std::any_of(passed_.begin(), passed_.end(), [&](const Passed& passed) {
    if (!passed.within || facetOf(mesh.polytope(passed.part), memory_.crack)) return false;
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
  }
}

/// The crack in all elements of the sweep so far: a copy that is measured anew can change what it means for elements
/// that the blade has left behind, and neighbours must agree.
CrackField Stroke::field(const CutMesh& mesh) const {
  CrackField crack;
  crack.crack = memory_.crack;
  crack.phi.assign(mesh.numCopies(), 0);
  for (const auto& [copy, distance] : memory_.distances) crack.phi[copy] = distance.phi;
  for (const auto& [element, unused] : memory_.swept)
    for (int p = element; p >= 0; p = mesh.parts()[p].next) {
      const auto& copies = mesh.parts()[p].copies;
      if (std::all_of(copies.begin(), copies.end(), [&](int c) { return memory_.distances.count(c) > 0; }))
        crack.parts.push_back(p);
    }
  std::sort(crack.parts.begin(), crack.parts.end());
  return crack;
}

/// Whether the sweep so far passed enough of a section, or the centroid of a face, seen along the gradient of φ.
bool Stroke::covers(const Part& part, const std::vector<Barycentric>& polygon, const std::vector<double>& phi,
                    bool progressive) const {
  const auto found = memory_.swept.find(part.element);
  if (found == memory_.swept.end()) return false;
  const std::deque<SweptTriangle>& triangles = found->second;
  const Vec3 across =
      gradient(Eigen::Vector4d(phi[part.copies[0]], phi[part.copies[1]], phi[part.copies[2]], phi[part.copies[3]]));
  const auto covered = [&](const Barycentric& point) {
    return std::any_of(triangles.begin(), triangles.end(),
                       [&](const SweptTriangle& triangle) { return isBehind(triangle, point, across); });
  };
  if (!progressive || liesInFace(polygon)) return covered(polygonCentroid(polygon));
  const std::vector<Barycentric> points = spread(polygon);
  double left = FIRST_SHARE * static_cast<double>(points.size());
  return std::any_of(points.begin(), points.end(), [&](const Barycentric& point) {
    left -= covered(point);
    return left <= 0;
  });
}

/// The copies of the parts that were split keep their distances, and pass them on to the new ones.
void Stroke::settle(const Insertion& done, int before, const CutMesh& mesh) {
  for (int part : done.parts)
    for (int c : mesh.parts()[part].copies) memory_.distances.at(c < before ? c : mesh.copyParent(c)).settled = true;
  for (int c = before; c < mesh.numCopies(); ++c) {
    if (const auto parent = memory_.distances.find(mesh.copyParent(c)); parent != memory_.distances.end())
      memory_.distances.emplace(c, Distance(parent->second));
    if (const auto parent = memory_.ways.find(mesh.copyParent(c)); parent != memory_.ways.end())
      memory_.ways.emplace(c, Vec3(parent->second));
  }
}

}  // namespace incision

#include "incision/contact/solid_contacts.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace incision {
namespace {

/// A share of a shape's thickness. Where the edge is that of a thin box, the other side of its narrow face is just as
/// far from it as the shape gives way.
constexpr double ROUNDING = 1e-6;

/// Length of the mean of the normals of a vertex's sides, below which they have none together: it is 0.58 at the corner
/// of a box, and 0.33 where the two faces of a slit end in the skin.
constexpr double LEAST_SIDE = 0.5;

/// Least share of its weights that a vertex of a slit must have for itself to be pushed aside: with less the material
/// at the slit's end keeps its two faces together, and copies would have to go ten times as far as the vertex.
constexpr double LEAST_UNSHARED = 0.1;

/// What vertices may be deeper in a solid at the end of a step than was reckoned, in elements. A part of a step has its
/// share.
constexpr double DEEPER_IN_SOLID = 0.1;

Eigen::Isometry3d toIsometry(const Pose& pose) { return Eigen::Translation3d(pose.position) * pose.orientation; }

/// Twice the area vector of a triangle of the surface [m²].
Vec3 areaOf(const ContactSurface& surface, const std::vector<Vec3>& x, int triangle) {
  const auto& [a, b, c] = surface.surface->triangles[triangle];
  return (x[b] - x[a]).cross(x[c] - x[a]);
}

/// A solid through the step.
struct MovingShape {
  const Solid* solid;
  Eigen::Isometry3d in_link, from, to;
  double reach;                // of the solid [m]
  double moved = 0;            // a bound on how far any point of it moves [m]
  bool in_slits = false;       // it may stand in a slit
  const Edge* edge = nullptr;  // in the link's frame, near which it gives way
};

MovingShape placeShape(const Obstacle& obstacle, const SolidsInStep& solids, const StepSpan& span) {
  const Eigen::Isometry3d in_link = toIsometry(obstacle.pose);
  MovingShape placed{obstacle.solid.get(), in_link, in_link, in_link, obstacle.solid->reach()};
  if (obstacle.link == GROUND_LINK) return placed;
  const RigidMotion& motion = solids.motions[static_cast<std::size_t>(obstacle.link)];
  placed.from = toIsometry(motion.at(span.from)) * in_link;
  placed.to = toIsometry(motion.at(span.to)) * in_link;
  placed.moved = (placed.to.translation() - placed.from.translation()).norm() +
                 placed.reach * (placed.to.linear() - placed.from.linear()).norm();
  placed.in_slits = solids.in_slits;
  placed.edge = solids.cutting_edge;
  return placed;
}

/// The unit normal of the faces that cuts have made at a vertex, to which each of its sides gives alike: zero where it
/// has none, none where they look against each other.
std::optional<Vec3> cutNormalAt(const ContactSurface& surface, const std::vector<Vec3>& x, int vertex) {
  Vec3 sum = Vec3::Zero();
  int sides = 0;
  for (int s = surface.sample_start[vertex]; s < surface.sample_start[vertex + 1]; ++s) {
    const ContactSurface::Sample& sample = surface.samples[s];
    if (!surface.surface->cut_face[surface.around[sample.first]]) continue;
    Vec3 area = Vec3::Zero();
    for (int k = sample.first; k < sample.last; ++k) area += areaOf(surface, x, surface.around[k]);
    sum += area.stableNormalized();
    ++sides;
  }
  if (sides > 0 && !(sum.norm() > LEAST_SIDE * sides)) return std::nullopt;
  return sum.stableNormalized();
}

/// The unit normal of the cut face nearest to a vertex of the skin, of those that a part of the vertex has, that run
/// along a surface with normal `along` and in whose plane the vertex lies within `reach` [m]; zero where there is none.
Vec3 cutNormalBeside(const ContactSurface& surface, const std::vector<Vec3>& x, int vertex, const Vec3& along,
                     double reach) {
  Vec3 normal = Vec3::Zero();
  for (int s = surface.sample_start[vertex]; s < surface.sample_start[vertex + 1]; ++s)
    for (int k = surface.samples[s].first; k < surface.samples[s].last; ++k)
      for (const int t : surface.cut_triangles[surface.surface->part[surface.around[k]]]) {
        const Vec3 n = areaOf(surface, x, t).stableNormalized();
        const double away = std::abs(n.dot(x[vertex] - x[surface.surface->triangles[t][0]]));
        if (std::abs(n.dot(along)) < LEAST_OPPOSITION || away > reach) continue;
        reach = away;
        normal = n;
      }
  return normal;
}

/// From the nearest point, but on the side on which the point was at its touch, if it was; also where it has come out
/// on the far side of something thin. A solid that is not convex may have a face there that looks the other way and
/// that the point has just come upon: only what is behind the plane that it touched has gone through.
SolidDistance distanceFrom(const Touch* touch, const Solid& solid, const Vec3& point) {
  const SolidDistance nearest = solid.distanceTo(point);
  if (!touch) return nearest;
  const Vec3& known_side = touch->normal_in_solid;
  const double facing = nearest.normal.dot(known_side);
  if (facing > 0 || (nearest.distance >= 0 && facing > -LEAST_OPPOSITION)) return nearest;
  if (solid.isConvex()) return {known_side.dot(point) - solid.reachAlong(known_side), known_side};
  const double gap = touch->gap - touch->ignored;
  return gap < 0 ? SolidDistance{gap, known_side} : nearest;
}

bool givesWay(const MovingShape& shape, const Vec3& foot) {
  if (!shape.edge) return false;
  const Vec3 at = shape.in_link * foot;
  return (at - nearestOn(*shape.edge, at)).norm() <= (1 + ROUNDING) * shape.solid->thickness();
}

/// The outward normal of the material of a vertex that lies in a shape which may stand in a slit, or beside it by no
/// more than `aside` [m], in the shape's frame: the vertex is to go the other way. The side tells it on which the
/// vertex was, if it was; else the faces that cuts have made there, or beside it in the same elements; where none runs
/// along the shape, an edge that cuts, as it parts what it passes. Zero where nothing tells; none where a vertex has no
/// side to go to, as at the slit's end.
std::optional<Vec3> materialAt(const ContactSurface& surface, const std::vector<Vec3>& x, int vertex,
                               const MovingShape& shape, const Vec3& point, const SolidDistance& nearest, double aside,
                               const Vec3* known_side) {
  if (known_side) return -*known_side;
  const Vec3 along = shape.from.linear() * nearest.normal;
  std::optional<Vec3> cut = cutNormalAt(surface, x, vertex);
  if (!cut) return std::nullopt;
  if (cut->isZero(0)) cut = cutNormalBeside(surface, x, vertex, along, shape.solid->thickness() + aside);
  if (std::abs(cut->dot(along)) >= LEAST_OPPOSITION) return Vec3(shape.from.linear().transpose() * *cut);
  if (!shape.edge) return Vec3(Vec3::Zero());
  const Vec3 at = shape.in_link * point;
  const Vec3 from_edge = shape.in_link.linear().transpose() * (at - nearestOn(*shape.edge, at));
  return nearest.normal.dot(from_edge) < 0 ? nearest.normal : Vec3(-nearest.normal);
}

/// What keeps a vertex off a shape that may stand in a slit, in the shape's frame, where the vertex is at `point`: the
/// nearest point, unless that is on the far side of its material. A slit need not run just in the middle of the blade
/// that cuts it, so that counts also a little beside the shape; but what would have to cross more than the blade is no
/// face of the slit.
std::optional<SolidDistance> keepOff(const ContactSurface& surface, const std::vector<Vec3>& x, int vertex,
                                     const MovingShape& shape, const Vec3& point, const Touch* touch) {
  const SolidDistance nearest = shape.solid->distanceTo(point);
  const double aside = DEEPEST_BEGIN * surface.size[vertex], width = shape.solid->thickness();
  if (nearest.distance > aside) return nearest;
  if (surface.unshared[vertex] < LEAST_UNSHARED) return std::nullopt;
  if (touch && !shape.solid->isConvex()) return distanceFrom(touch, *shape.solid, point);
  const Vec3* known_side = touch ? &touch->normal_in_solid : nullptr;
  const std::optional<Vec3> n = materialAt(surface, x, vertex, shape, point, nearest, aside, known_side);
  if (!n) return std::nullopt;
  if (n->isZero(0)) return nearest;
  const double facing = -nearest.normal.dot(*n);
  if (facing > (known_side ? 0 : LEAST_OPPOSITION)) return nearest;
  const SolidDistance across = shape.solid->distanceAgainst(point, *n);
  if (!std::isfinite(across.distance)) return nearest;
  if (nearest.distance < 0) return known_side || across.distance > -width - aside ? across : nearest;
  const double off = shape.solid->distanceTo(point - across.distance * across.normal).distance;
  return facing < -LEAST_OPPOSITION && off < ROUNDING * width ? across : nearest;
}

/// The candidate of a vertex against a shape, whose nearest point `nearest` tells, the vertex being at `local` in the
/// shape's frame; none where the two cannot meet in the step.
std::optional<Candidate> candidateAt(const ContactSkin& skin, int vertex, const MovingShape& shape, const Vec3& local,
                                     const SolidDistance& nearest) {
  const ContactSurface& surface = skin.surface();
  const Vec3 foot = local - nearest.distance * nearest.normal;
  if (givesWay(shape, foot)) return std::nullopt;
  Candidate candidate;
  candidate.sample = vertex;
  candidate.normal_in_solid = nearest.normal;
  candidate.normal = shape.to.linear() * nearest.normal;
  candidate.gap = candidate.normal.dot(skin.x()[vertex] - shape.from * foot);
  candidate.drift = shape.to * foot - shape.from * foot;
  const double closing = candidate.normal.dot(skin.ahead()[vertex] - candidate.drift);
  const double size = surface.size[vertex];
  if (!(candidate.gap + closing < MARGIN * size)) return std::nullopt;
  candidate.slip.setZero();
  candidate.size = size;
  candidate.stiffness = OBSTACLE_STIFFNESS * surface.young_modulus[vertex] * surface.area[vertex] / size;
  if (shape.in_slits) candidate.stiffness *= surface.unshared[vertex] * surface.unshared[vertex];
  addVertex(surface.surface->vertices[vertex], 1, &candidate.point);
  return candidate;
}

bool mayMeet(const ContactSkin& skin, int vertex, const MovingShape& shape) {
  const double room = shape.reach + shape.moved + skin.room(vertex);
  return (skin.x()[vertex] - shape.from.translation()).squaredNorm() <= room * room && skin.surface().area[vertex] > 0;
}

/// How deep in its solid the vertex of a candidate comes by this way [m].
double depthBy(const Candidate& candidate, const Vec3& way) {
  return -candidate.gap - candidate.normal.dot(way - candidate.drift);
}

/// Whether one of these vertices that is no candidate ends deeper in a solid than this, in elements.
bool isEntered(const ContactSkin& skin, const StepSpan& span, const SolidsInStep& solids,
               const std::vector<Candidate>& candidates, const std::vector<Vec3>& x, const std::vector<int>& vertices,
               double deep) {
  auto known = candidates.begin();
  for (std::size_t o = 0; o < solids.solids.shapes.size(); ++o) {
    const MovingShape shape = placeShape(solids.solids.shapes[o], solids, span);
    for (const int i : vertices) {
      if ((x[i] - shape.to.translation()).squaredNorm() > shape.reach * shape.reach) continue;
      Candidate at;
      at.sample = i;
      at.partner = static_cast<int>(o);
      while (known != candidates.end() && comesBefore(*known, at)) ++known;
      if (known != candidates.end() && !comesBefore(at, *known)) continue;
      const Vec3 local = shape.to.inverse(Eigen::Isometry) * x[i];
      if (shape.solid->distanceTo(local).distance < -deep * skin.surface().size[i]) return true;
    }
  }
  return false;
}

}  // namespace

void findSolidContacts(const ContactSkin& skin, const StepSpan& span, const SolidsInStep& solids,
                       const std::vector<Touch>& touches, std::vector<Candidate>* candidates) {
  auto touch = touches.begin();
  for (std::size_t o = 0; o < solids.solids.shapes.size(); ++o) {
    const MovingShape shape = placeShape(solids.solids.shapes[o], solids, span);
    if (!skin.mayMeet(shape.from.translation(), shape.reach + shape.moved)) continue;
    for (int i = 0; i < static_cast<int>(skin.x().size()); ++i) {
      if (!mayMeet(skin, i, shape)) continue;
      const Vec3 local = shape.from.inverse(Eigen::Isometry) * skin.x()[i];
      Candidate at;
      at.sample = i;
      at.partner = static_cast<int>(o);
      while (touch != touches.end() && comesBefore(*touch, at)) ++touch;
      const bool touched = touch != touches.end() && !comesBefore(at, *touch);
      if (!touched && shape.solid->isClearOf(local, shape.moved + skin.room(i))) continue;
      const Touch* before = touched ? &*touch : nullptr;
      const std::optional<SolidDistance> nearest = shape.in_slits
                                                       ? keepOff(skin.surface(), skin.x(), i, shape, local, before)
                                                       : distanceFrom(before, *shape.solid, local);
      if (!nearest) continue;
      std::optional<Candidate> candidate = candidateAt(skin, i, shape, local, *nearest);
      if (!candidate) continue;
      candidate->partner = at.partner;
      candidates->push_back(*candidate);
    }
  }
}

bool areSolidsAsReckoned(const ContactSkin& skin, const StepSpan& span, const SolidsInStep& solids,
                         const std::vector<Candidate>& candidates, Span<const Vec3> moved, const std::vector<Vec3>& x) {
  const double share = (span.to - span.from) * DEEPER_IN_SOLID;
  for (int i = 0; i < moved.size(); ++i) {
    const Candidate& candidate = candidates[static_cast<std::size_t>(i)];
    if (candidate.isOfBody()) continue;
    const double allowed = share * candidate.size + std::max(depthBy(candidate, moved[i]), candidate.ignored);
    if (depthBy(candidate, x[candidate.sample] - skin.x()[candidate.sample]) > allowed) return false;
  }
  std::vector<int> astray;  // far from where they were foreseen to go
  for (int i = 0; i < static_cast<int>(x.size()); ++i) {
    const double far = (MARGIN + share) * skin.surface().size[i];
    const bool is_far = (x[i] - skin.x()[i] - skin.ahead()[i]).squaredNorm() > far * far;
    if (is_far && skin.surface().area[i] > 0) astray.push_back(i);
  }
  return astray.empty() || !isEntered(skin, span, solids, candidates, x, astray, share);
}

}  // namespace incision

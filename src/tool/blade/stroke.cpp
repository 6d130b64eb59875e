#include "incision/tool/blade/stroke.h"

#include <algorithm>
#include <cmath>

#include "incision/base/sort_once.h"
#include "incision/cut/cut_here.h"

namespace incision {
namespace {

/// How far an edge goes on that has come out of the body, in elements: as far as a sweep may be from an element that it
/// passes.
constexpr double LEAVING = 0.5;

/// A severed face, not a section through the part.
bool liesInFace(const std::vector<Barycentric>& polygon) {
  for (int I = 0; I < 4; ++I)
    if (std::all_of(polygon.begin(), polygon.end(), [&](const Barycentric& b) { return b[I] == 0; })) return true;
  return false;
}

/// Whether a section of a part, or what it has in common with another on a face of the mesh, lies in a cut that was
/// there before, so that the blade runs in that one.
bool runsInSlit(const CutMesh& mesh, const Materials& materials, int p, const std::vector<Barycentric>& polygon,
                std::optional<int> growing) {
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

}  // namespace

void Stroke::restart() {
  memory_ = Memory();
  forgetLook();
  start_x_.clear();
}

void Stroke::start(const std::vector<Edge>& edges, const std::vector<Vec3>& x) {
  if (!memory_.stands.empty()) return;
  start_edges_ = edges;
  start_x_ = x;
}

void Stroke::stand() {
  if (!memory_.stands.empty()) return;
  for (const Edge& from : start_edges_) memory_.stands.push_back({from, start_x_});
}

Insertion Stroke::sweep(std::size_t edge, const Edge& to, const std::vector<Vec3>& x, const Materials& materials,
                        MeshDoor* door, Ties* ties) {
  const CutMesh& mesh = door->mesh();
  stand();
  Stand& last = memory_.stands[edge];
  for (int c = static_cast<int>(last.x.size()); c < mesh.numCopies(); ++c) last.x.push_back(last.x[mesh.copyParent(c)]);
  if (!record(last, to, x, mesh)) return {};
  last.edge = to;
  last.x = x;
  if (passed_.empty()) return {};
  keepTriangles(mesh);
  ties->sweep(just_swept_, memory_.crack);
  findHeadings(mesh);
  if (crossesItself(to, x, mesh)) {
    memory_.crack.reset();
    memory_.distances.clear();
    memory_.ways.clear();
    findHeadings(mesh);
  }
  measure(to, x, mesh);
  if (!memory_.begun) return {};  // it is only near
  return cut(materials, door, ties);
}

/// The crack keeps the distances that it has.
Insertion Stroke::leave(std::size_t edge, const Edge& way, const std::vector<Vec3>& x, const Materials& materials,
                        MeshDoor* door, Ties* ties) {
  const double moved = std::max(way[0].norm(), way[1].norm());
  if (!memory_.crack || !(moved > 0)) return {};
  const CutMesh& mesh = door->mesh();
  Stand& last = memory_.stands[edge];
  last.x = x;
  const double beyond = LEAVING * materials.meanSize() / moved;
  const Edge to = {last.edge[0] + beyond * way[0], last.edge[1] + beyond * way[1]};
  if (!record(last, to, x, mesh) || passed_.empty()) return {};
  keepTriangles(mesh);
  ties->sweep(just_swept_, memory_.crack);
  return cut(materials, door, ties);
}

/// Cuts what the crack meets and the sweep so far covers.
Insertion Stroke::cut(const Materials& materials, MeshDoor* door, Ties* ties) {
  const CutMesh& mesh = door->mesh();
  CrackField crack = field(mesh);
  crack.contains = [&](int part, const std::vector<Barycentric>& polygon) {
    return covers(mesh.parts()[part], polygon, crack.phi) && !runsInSlit(mesh, materials, part, polygon, memory_.crack);
  };
  const int before = mesh.numCopies();
  known_parts_ = 0;  // until it has been inserted
  const Insertion done = door->insert(crack);
  forgetLook();
  known_parts_ = mesh.parts().size();
  if (!done.changed()) return done;
  memory_.cracks += !memory_.crack;
  memory_.crack = done.crack;
  settle(done, before, mesh);
  ties->add(done, mesh, memory_.swept, progressive_);
  return done;
}

void Stroke::forgetLook() {
  swept_since_.clear();
  measured_since_.clear();
  known_parts_ = 0;
}

/// Elements of the sweep so far, in any order, in which the crack may mean something else than when it was last
/// inserted. A copy that is measured anew can change that in elements that the blade has left behind, and a face is
/// severed by what lies on both sides of it. When something else has split parts, that is all elements.
std::vector<int> Stroke::toLookAt(const CutMesh& mesh) const {
  std::vector<int> elements;
  if (known_parts_ != mesh.parts().size()) {
    for (const auto& [element, unused] : memory_.swept) elements.push_back(element);
    return elements;
  }
  elements = swept_since_;
  for (int c : measured_since_) {
    const Span<const int> star = mesh.topology().star[mesh.copyNode(c)];
    elements.insert(elements.end(), star.begin(), star.end());
  }
  sortOnce(&elements);
  for (std::size_t i = 0, count = elements.size(); i < count; ++i)
    for (int across : mesh.topology().neighbours[elements[i]]) elements.push_back(across);
  sortOnce(&elements);
  const auto unswept = [&](int element) { return memory_.swept.count(element) == 0; };
  elements.erase(std::remove_if(elements.begin(), elements.end(), unswept), elements.end());
  return elements;
}

/// The crack in the elements to look at.
CrackField Stroke::field(const CutMesh& mesh) const {
  CrackField crack;
  crack.crack = memory_.crack;
  crack.phi.assign(mesh.numCopies(), 0);
  for (const auto& [copy, distance] : memory_.distances) crack.phi[copy] = distance.phi;
  for (const int element : toLookAt(mesh))
    for (int p = element; p >= 0; p = mesh.parts()[p].next) {
      const auto& copies = mesh.parts()[p].copies;
      if (std::all_of(copies.begin(), copies.end(), [&](int c) { return memory_.distances.count(c) > 0; }))
        crack.parts.push_back(p);
    }
  std::sort(crack.parts.begin(), crack.parts.end());
  return crack;
}

/// Whether the sweep so far passed enough of a section, or the centroid of a face, seen along the gradient of φ.
bool Stroke::covers(const Part& part, const std::vector<Barycentric>& polygon, const std::vector<double>& phi) const {
  const auto found = memory_.swept.find(part.element);
  if (found == memory_.swept.end()) return false;
  const Vec3 across =
      gradient(Eigen::Vector4d(phi[part.copies[0]], phi[part.copies[1]], phi[part.copies[2]], phi[part.copies[3]]));
  const SweptShadow shadow(found->second.all(), across, polygon);
  if (shadow.isEmpty()) return false;
  if (!progressive_ || liesInFace(polygon)) return shadow.covers(polygonCentroid(polygon));
  const std::vector<Barycentric> points = spread(polygon);
  double left = FIRST_SHARE * static_cast<double>(points.size());
  return std::any_of(points.begin(), points.end(), [&](const Barycentric& point) {
    left -= shadow.covers(point);
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

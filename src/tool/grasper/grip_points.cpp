#include "incision/tool/grasper/grip_points.h"

#include "incision/cut/point.h"
#include "incision/tool/grasper/spread_out.h"
#include "incision/tool/part_frame.h"

namespace incision {
namespace {

/// The mouth as it stands in the body's frame.
struct PlacedMouth {
  PlacedMouth(const Mouth& mouth, const Pose& link) : room(mouth), to_link(inverse(link)) {
    for (const Vec3& point : mouth.points()) points.push_back(placed(point, link));
    for (const Vec3& point : points) box.extend(point);
  }

  const Mouth& room;
  Pose to_link;
  std::vector<Vec3> points;
  Eigen::AlignedBox3d box;  // round them
};

GripPoint heldAt(const Vec3& anchor, const MaterialPoint& held) { return {anchor, held, anchor}; }

/// What the mouth's points meet.
std::vector<GripPoint> met(const PlacedMouth& mouth, const std::vector<Vec3>& x, const CutMesh& mesh) {
  std::vector<std::optional<MaterialPoint>> found;
  findMaterial(mouth.points, x, mesh, &found);
  std::vector<GripPoint> points;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (found[i]) points.push_back(heldAt(mouth.room.points()[i], *found[i]));
  return points;
}

/// Middles of parts between the jaws, of pieces that meet none of these points.
std::vector<GripPoint> ofSmallPieces(const std::vector<GripPoint>& met, const PlacedMouth& mouth,
                                     const std::vector<Vec3>& x, const CutMesh& mesh) {
  int pieces = 0;
  const std::vector<int> piece = mesh.copyPieces(&pieces);
  if (pieces == 1) return {};
  const auto pieceOf = [&](int part) { return static_cast<std::size_t>(piece[mesh.parts()[part].copies[0]]); };
  std::vector<bool> is_met(static_cast<std::size_t>(pieces), false);
  for (const GripPoint& grip : met) is_met[pieceOf(grip.held.part)] = true;
  std::vector<GripPoint> points;
  for (int p = 0; p < static_cast<int>(mesh.parts().size()); ++p) {
    const Part& part = mesh.parts()[p];
    if (is_met[pieceOf(p)] || !boxOf(part, x).intersects(mouth.box)) continue;
    const Barycentric middle = mesh.centroid(p);
    const Vec3 anchor = placed(at(part, middle, x), mouth.to_link);
    if (mouth.room.isBetween(anchor)) points.push_back(heldAt(anchor, {part.element, middle, p}));
  }
  return points;
}

void addSpreadOut(const std::vector<GripPoint>& points, std::size_t most, std::vector<GripPoint>* chosen) {
  std::vector<Vec3> places;
  for (const GripPoint& grip : points) places.push_back(grip.anchor);
  for (const int i : spreadOut(places, most)) chosen->push_back(points[i]);
}

}  // namespace

std::vector<GripPoint> gripPoints(const Mouth& mouth, const Pose& link, const std::vector<Vec3>& x, const CutMesh& mesh,
                                  std::size_t most) {
  const PlacedMouth placed(mouth, link);
  const std::vector<GripPoint> large = met(placed, x, mesh);
  std::vector<GripPoint> chosen;
  addSpreadOut(ofSmallPieces(large, placed, x, mesh), large.empty() ? most : most / 2, &chosen);
  addSpreadOut(large, most - chosen.size(), &chosen);
  return chosen;
}

}  // namespace incision

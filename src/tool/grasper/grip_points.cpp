#include "incision/tool/grasper/grip_points.h"

#include "incision/cut/point.h"
#include "incision/tool/grasper/spread_out.h"
#include "incision/tool/part_frame.h"

namespace incision {
namespace {

/// The mouth as it stands in the body's frame.
struct PlacedMouth {
  PlacedMouth(const Mouth& mouth, const Pose& link) : to_link(inverse(link)) {
    for (const Vec3& point : mouth.points()) points.push_back(composed(link, {point, {}}).position);
    for (const Vec3& point : points) box.extend(point);
  }

  Pose to_link;
  std::vector<Vec3> points;
  Eigen::AlignedBox3d box;  // round them
};

GripPoint heldAt(const CutMesh& mesh, int part, const Barycentric& point, const Vec3& anchor) {
  GripPoint grip;
  grip.element = mesh.parts()[part].element;
  grip.point = point;
  grip.part = part;
  grip.anchor = anchor;
  return grip;
}

/// What the mouth's points meet, and the parts that reach into the mouth, which meet none of them or some.
class Finder {
 public:
  Finder(const Mouth& mouth, const Pose& link, const std::vector<Vec3>& x, const CutMesh& mesh)
      : mouth_(mouth), placed_(mouth, link), x_(x), mesh_(mesh), met_(mouth.points().size(), false) {
    for (std::size_t p = 0; p < mesh.parts().size(); ++p) {
      const Eigen::AlignedBox3d box = boxOf(mesh.parts()[p], x);
      if (box.intersects(placed_.box)) findIn(static_cast<int>(p), box);
    }
    addSmallPieces();
  }

  const std::vector<GripPoint>& found() const { return found_; }

 private:
  /// A point that several parts claim, as where they overlap, is the first one's.
  void findIn(int part, const Eigen::AlignedBox3d& box) {
    near_.push_back(part);
    const PartFrame frame(mesh_.parts()[part], x_);
    if (!frame.invertible()) return;
    for (std::size_t i = 0; i < met_.size(); ++i) {
      if (met_[i] || !box.contains(placed_.points[i])) continue;
      const Barycentric b = frame.toElement(placed_.points[i]);
      if (b.minCoeff() < -OUTSIDE || !encloses(mesh_.polytope(part), b)) continue;
      met_[i] = true;
      found_.push_back(heldAt(mesh_, part, b, mouth_.points()[i]));
    }
  }

  void addSmallPieces() {
    int pieces = 0;
    const std::vector<int> piece_of = mesh_.copyPieces(&pieces);
    const auto pieceOf = [&](int part) { return static_cast<std::size_t>(piece_of[mesh_.parts()[part].copies[0]]); };
    std::vector<bool> is_found(static_cast<std::size_t>(pieces), false);
    for (const GripPoint& grip : found_) is_found[pieceOf(grip.part)] = true;
    for (const int part : near_) {
      if (is_found[pieceOf(part)]) continue;
      const Barycentric middle = mesh_.centroid(part);
      const Vec3 in_link = composed(placed_.to_link, {at(mesh_.parts()[part], middle, x_), {}}).position;
      if (mouth_.isBetween(in_link)) found_.push_back(heldAt(mesh_, part, middle, in_link));
    }
  }

  const Mouth& mouth_;
  PlacedMouth placed_;
  const std::vector<Vec3>& x_;
  const CutMesh& mesh_;
  std::vector<bool> met_;  // of the mouth's points
  std::vector<int> near_;
  std::vector<GripPoint> found_;
};

}  // namespace

std::vector<GripPoint> gripPoints(const Mouth& mouth, const Pose& link, const std::vector<Vec3>& x, const CutMesh& mesh,
                                  std::size_t most) {
  const Finder finder(mouth, link, x, mesh);
  std::vector<Vec3> places;
  for (const GripPoint& grip : finder.found()) places.push_back(grip.anchor);
  std::vector<GripPoint> chosen;
  for (const int i : spreadOut(places, most)) chosen.push_back(finder.found()[i]);
  return chosen;
}

bool findPart(const CutMesh& mesh, GripPoint* grip) {
  for (int p = grip->element; p >= 0; p = mesh.parts()[p].next)
    if (encloses(mesh.polytope(p), grip->point)) {
      grip->part = p;
      return true;
    }
  return false;
}

}  // namespace incision

#include "incision/tool/scissors/scissor_edges.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "incision/base/input_error.h"

namespace incision {
namespace {

/// A blade's box while the joint is at 0, in the frame of the tool's link.
struct BladeBox {
  int group;
  Vec3 middle;
  Mat3 axes;   // columns
  Vec3 half;   // of the lengths along them [m]
  int length;  // the axis of the longest

  Vec3 along() const { return axes.col(length); }
};

/// Each box of a group.
template <class Found>
void forEachBox(const JawLinks& links, int group, const Found& found) {
  for (const DescribedSolid& described : links.solids(group)) {
    const Drawing drawing = described.solid->drawing();
    if (drawing.primitive != Drawing::Primitive::BOX) continue;
    const Pose pose = composed(links.pose(group, 0), described.pose);
    BladeBox box = {group, pose.position, pose.orientation.toRotationMatrix(), drawing.size / 2, 0};
    box.half.maxCoeff(&box.length);
    found(box);
  }
}

/// The first box of a jaw.
std::optional<BladeBox> bladeOfJaw(const JawLinks& links, int group) {
  std::optional<BladeBox> blade;
  forEachBox(links, group, [&](const BladeBox& box) {
    if (!blade) blade = box;
  });
  return blade;
}

/// Where one blade stays with the tool's link, the box of that which is nearest to the other.
std::optional<BladeBox> bladeOfLink(const JawLinks& links, const BladeBox& other) {
  std::optional<BladeBox> blade;
  forEachBox(links, 0, [&](const BladeBox& box) {
    if (!blade || (box.middle - other.middle).norm() < (blade->middle - other.middle).norm()) blade = box;
  });
  return blade;
}

/// The line along the middle of the long face of a box that leads in a direction.
Edge leadingEdge(const BladeBox& box, const Vec3& direction) {
  int face = (box.length + 1) % 3;
  const int other = (box.length + 2) % 3;
  if (std::abs(direction.dot(box.axes.col(other))) > std::abs(direction.dot(box.axes.col(face)))) face = other;
  const double side = std::copysign(box.half[face], direction.dot(box.axes.col(face)));
  const Vec3 middle = box.middle + side * box.axes.col(face), half = box.half[box.length] * box.along();
  return {middle - half, middle + half};
}

/// In the frame of the box's group.
Edge inGroup(const JawLinks& links, int group, const Edge& edge) { return placed(edge, inverse(links.pose(group, 0))); }

}  // namespace

ScissorEdges scissorEdges(const JawLinks& links, const std::string& where) {
  const std::optional<BladeBox> first = bladeOfJaw(links, 1);
  std::optional<BladeBox> second;
  if (first) second = links.groups() > 2 ? bladeOfJaw(links, 2) : bladeOfLink(links, *first);
  if (!second) throw InputError(where + ": scissors need a box as a collision shape of each of two blades");
  const BladeBox* boxes[] = {&*first, &*second};
  std::array<Edge, 2> edges;
  Vec3 across = Vec3::Zero();  // the plane in which they cut
  for (int i = 0; i < 2; ++i) {
    const Vec3& middle = boxes[i]->middle;
    const Vec3 towards = links.velocity(boxes[1 - i]->group, middle) - links.velocity(boxes[i]->group, middle);
    edges[i] = leadingEdge(*boxes[i], towards);
    if (i == 0) across = boxes[i]->along().cross(towards).stableNormalized();
  }
  if (across.isZero(0)) throw InputError(where + ": closing it moves the blades of the scissors along themselves");
  const Vec3 between = across.dot(edges[1][0] - edges[0][0]) / 2 * across;
  ScissorEdges result;
  for (int i = 0; i < 2; ++i) {
    for (Vec3& end : edges[i]) end += i == 0 ? between : Vec3(-between);
    result.edges[i] = {boxes[i]->group, inGroup(links, boxes[i]->group, edges[i])};
    result.thickness[i] = 2 * boxes[i]->half.minCoeff();
  }
  return result;
}

}  // namespace incision

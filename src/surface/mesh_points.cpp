#include "incision/surface/mesh_points.h"

#include <algorithm>
#include <tuple>

#include "incision/base/lists.h"

namespace incision {
namespace {

constexpr std::array<int, 4> NO_NODES = {-1, -1, -1, -1};

int numNodes(const MeshPoint& point) {
  return static_cast<int>(std::find(point.nodes.begin(), point.nodes.end(), -1) - point.nodes.begin());
}

/// Where a corner lies; weights that are there by rounding only are dropped.
MeshPoint locatePoint(const std::array<int, 4>& element, const Barycentric& b) {
  for (int I = 0; I < 4; ++I)
    if (b[I] == 1) return {{element[I], -1, -1, -1}, Barycentric::UnitX()};
  std::array<int, 4> by_node = {0, 1, 2, 3};
  std::sort(by_node.begin(), by_node.end(), [&](int I, int J) { return element[I] < element[J]; });
  MeshPoint point{NO_NODES, Barycentric::Zero()};
  int n = 0;
  for (int I : by_node) {
    if (b[I] < SAME_POINT) continue;
    point.nodes[n] = element[I];
    point.weights[n++] = b[I];
  }
  point.weights /= point.weights.sum();
  return point;
}

/// The weights of a point, with a place for each of the carrier's nodes.
Barycentric weightsOn(const std::array<int, 4>& carrier, const MeshPoint& point) {
  Barycentric b = Barycentric::Zero();
  for (int i = 0, k = 0; i < 4 && k < 4 && point.nodes[k] >= 0; ++i)
    if (carrier[i] == point.nodes[k]) b[i] = point.weights[k++];
  return b;
}

}  // namespace

/// A corner that lies on no node.
struct MeshPoints::Corner {
  MeshPoint point;
  int part;  // −1 unless the corner lies inside the element: only there a point is the part's own
  int index;

  bool sharesCarrier(const Corner& other) const { return point.nodes == other.point.nodes && part == other.part; }
};

MeshPoints::MeshPoints(const CutMesh& mesh, const ExposedPolygons& exposed)
    : num_nodes_(static_cast<int>(mesh.mesh().nodes.size())), carries_(mesh.mesh().nodes.size()) {
  number(locate(mesh, exposed));
}

std::vector<MeshPoints::Corner> MeshPoints::locate(const CutMesh& mesh, const ExposedPolygons& exposed) {
  std::vector<Corner> corners;
  of_corner_.resize(exposed.corners.size());
  for (const auto& polygon : exposed.polygons) {
    const auto& element = mesh.mesh().elements[mesh.parts()[polygon.part].element];
    for (int c = polygon.first; c < polygon.last; ++c) {
      const MeshPoint point = locatePoint(element, exposed.corners[c]);
      if (point.nodes[1] < 0)
        of_corner_[c] = point.nodes[0];
      else
        corners.push_back({point, point.nodes[3] < 0 ? -1 : polygon.part, c});
    }
  }
  return corners;
}

void MeshPoints::number(const std::vector<Corner>& corners) {
  Lists<int> by_carrier;  // for each lowest node
  by_carrier.sort(num_nodes_, [&](const auto& add) {
    for (std::size_t i = 0; i < corners.size(); ++i) add(corners[i].point.nodes[0], static_cast<int>(i));
  });
  for (int node = 0; node < num_nodes_; ++node) {
    const Span<int> of_node = by_carrier[node];
    std::sort(of_node.begin(), of_node.end(), [&](int i, int j) {
      const Corner &a = corners[i], &b = corners[j];
      return std::tie(a.point.nodes, a.part, a.index) < std::tie(b.point.nodes, b.part, b.index);
    });
  }
  const Corner* previous = nullptr;
  for (int i : by_carrier.values()) {
    const Corner& corner = corners[i];
    if (!previous || !corner.sharesCarrier(*previous)) carriers_.push_back({corner.point.nodes, count(), count()});
    previous = &corner;
    Carrier& carrier = carriers_.back();
    int found = carrier.first;
    while (found < carrier.last &&
           (points_[found - num_nodes_].weights - corner.point.weights).cwiseAbs().maxCoeff() > SAME_POINT)
      ++found;
    if (found == carrier.last) {
      points_.push_back(corner.point);
      ++carrier.last;
    }
    of_corner_[corner.index] = found;
  }
  for (const Carrier& carrier : carriers_)
    for (int node : carrier.nodes)
      if (node >= 0) carries_[node] = true;
}

MeshPoint MeshPoints::place(int point) const {
  if (!isNode(point)) return points_[point - num_nodes_];
  return {{point, -1, -1, -1}, Barycentric::UnitX()};
}

void MeshPoints::appendBetween(int from, int to, std::vector<int>* loop) {
  if (isNode(from) && isNode(to) && !(carries_[from] && carries_[to])) return;
  const Carrier* carrier = commonCarrier(from, to);
  if (!carrier) return;
  const Barycentric a = weightsOn(carrier->nodes, place(from)), b = weightsOn(carrier->nodes, place(to));
  const Barycentric along = (b - a) / (b - a).squaredNorm();
  between_.clear();
  for (int point = carrier->first; point < carrier->last; ++point) {
    if (point == from || point == to) continue;
    const Barycentric offset = weightsOn(carrier->nodes, place(point)) - a;
    const double t = along.dot(offset);
    // Each of the three points may be SAME_POINT away from where its corner was.
    if (t > 0 && t < 1 && (offset - t * (b - a)).cwiseAbs().maxCoeff() < 4 * SAME_POINT)
      between_.emplace_back(t, point);
  }
  std::sort(between_.begin(), between_.end());
  for (const auto& [t, point] : between_) loop->push_back(point);
}

/// The edge or face on which both points lie, if it has points of its own.
const MeshPoints::Carrier* MeshPoints::commonCarrier(int from, int to) const {
  const MeshPoint a = place(from), b = place(to);
  const int na = numNodes(a), nb = numNodes(b);
  std::array<int, 8> both;
  const auto end =
      std::set_union(a.nodes.begin(), a.nodes.begin() + na, b.nodes.begin(), b.nodes.begin() + nb, both.begin());
  if (end - both.begin() > 3) return nullptr;
  std::array<int, 4> nodes = NO_NODES;
  std::copy(both.begin(), end, nodes.begin());
  const auto carrier = std::lower_bound(carriers_.begin(), carriers_.end(), nodes,
                                        [](const Carrier& c, const std::array<int, 4>& key) { return c.nodes < key; });
  return carrier != carriers_.end() && carrier->nodes == nodes ? &*carrier : nullptr;
}

}  // namespace incision

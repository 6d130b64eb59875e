#include "incision/ros/markers.h"

#include <cstdio>
#include <utility>

#include "capsule_points.h"
#include "incision/ros/conversions.h"
#include "plain_marker.h"

namespace incision {
namespace {

using visualization_msgs::Marker;

/// Of a plane as it is drawn [m]: as wide as a hall, and thin.
constexpr double GROUND_WIDTH = 100, GROUND_HEIGHT = 0.001;

/// Of the tool's edge as it is drawn, in sizes of the body.
constexpr double EDGE_WIDTH = 0.005;

/// Of the arrow of a force, in sizes of the body: the diameters of its shaft and its head, and the head's length.
const Vec3 ARROW_SIZE(0.012, 0.024, 0.04);

/// Of the letters that tell a force, in sizes of the body: how high they are, and how far beyond the arrow's head.
constexpr double LETTERS = 0.04, BEYOND = 0.04;

/// Of a mesh in a file only the file is told: rviz reads it once, however often the marker comes.
int typeOf(const Drawing& drawing) {
  switch (drawing.primitive) {
    case Drawing::Primitive::SPHERE:
      return Marker::SPHERE;
    case Drawing::Primitive::CYLINDER:
      return Marker::CYLINDER;
    case Drawing::Primitive::CAPSULE:
      return Marker::TRIANGLE_LIST;
    case Drawing::Primitive::MESH:
      return drawing.file.empty() ? Marker::TRIANGLE_LIST : Marker::MESH_RESOURCE;
    default:
      return Marker::CUBE;
  }
}

std::vector<geometry_msgs::Point> cornersOf(const TriangleMesh& mesh) {
  std::vector<geometry_msgs::Point> corners;
  for (const std::array<int, 3>& triangle : mesh.triangles)
    for (const int v : triangle) corners.push_back(toPoint(mesh.vertices[v]));
  return corners;
}

/// A solid that stands at `pose` in the marker's frame.
Marker markerOf(const Solid& solid, const Pose& pose, const std::string& what, int id,
                const std_msgs::ColorRGBA& colour, const std::string& frame, const ros::Time& stamp) {
  const Drawing drawing = solid.drawing();
  Marker marker = plainMarker(typeOf(drawing), what, id, colour, frame, stamp);
  marker.pose = toPoseMessage(pose);
  marker.scale = toVector3(drawing.size);
  marker.mesh_resource = drawing.file;
  if (drawing.mesh) marker.points = cornersOf(*drawing.mesh);
  if (drawing.primitive == Drawing::Primitive::CAPSULE) {
    marker.points = capsulePoints(drawing.size);
    marker.scale = toVector3(Vec3::Ones());
  }
  if (drawing.primitive != Drawing::Primitive::HALF_SPACE) return marker;
  Pose below;
  below.position.z() = -GROUND_HEIGHT / 2;
  marker.pose = toPoseMessage(composed(pose, below));
  marker.scale = toVector3({GROUND_WIDTH, GROUND_WIDTH, GROUND_HEIGHT});
  return marker;
}

}  // namespace

visualization_msgs::MarkerArray toMarkers(const Obstacles& obstacles, const std::vector<Pose>& links,
                                          const std::string& frame, const ros::Time& stamp) {
  visualization_msgs::MarkerArray array;
  for (const Obstacle& obstacle : obstacles.shapes) {
    const bool is_ground = obstacle.link == GROUND_LINK;
    const auto link = static_cast<std::size_t>(obstacle.link);
    const Pose pose = is_ground ? obstacle.pose : composed(links[link], obstacle.pose);
    const int id = static_cast<int>(array.markers.size());
    array.markers.push_back(markerOf(*obstacle.solid, pose, is_ground ? "ground" : obstacles.links[link].name, id,
                                     colour(0.62F, 0.66F, 0.70F), frame, stamp));
  }
  return array;
}

namespace {

std::string inNewton(double force) {
  char words[32];
  std::snprintf(words, sizeof words, force < 100 ? "%.2g N" : "%.0f N", force);
  return words;
}

/// The force on a tool whose link stands at `link`, as an arrow, and beside its head how much it is.
void addForce(const ToolView& view, const Pose& link, const ToolScale& scale, const std::string& frame,
              const ros::Time& stamp, std::vector<Marker>* markers) {
  const std_msgs::ColorRGBA orange = colour(0.95F, 0.65F, 0.10F), black = colour(0.10F, 0.10F, 0.12F);
  const Vec3 head = link.position + scale.force * (link.orientation * view.force);
  Marker arrow = plainMarker(Marker::ARROW, view.name + "/force", 0, orange, frame, stamp);
  arrow.scale = toVector3(scale.size * ARROW_SIZE);
  arrow.points = {toPoint(link.position), toPoint(head)};
  Marker letters = plainMarker(Marker::TEXT_VIEW_FACING, view.name + "/force in N", 0, black, frame, stamp);
  letters.scale.z = LETTERS * scale.size;
  const Vec3 way = link.orientation * view.force.stableNormalized();
  letters.pose.position = toPoint(head + BEYOND * scale.size * way);
  letters.text = inNewton(view.force.norm());
  for (Marker* marker : {&arrow, &letters}) {
    if (view.force.isZero()) marker->action = Marker::DELETE;
    markers->push_back(std::move(*marker));
  }
}

/// Adds what there is of a tool to see; one that is not in place is taken away.
void addTool(const ToolForm& form, const ToolView& view, const ToolScale& scale, const std::string& frame,
             const ros::Time& stamp, std::vector<Marker>* markers) {
  const std::size_t first = markers->size();
  const std::vector<Pose>& groups = view.groups;
  const auto groupOf = [&](int group) { return groups.empty() ? Pose() : groups[static_cast<std::size_t>(group)]; };
  addForce(view, groupOf(0), scale, frame, stamp, markers);
  int id = 0;
  for (const ToolForm::GroupEdge& edge : form.edges) {
    markers->push_back(
        plainMarker(Marker::LINE_LIST, view.name + "/edge", id++, colour(0.10F, 0.10F, 0.12F), frame, stamp));
    markers->back().scale.x = EDGE_WIDTH * scale.size;
    for (const Vec3& end : placed(edge.edge, groupOf(edge.group))) markers->back().points.push_back(toPoint(end));
  }
  id = 0;
  for (const Obstacle& shape : form.shapes.shapes)
    markers->push_back(markerOf(*shape.solid, composed(groupOf(shape.link), shape.pose), view.name + "/shape", id++,
                                colour(0.75F, 0.77F, 0.80F), frame, stamp));
  if (!groups.empty()) return;
  for (std::size_t i = first; i < markers->size(); ++i) (*markers)[i].action = Marker::DELETE;
}

}  // namespace

visualization_msgs::MarkerArray toMarkers(const std::vector<ToolForm>& forms, const std::vector<ToolView>& views,
                                          const ToolScale& scale, const std::string& frame, const ros::Time& stamp) {
  visualization_msgs::MarkerArray array;
  for (std::size_t i = 0; i < forms.size(); ++i) addTool(forms[i], views[i], scale, frame, stamp, &array.markers);
  return array;
}

}  // namespace incision

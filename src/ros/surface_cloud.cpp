#include "incision/ros/surface_cloud.h"

#include <cstdint>
#include <cstring>

#include "incision/surface/vertex_fields.h"

namespace incision {
namespace {

/// A point as it lies in the message.
struct Point {
  float position[3], normal[3], von_mises;
  std::uint16_t region;
  std::uint8_t cut, unused;
};
static_assert(sizeof(Point) == 32);

sensor_msgs::PointField field(const char* name, std::size_t offset, std::uint8_t type) {
  sensor_msgs::PointField field;
  field.name = name;
  field.offset = static_cast<std::uint32_t>(offset);
  field.datatype = type;
  field.count = 1;
  return field;
}

std::vector<sensor_msgs::PointField> vertexFields() {
  using Field = sensor_msgs::PointField;
  std::vector<Field> all;
  std::size_t offset = 0;
  for (const char* name : {"x", "y", "z", "normal_x", "normal_y", "normal_z", "von_mises"}) {
    all.push_back(field(name, offset, Field::FLOAT32));
    offset += sizeof(float);
  }
  all.push_back(field("region", offsetof(Point, region), Field::UINT16));
  all.push_back(field("cut", offsetof(Point, cut), Field::UINT8));
  return all;
}

std::vector<Point> pointsOf(const Surface& surface, const std::vector<Vec3>& x, const std::vector<int>& regions,
                            const std::vector<double>& von_mises) {
  const std::vector<Vec3> normals = vertexNormals(surface, x);
  const std::vector<double> stress = vertexMeans(surface, x, von_mises);
  std::vector<Point> points(x.size());
  for (std::size_t v = 0; v < x.size(); ++v) {
    for (int i = 0; i < 3; ++i) {
      points[v].position[i] = static_cast<float>(x[v][i]);
      points[v].normal[i] = static_cast<float>(normals[v][i]);
    }
    points[v].von_mises = static_cast<float>(stress[v]);
    points[v].region = 0;
    points[v].cut = points[v].unused = 0;
  }
  for (std::size_t t = surface.triangles.size(); t-- > 0;)  // the first triangle at a vertex has the last word
    for (int v : surface.triangles[t]) {
      points[v].region = static_cast<std::uint16_t>(regions[t]);
      if (surface.cut_face[t]) points[v].cut = 1;
    }
  return points;
}

}  // namespace

sensor_msgs::PointCloud2 toCloud(const Surface& surface, const std::vector<Vec3>& x, const std::vector<int>& regions,
                                 const std::vector<double>& von_mises, const std::string& frame,
                                 const ros::Time& stamp) {
  const std::vector<Point> points = pointsOf(surface, x, regions, von_mises);
  sensor_msgs::PointCloud2 cloud;
  cloud.header.frame_id = frame;
  cloud.header.stamp = stamp;
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(points.size());
  cloud.fields = vertexFields();
  cloud.point_step = sizeof(Point);
  cloud.row_step = cloud.point_step * cloud.width;
  cloud.is_dense = true;
  cloud.data.resize(cloud.row_step);
  if (!points.empty()) std::memcpy(cloud.data.data(), points.data(), cloud.data.size());
  return cloud;
}

}  // namespace incision

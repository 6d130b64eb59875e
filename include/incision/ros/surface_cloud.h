#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <string>
#include <vector>

#include "incision/surface/surface.h"

namespace incision {

/// The surface's vertices as a cloud of points: x, y, z [m], their normals, `region`, `cut` (1 where a face is one that
/// a crack made) and `von_mises` [Pa]. `x`: positions of the vertices [m]; `regions` and `von_mises`: of every
/// triangle.
sensor_msgs::PointCloud2 toCloud(const Surface& surface, const std::vector<Vec3>& x, const std::vector<int>& regions,
                                 const std::vector<double>& von_mises, const std::string& frame,
                                 const ros::Time& stamp);

}  // namespace incision

#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "incision/surface/rounding.h"
#include "incision/surface/surface.h"

namespace incision {

/// What the colours of a body's markers tell.
enum class MarkerField { NONE, REGION, STRESS };

/// What is drawn of a body.
struct BodyView {
  const Surface* surface;
  std::vector<Vec3> x;  ///< of the surface's vertices [m]
  /// With it each triangle is drawn as four, with a point on each of its sides.
  const Rounding* rounding = nullptr;
  MarkerField field = MarkerField::NONE;
  int num_regions = 1;
  std::vector<int> regions;                  ///< of every triangle, where the field is REGION
  std::vector<double> von_mises;             ///< of every triangle [Pa], where it is STRESS
  std::vector<Vec3> held;                    ///< where what clamps hold is [m]
  std::vector<std::pair<Vec3, Vec3>> loads;  ///< where loads act [m], and their forces [N]
  double element_size = 1;                   ///< the mean [m]
};

/// Of a surface of more triangles than this nobody sees the facets, and four for each would be some MB a message.
inline constexpr std::size_t ROUNDED_UP_TO = 10'000;

/// The surface as lists of triangles, the skin and the cut faces, of the same points as long as the topology does not
/// change; with the regions as colours, such a pair for each of them. Only stress has a colour for each point: rviz
/// does not light those. All fields' lists are in each message, those of another field to be deleted. What clamps hold
/// are spheres, forces of loads are lines that end where they act. A marker with nothing in it is deleted.
visualization_msgs::MarkerArray toMarkers(const BodyView& view, const std::string& frame, const ros::Time& stamp);

}  // namespace incision

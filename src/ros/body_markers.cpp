#include "incision/ros/body_markers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "incision/ros/conversions.h"
#include "plain_marker.h"

namespace incision {
namespace {

using visualization_msgs::Marker;

/// Of what is held and of loads as they are drawn, in elements: the diameter of spheres, the width of lines and the
/// length of that of the largest force.
constexpr double SPHERE = 0.3, WIDTH = 0.06, LONGEST = 2;

/// The colours of stress go up to what this share of the triangles does not pass: the peaks at clamps and crack tips
/// grow with the mesh, and would leave everything else in one colour.
constexpr double SHOWN_SHARE = 0.98;

/// A hue for each region, apart from those beside it in the list; the body's own is that of plain markers.
std_msgs::ColorRGBA colourOf(int region, bool is_cut) {
  static const std::array<std_msgs::ColorRGBA, 6> SKIN = {colour(0.78F, 0.35F, 0.32F), colour(0.90F, 0.78F, 0.36F),
                                                          colour(0.36F, 0.60F, 0.80F), colour(0.45F, 0.70F, 0.40F),
                                                          colour(0.60F, 0.42F, 0.70F), colour(0.60F, 0.60F, 0.62F)};
  std_msgs::ColorRGBA c = SKIN[static_cast<std::size_t>(region) % SKIN.size()];
  if (!is_cut) return c;
  for (float* value : {&c.r, &c.g, &c.b}) *value += 0.5F * (1 - *value);  // lighter
  return c;
}

/// From blue by white to red.
std_msgs::ColorRGBA colourOf(double share) {
  const auto s = static_cast<float>(std::clamp(share, 0.0, 1.0));
  return s < 0.5F ? colour(0.2F + 1.5F * s, 0.35F + 1.2F * s, 0.75F + 0.4F * s)
                  : colour(0.95F, 0.95F - 1.5F * (s - 0.5F), 0.95F - 1.6F * (s - 0.5F));
}

double shownStress(std::vector<double> stress) {
  if (stress.empty()) return 1;
  const auto at = stress.begin() + static_cast<std::ptrdiff_t>(SHOWN_SHARE * static_cast<double>(stress.size() - 1));
  std::nth_element(stress.begin(), at, stress.end());
  return *at > 0 ? *at : 1;
}

/// The lists of triangles, empty: the skin and the cut faces of each region, of which the first are those of the whole
/// body where regions are not told apart, and those with a colour for each point. rviz updates a list in place, and one
/// that began without such colours never gets them: a list of its own does.
std::vector<Marker> lists(const BodyView& view, const std::string& frame, const ros::Time& stamp) {
  std::vector<Marker> markers;
  for (int pair = 0; pair <= view.num_regions; ++pair)
    for (const bool is_cut : {false, true}) {
      std_msgs::ColorRGBA c = is_cut ? colour(1.0F, 0.72F, 0.66F) : colour(0.78F, 0.35F, 0.32F);
      if (view.field == MarkerField::REGION) c = colourOf(pair, is_cut);
      markers.push_back(plainMarker(Marker::TRIANGLE_LIST, is_cut ? "cut faces" : "skin",
                                    static_cast<int>(markers.size()), c, frame, stamp));
    }
  return markers;
}

/// Which pair of lists a triangle is in.
int pairOf(const BodyView& view, std::size_t triangle) {
  if (view.field == MarkerField::STRESS) return view.num_regions;
  return view.field == MarkerField::REGION ? view.regions[triangle] : 0;
}

/// Points of the triangles that are drawn for one of the surface, three for each.
class Corners {
 public:
  explicit Corners(const BodyView& view) : view_(view) {
    if (view.rounding) middles_ = view.rounding->middles(*view.surface, view.x);
  }

  std::size_t perTriangle() const { return view_.rounding ? 12 : 3; }

  template <class Add>
  void forEach(std::size_t triangle, const Add& add) const {
    const auto [a, b, c] = view_.surface->triangles[triangle];
    const auto at = [this](int vertex) -> const Vec3& { return view_.x[static_cast<std::size_t>(vertex)]; };
    if (!view_.rounding) {
      for (const int vertex : {a, b, c}) add(at(vertex));
      return;
    }
    const auto [ab, bc, ca] = view_.rounding->sides()[triangle];
    const auto on = [this](int side) -> const Vec3& { return middles_[static_cast<std::size_t>(side)]; };
    for (const Vec3* corner :
         {&at(a), &on(ab), &on(ca), &on(ab), &at(b), &on(bc), &on(ca), &on(bc), &at(c), &on(ab), &on(bc), &on(ca)})
      add(*corner);
  }

 private:
  const BodyView& view_;
  std::vector<Vec3> middles_;
};

void addTriangles(const BodyView& view, std::vector<Marker>* markers) {
  const double shown = view.field == MarkerField::STRESS ? shownStress(view.von_mises) : 1;
  const Corners corners(view);
  for (std::size_t t = 0; t < view.surface->triangles.size(); ++t) {
    Marker& marker = (*markers)[static_cast<std::size_t>(2 * pairOf(view, t) + (view.surface->cut_face[t] ? 1 : 0))];
    corners.forEach(t, [&](const Vec3& corner) { marker.points.push_back(toPoint(corner)); });
    if (view.field == MarkerField::STRESS)
      marker.colors.insert(marker.colors.end(), corners.perTriangle(), colourOf(view.von_mises[t] / shown));
  }
}

Marker spheres(const BodyView& view, const std::string& frame, const ros::Time& stamp) {
  Marker marker = plainMarker(Marker::SPHERE_LIST, "clamps", 0, colour(0.25F, 0.27F, 0.30F), frame, stamp);
  marker.scale = toVector3(SPHERE * view.element_size * Vec3::Ones());
  for (const Vec3& x : view.held) marker.points.push_back(toPoint(x));
  return marker;
}

Marker lines(const BodyView& view, const std::string& frame, const ros::Time& stamp) {
  Marker marker = plainMarker(Marker::LINE_LIST, "loads", 0, colour(0.15F, 0.55F, 0.25F), frame, stamp);
  marker.scale.x = WIDTH * view.element_size;
  double largest = 0;
  for (const auto& [x, force] : view.loads) largest = std::max(largest, force.norm());
  for (const auto& [x, force] : view.loads) {
    marker.points.push_back(toPoint(x - LONGEST * view.element_size / largest * force));
    marker.points.push_back(toPoint(x));
  }
  return marker;
}

}  // namespace

visualization_msgs::MarkerArray toMarkers(const BodyView& view, const std::string& frame, const ros::Time& stamp) {
  visualization_msgs::MarkerArray array;
  array.markers = lists(view, frame, stamp);
  addTriangles(view, &array.markers);
  array.markers.push_back(spheres(view, frame, stamp));
  array.markers.push_back(lines(view, frame, stamp));
  // rviz calls a list without points an error.
  for (Marker& marker : array.markers) marker.action = marker.points.empty() ? Marker::DELETE : Marker::ADD;
  return array;
}

}  // namespace incision

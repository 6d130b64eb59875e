#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "incision/body/deformable_body.h"
#include "incision/body/stress_view.h"
#include "incision/ros/body_markers.h"
#include "incision/ros/contacts_message.h"
#include "incision/ros/force_scale.h"
#include "incision/ros/markers.h"

namespace incision {

/// What is displayed of a body that stays as long as its topology does.
struct DisplayTopology {
  explicit DisplayTopology(const DeformableBody& body);
  const Surface surface;
  const std::vector<int> held;  // copies
  std::vector<int> regions;     // of each triangle
  std::vector<Vec3> rest;       // where the vertices are then [m]; none of a surface that is not rounded
  /// A copy of the mesh, made only for those who want stress: it is the largest thing here.
  std::shared_ptr<const CutMesh> mesh;
};

/// Which of it somebody listens to.
struct DisplayWishes {
  bool markers = false, cloud = false, contacts = false, obstacles = false, tools = false;
  bool region_stress = false;
  MarkerField field = MarkerField::NONE;  ///< of the markers

  bool stress() const { return region_stress || cloud || (markers && field == MarkerField::STRESS); }
};

/// What is displayed of a body after a step: what somebody listens to, and nothing else.
struct DisplaySnapshot {
  DisplayWishes wishes;
  std::shared_ptr<DisplayTopology> topology;
  std::vector<Vec3> positions, loads;
  std::optional<BodyWrenches> wrenches;
  std::int64_t step = 0;  ///< after which it is
  std::optional<std::vector<Pose>> links;
  std::optional<std::vector<ToolView>> tools;

  bool empty() const { return !topology && !wrenches && !links && !tools; }
};

/// Takes snapshots, on the thread that has the body, of which it copies no more than it must.
class DisplaySource {
 public:
  /// With the obstacles' `links`, and what the last step has told. Where it throws std::bad_alloc, the next one is as
  /// if this one had not been tried.
  DisplaySnapshot take(const DeformableBody& body, const std::vector<Pose>& links, const StepResult& last_step,
                       const DisplayWishes& wishes);

 private:
  void addBody(const DeformableBody& body, DisplaySnapshot* snapshot);

  std::shared_ptr<DisplayTopology> topology_;
  std::uint64_t topology_version_ = 0;
};

/// Messages of a snapshot.
struct DisplayMessages {
  std::optional<visualization_msgs::MarkerArray> body, obstacles, tools;
  std::optional<sensor_msgs::PointCloud2> cloud;
  std::optional<Contacts> contacts;
  std::optional<std::vector<RegionStress>> region_stress;
};

/// Makes them, on any one thread.
class DisplayBuilder {
 public:
  explicit DisplayBuilder(const DeformableBody& body);

  bool hasObstacles() const { return !obstacles_.shapes.empty(); }
  bool hasTools() const { return !tool_forms_.empty(); }

  /// All of a snapshot. Where it throws std::bad_alloc, the next one is as whole as if this one had not been tried.
  DisplayMessages build(const DisplaySnapshot& snapshot, const ros::Time& stamp);

 private:
  const Rounding* roundingOf(const std::shared_ptr<DisplayTopology>& topology);
  std::vector<double> findStress(const DisplaySnapshot& snapshot);
  void addBody(const DisplaySnapshot& snapshot, const ros::Time& stamp, DisplayMessages* messages);
  BodyView viewOf(const DisplaySnapshot& snapshot) const;
  Contacts contactsOf(const DisplaySnapshot& snapshot, const ros::Time& stamp) const;
  visualization_msgs::MarkerArray toolsOf(const DisplaySnapshot& snapshot, const ros::Time& stamp);

  const BodySettings body_settings_;
  const std::string& frame_ = body_settings_.frame;
  const Materials materials_;
  const Obstacles obstacles_;
  const ContactNames contact_names_;
  const double body_size_, time_step_;  // [m], [s]
  std::vector<ToolForm> tool_forms_;
  std::unique_ptr<StressView> stress_;
  std::shared_ptr<DisplayTopology> rounded_;  // of which is
  std::unique_ptr<Rounding> rounding_;
  ForceScale force_scale_;
};

}  // namespace incision

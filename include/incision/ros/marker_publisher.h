#pragma once

#include <ros/node_handle.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "incision/body/deformable_body.h"
#include "incision/body/stress_view.h"
#include "incision/pace/wakeup.h"
#include "incision/ros/body_markers.h"
#include "incision/ros/contacts_message.h"
#include "incision/ros/force_scale.h"
#include "incision/ros/markers.h"
#include "incision/ros/parameters.h"

namespace incision {

/// Publishes at a given rate what others look at, to subscribers only: the body's surface as markers and as a cloud of
/// points, its contacts, the obstacles and the tools. The stepping thread only copies; messages are built and sent on a
/// thread of its own, which skips what it is too slow for.
class MarkerPublisher {
 public:
  MarkerPublisher(ros::NodeHandle& node, const NodeSettings& settings, const DeformableBody& body);
  ~MarkerPublisher();

  /// Hands over the body's surface, where the obstacles' `links` and the tools are, and what the last step has told,
  /// when it is time and somebody listens. With `wants_stress` also what it takes to find the stress of regions.
  void offer(const DeformableBody& body, const std::vector<Pose>& links, const StepResult& last_step, bool wants_stress,
             SteadyTime now);
  /// From the next offer on. Nothing is advertised before the rate is first above 0.
  void set(const MarkerSettings& settings);
  /// When to offer again.
  SteadyTime nextOffer() const { return next_; }

  /// Whether somebody listens to contacts, for which the body must want wrenches.
  bool wantsContacts() const { return next_ != SteadyTime::max() && contact_publisher_.getNumSubscribers() > 0; }

  /// Of each region, as it was found last; none before.
  std::vector<RegionStress> regionStress() const;

 private:
  /// What stays as long as the topology does.
  struct Topology {
    explicit Topology(const DeformableBody& body);
    const Surface surface;
    const std::vector<int> held;  // copies
    std::vector<int> regions;     // of each triangle
    std::vector<Vec3> rest;       // where the vertices are then [m]; none of a surface that is not rounded
    /// A copy of the mesh, made only for those who want stress: it is the largest thing here.
    std::shared_ptr<const CutMesh> mesh;
  };
  /// What somebody listens to, and nothing else.
  struct Snapshot {
    std::shared_ptr<Topology> topology;
    std::vector<Vec3> positions, loads;
    bool wants_markers = false, wants_cloud = false, wants_stress = false;
    MarkerField field = MarkerField::NONE;
    std::optional<BodyWrenches> wrenches;
    std::int64_t step = 0;  ///< after which it is
    std::optional<std::vector<Pose>> links;
    std::optional<std::vector<ToolView>> tools;

    bool needsStress() const { return wants_stress || wants_cloud || (wants_markers && field == MarkerField::STRESS); }
    bool empty() const { return !topology && !wrenches && !links && !tools; }
  };
  void start();
  void addBody(const DeformableBody& body, Snapshot* snapshot);
  std::vector<ToolView> toolViews(const DeformableBody& body, const StepResult& last_step) const;
  void publish(const Snapshot& snapshot);
  const Rounding* roundingOf(const std::shared_ptr<Topology>& topology);
  std::vector<double> findStress(const Snapshot& snapshot);
  void publishContacts(const Snapshot& snapshot, const ros::Time& stamp);
  void publishTools(const Snapshot& snapshot, const ros::Time& stamp);
  void publishBody(const Snapshot& snapshot, const ros::Time& stamp);
  void run();
  std::optional<Snapshot> take();

  const BodySettings body_settings_;
  const std::string& frame_ = body_settings_.frame;
  const Materials materials_;
  const Obstacles obstacles_;
  const ContactNames contact_names_;
  const double body_size_, time_step_;  // [m], [s]
  std::vector<ToolForm> tool_forms_;
  ros::NodeHandle node_;
  MarkerField field_ = MarkerField::NONE;
  std::chrono::nanoseconds period_{};
  ros::Publisher body_publisher_, cloud_publisher_, contact_publisher_, obstacle_publisher_, tool_publisher_;
  SteadyTime next_ = SteadyTime::max();
  std::shared_ptr<Topology> topology_;
  std::uint64_t topology_version_ = 0;

  mutable std::mutex mutex_;
  std::optional<Snapshot> latest_;
  std::vector<RegionStress> region_stress_;
  std::unique_ptr<StressView> stress_;  // this and all to the force's scale are the thread's own
  std::shared_ptr<Topology> rounded_;   // of which is
  std::unique_ptr<Rounding> rounding_;
  ForceScale force_scale_;
  std::atomic<bool> stopping_ = false;
  Wakeup wakeup_;
  std::thread thread_;
};

}  // namespace incision

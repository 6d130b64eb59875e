#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "incision/body/deformable_body.h"
#include "incision/pace/wakeup.h"
#include "incision/ros/markers.h"
#include "incision/ros/parameters.h"

namespace incision {

/// Publishes the body's surface, the obstacles and the tools at a given rate, to subscribers only. The stepping thread
/// only copies positions; messages are built and sent on a thread of its own, which skips what it is too slow for.
class MarkerPublisher {
 public:
  MarkerPublisher(ros::NodeHandle& node, const NodeSettings& settings, const DeformableBody& body);
  ~MarkerPublisher();

  /// Hands over the body's surface, where the obstacles' `links` and the tools are, and the forces on the tools in the
  /// last step, when it is time and somebody listens.
  void offer(const DeformableBody& body, const std::vector<Pose>& links, const StepResult& last_step, SteadyTime now);
  /// When to offer again.
  SteadyTime nextOffer() const { return next_; }

 private:
  /// Of a tool.
  struct ToolOutput {
    Obstacles shapes;
    Edge edge;
    ros::Publisher publisher;
  };
  /// What somebody listens to, and nothing else.
  struct Snapshot {
    std::shared_ptr<const Surface> surface;
    std::vector<Vec3> positions;
    std::optional<std::vector<Pose>> links;
    std::vector<std::pair<std::size_t, ToolView>> tools;  ///< by index

    bool empty() const { return !surface && !links && tools.empty(); }
  };
  void addSurface(const DeformableBody& body, Snapshot* snapshot);
  void publish(const Snapshot& snapshot) const;
  void run();
  std::optional<Snapshot> take();

  const std::string frame_;
  const Obstacles obstacles_;
  std::chrono::nanoseconds period_;
  ros::Publisher body_publisher_, obstacle_publisher_;
  std::vector<ToolOutput> tools_;
  SteadyTime next_;
  std::shared_ptr<const Surface> surface_;
  std::uint64_t topology_version_ = 0;

  std::mutex mutex_;
  std::optional<Snapshot> latest_;
  std::atomic<bool> stopping_ = false;
  Wakeup wakeup_;
  std::thread thread_;
};

}  // namespace incision

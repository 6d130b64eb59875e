#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <optional>
#include <thread>

#include "incision/body/deformable_body.h"
#include "incision/pace/wakeup.h"
#include "incision/ros/markers.h"

namespace incision {

/// Publishes the body's surface, the obstacles and the tool at a given rate, to subscribers only. The stepping thread
/// only copies positions; messages are built and sent on a thread of its own, which skips what it is too slow for.
class MarkerPublisher {
 public:
  /// `rate` [Hz]; 0: never. `edge`: of the tool, where there is one.
  MarkerPublisher(ros::NodeHandle& node, const std::string& frame, double rate, const Obstacles& obstacles,
                  const std::optional<Edge>& edge);
  ~MarkerPublisher();

  /// Hands over the body's surface, and where the obstacles' links and the tool are, when it is time and somebody
  /// listens. `force`: on the tool, as in ToolView.
  void offer(const DeformableBody& body, const std::vector<Pose>& links, const Vec3& force, SteadyTime now);
  /// When to offer again.
  SteadyTime nextOffer() const { return next_; }

 private:
  struct Snapshot {
    std::shared_ptr<const Surface> surface;  ///< none where nobody listens
    std::vector<Vec3> positions;
    std::optional<std::vector<Pose>> links;  ///< the same
    std::optional<ToolView> tool;            ///< the same
  };
  void addSurface(const DeformableBody& body, Snapshot* snapshot);
  void publish(const Snapshot& snapshot) const;
  void run();
  std::optional<Snapshot> take();

  const std::string frame_;
  const Obstacles obstacles_;
  const std::optional<Edge> edge_;
  std::chrono::nanoseconds period_;
  ros::Publisher body_publisher_, obstacle_publisher_, tool_publisher_;
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

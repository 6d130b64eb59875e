#pragma once

#include <ros/node_handle.h>

#include <atomic>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "incision/pace/wakeup.h"
#include "incision/ros/display.h"
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
  void start();
  DisplayWishes wishes() const;
  void publish(const DisplaySnapshot& snapshot);
  void run();
  std::optional<DisplaySnapshot> take();

  ros::NodeHandle node_;
  MarkerField field_ = MarkerField::NONE;
  std::chrono::nanoseconds period_{};
  ros::Publisher body_publisher_, cloud_publisher_, contact_publisher_, obstacle_publisher_, tool_publisher_;
  SteadyTime next_ = SteadyTime::max();
  DisplaySource source_;

  mutable std::mutex mutex_;
  std::optional<DisplaySnapshot> latest_;
  std::vector<RegionStress> region_stress_;
  DisplayBuilder builder_;  // the thread's own
  std::atomic<bool> stopping_ = false;
  Wakeup wakeup_;
  std::thread thread_;
};

}  // namespace incision

#include "incision/ros/marker_publisher.h"

#include <cmath>

#include "incision/ros/markers.h"

namespace incision {

MarkerPublisher::MarkerPublisher(ros::NodeHandle& node, const std::string& frame, double rate)
    : frame_(frame), next_(rate > 0 ? std::chrono::steady_clock::now() : SteadyTime::max()) {
  if (rate == 0) return;
  period_ = std::chrono::nanoseconds(std::llround(1e9 / rate));
  publisher_ = node.advertise<visualization_msgs::MarkerArray>("markers", 1);
  thread_ = std::thread([this] { run(); });
}

MarkerPublisher::~MarkerPublisher() {
  stopping_ = true;
  wakeup_.notify();
  if (thread_.joinable()) thread_.join();
}

void MarkerPublisher::offer(const DeformableBody& body, SteadyTime now) {
  if (now < next_) return;
  next_ = std::max(next_ + period_, now);
  if (publisher_.getNumSubscribers() == 0) return;
  if (!surface_ || topology_version_ != body.topologyVersion()) {
    surface_ = std::make_shared<Surface>(body.surface());
    topology_version_ = body.topologyVersion();
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    latest_ = Snapshot{surface_, body.positions()};
  }
  wakeup_.notify();
}

std::optional<MarkerPublisher::Snapshot> MarkerPublisher::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(latest_, std::nullopt);
}

void MarkerPublisher::run() {
  while (!stopping_) {
    if (const auto snapshot = take())
      publisher_.publish(toMarkers(*snapshot->surface, snapshot->positions, frame_, ros::Time::now()));
    wakeup_.waitUntil(SteadyTime::max());
  }
}

}  // namespace incision

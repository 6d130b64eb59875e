#include "incision/ros/marker_publisher.h"

#include <cmath>

#include "incision/ros/markers.h"

namespace incision {

MarkerPublisher::MarkerPublisher(ros::NodeHandle& node, const std::string& frame, double rate,
                                 const Obstacles& obstacles)
    : frame_(frame), obstacles_(obstacles), next_(rate > 0 ? std::chrono::steady_clock::now() : SteadyTime::max()) {
  if (rate == 0) return;
  period_ = std::chrono::nanoseconds(std::llround(1e9 / rate));
  body_publisher_ = node.advertise<visualization_msgs::MarkerArray>("markers", 1);
  if (!obstacles.shapes.empty()) obstacle_publisher_ = node.advertise<visualization_msgs::MarkerArray>("obstacles", 1);
  thread_ = std::thread([this] { run(); });
}

MarkerPublisher::~MarkerPublisher() {
  stopping_ = true;
  wakeup_.notify();
  if (thread_.joinable()) thread_.join();
}

void MarkerPublisher::offer(const DeformableBody& body, const std::vector<Pose>& links, SteadyTime now) {
  if (now < next_) return;
  next_ = std::max(next_ + period_, now);
  Snapshot snapshot;
  if (body_publisher_.getNumSubscribers() > 0) addSurface(body, &snapshot);
  if (obstacle_publisher_.getNumSubscribers() > 0) snapshot.links = links;
  if (!snapshot.surface && !snapshot.links) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    latest_ = std::move(snapshot);
  }
  wakeup_.notify();
}

void MarkerPublisher::addSurface(const DeformableBody& body, Snapshot* snapshot) {
  if (!surface_ || topology_version_ != body.topologyVersion()) {
    surface_ = std::make_shared<Surface>(body.surface());
    topology_version_ = body.topologyVersion();
  }
  snapshot->surface = surface_;
  snapshot->positions = body.positions();
}

std::optional<MarkerPublisher::Snapshot> MarkerPublisher::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(latest_, std::nullopt);
}

void MarkerPublisher::publish(const Snapshot& snapshot) const {
  const ros::Time stamp = ros::Time::now();
  if (snapshot.surface) body_publisher_.publish(toMarkers(*snapshot.surface, snapshot.positions, frame_, stamp));
  if (snapshot.links) obstacle_publisher_.publish(toMarkers(obstacles_, *snapshot.links, frame_, stamp));
}

void MarkerPublisher::run() {
  while (!stopping_) {
    if (const auto snapshot = take()) publish(*snapshot);
    wakeup_.waitUntil(SteadyTime::max());
  }
}

}  // namespace incision

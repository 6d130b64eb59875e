#include "incision/ros/marker_publisher.h"

#include <algorithm>
#include <cmath>

namespace incision {

MarkerPublisher::MarkerPublisher(ros::NodeHandle& node, const std::string& frame, double rate,
                                 const Obstacles& obstacles, const std::optional<Edge>& edge)
    : frame_(frame),
      obstacles_(obstacles),
      edge_(edge),
      next_(rate > 0 ? std::chrono::steady_clock::now() : SteadyTime::max()) {
  if (rate == 0) return;
  period_ = std::chrono::nanoseconds(std::llround(1e9 / rate));
  body_publisher_ = node.advertise<visualization_msgs::MarkerArray>("markers", 1);
  const auto is_tool = [&](const Obstacle& shape) { return obstacles.isTool(shape); };
  if (!std::all_of(obstacles.shapes.begin(), obstacles.shapes.end(), is_tool))
    obstacle_publisher_ = node.advertise<visualization_msgs::MarkerArray>("obstacles", 1);
  if (edge) tool_publisher_ = node.advertise<visualization_msgs::MarkerArray>("tool_markers", 1);
  thread_ = std::thread([this] { run(); });
}

MarkerPublisher::~MarkerPublisher() {
  stopping_ = true;
  wakeup_.notify();
  if (thread_.joinable()) thread_.join();
}

void MarkerPublisher::offer(const DeformableBody& body, const std::vector<Pose>& links, const Vec3& force,
                            SteadyTime now) {
  if (now < next_) return;
  next_ = std::max(next_ + period_, now);
  Snapshot snapshot;
  if (body_publisher_.getNumSubscribers() > 0) addSurface(body, &snapshot);
  if (obstacle_publisher_.getNumSubscribers() > 0) snapshot.links = links;
  if (tool_publisher_.getNumSubscribers() > 0) snapshot.tool = ToolView{body.toolPose(), force};
  if (!snapshot.surface && !snapshot.links && !snapshot.tool) return;
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
  if (snapshot.tool) tool_publisher_.publish(toMarkers(obstacles_, *edge_, *snapshot.tool, frame_, stamp));
}

void MarkerPublisher::run() {
  while (!stopping_) {
    if (const auto snapshot = take()) publish(*snapshot);
    wakeup_.waitUntil(SteadyTime::max());
  }
}

}  // namespace incision

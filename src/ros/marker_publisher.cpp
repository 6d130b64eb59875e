#include "incision/ros/marker_publisher.h"

#include <cmath>

namespace incision {

MarkerPublisher::MarkerPublisher(ros::NodeHandle& node, const NodeSettings& settings, const DeformableBody& body)
    : frame_(settings.scene.body.frame),
      obstacles_(body.obstacles()),
      next_(settings.marker_rate > 0 ? std::chrono::steady_clock::now() : SteadyTime::max()) {
  if (settings.marker_rate == 0) return;
  period_ = std::chrono::nanoseconds(std::llround(1e9 / settings.marker_rate));
  const auto advertise = [&](const std::string& topic) {
    return node.advertise<visualization_msgs::MarkerArray>(topic, 1);
  };
  body_publisher_ = advertise("markers");
  if (!obstacles_.shapes.empty()) obstacle_publisher_ = advertise("obstacles");
  for (std::size_t i = 0; i < settings.tools.size(); ++i)
    tools_.push_back({body.toolShapes(i), *body.toolEdge(i), advertise(settings.tools[i].topic("markers"))});
  thread_ = std::thread([this] { run(); });
}

MarkerPublisher::~MarkerPublisher() {
  stopping_ = true;
  wakeup_.notify();
  if (thread_.joinable()) thread_.join();
}

void MarkerPublisher::offer(const DeformableBody& body, const std::vector<Pose>& links, const StepResult& last_step,
                            SteadyTime now) {
  if (now < next_) return;
  next_ = std::max(next_ + period_, now);
  Snapshot snapshot;
  if (body_publisher_.getNumSubscribers() > 0) addSurface(body, &snapshot);
  if (obstacle_publisher_.getNumSubscribers() > 0) snapshot.links = links;
  for (std::size_t tool = 0; tool < tools_.size(); ++tool) {
    if (tools_[tool].publisher.getNumSubscribers() == 0) continue;
    const Vec3 force = tool < last_step.tools.size() ? last_step.tools[tool].force : Vec3::Zero();
    snapshot.tools.push_back({tool, ToolView{body.toolPose(tool), force}});
  }
  if (snapshot.empty()) return;
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
  for (const auto& [tool, view] : snapshot.tools)
    tools_[tool].publisher.publish(toMarkers(tools_[tool].shapes, tools_[tool].edge, view, frame_, stamp));
}

void MarkerPublisher::run() {
  while (!stopping_) {
    if (const auto snapshot = take()) publish(*snapshot);
    wakeup_.waitUntil(SteadyTime::max());
  }
}

}  // namespace incision

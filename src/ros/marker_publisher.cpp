#include "incision/ros/marker_publisher.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace incision {

MarkerPublisher::MarkerPublisher(ros::NodeHandle& node, const NodeSettings& settings, const DeformableBody& body)
    : node_(node), builder_(body) {
  set(settings.markers);
}

void MarkerPublisher::set(const MarkerSettings& settings) {
  field_ = settings.field;
  next_ = settings.rate > 0 ? steadyNow() : SteadyTime::max();
  if (settings.rate == 0) return;
  period_ = std::chrono::nanoseconds(std::llround(1e9 / settings.rate));
  if (!thread_.joinable()) start();
}

void MarkerPublisher::start() {
  const auto advertise = [&](const std::string& topic) {
    return node_.advertise<visualization_msgs::MarkerArray>(topic, 1);
  };
  body_publisher_ = advertise("markers");
  cloud_publisher_ = node_.advertise<sensor_msgs::PointCloud2>("surface", 1);
  contact_publisher_ = node_.advertise<Contacts>("contacts", 1);
  if (builder_.hasObstacles()) obstacle_publisher_ = advertise("obstacles");
  if (builder_.hasTools()) tool_publisher_ = advertise("tool_markers");
  thread_ = std::thread([this] { run(); });
}

MarkerPublisher::~MarkerPublisher() {
  stopping_ = true;
  wakeup_.notify();
  if (thread_.joinable()) thread_.join();
}

DisplayWishes MarkerPublisher::wishes() const {
  DisplayWishes wishes;
  wishes.markers = body_publisher_.getNumSubscribers() > 0;
  wishes.cloud = cloud_publisher_.getNumSubscribers() > 0;
  wishes.contacts = wantsContacts();
  wishes.obstacles = obstacle_publisher_.getNumSubscribers() > 0;
  wishes.tools = tool_publisher_.getNumSubscribers() > 0;
  wishes.field = field_;
  return wishes;
}

void MarkerPublisher::offer(const DeformableBody& body, const std::vector<Pose>& links, const StepResult& last_step,
                            bool wants_stress, SteadyTime now) {
  if (now < next_) return;
  next_ = std::max(next_ + period_, now);
  DisplayWishes wanted = wishes();
  wanted.region_stress = wants_stress;
  DisplaySnapshot snapshot = source_.take(body, links, last_step, wanted);
  if (snapshot.empty()) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    latest_ = std::move(snapshot);
  }
  wakeup_.notify();
}

std::vector<RegionStress> MarkerPublisher::regionStress() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return region_stress_;
}

std::optional<DisplaySnapshot> MarkerPublisher::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(latest_, std::nullopt);
}

void MarkerPublisher::publish(const DisplaySnapshot& snapshot) {
  DisplayMessages messages = builder_.build(snapshot, ros::Time::now());
  if (messages.region_stress) {
    const std::lock_guard<std::mutex> lock(mutex_);
    region_stress_ = std::move(*messages.region_stress);
  }
  if (messages.cloud) cloud_publisher_.publish(*messages.cloud);
  if (messages.body) body_publisher_.publish(*messages.body);
  if (messages.contacts) contact_publisher_.publish(*messages.contacts);
  if (messages.obstacles) obstacle_publisher_.publish(*messages.obstacles);
  if (messages.tools) tool_publisher_.publish(*messages.tools);
}

void MarkerPublisher::run() {
  while (!stopping_) {
    try {
      if (const auto snapshot = take()) publish(*snapshot);
    } catch (const std::bad_alloc&) {  // the next one may find memory
    }
    wakeup_.waitUntil(SteadyTime::max());
  }
}

}  // namespace incision

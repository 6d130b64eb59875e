// Steps of a body whose surface is published as in the node: the parameter `rate` is the node's marker_rate [Hz], and
// with `listens` somebody takes the markers. Every step is due for publishing, and waits until its message has come.

#include <ros/ros.h>
#include <visualization_msgs/MarkerArray.h>

#include <condition_variable>
#include <cstdio>
#include <mutex>

#include "incision/ros/marker_publisher.h"
#include "report/cost/cost_run.h"

namespace incision::report {
namespace {

class Listener {
 public:
  explicit Listener(ros::NodeHandle& node) : subscriber_(node.subscribe("markers", 10, &Listener::take, this)) {}

  /// Waits for one more message.
  void wait() {
    std::unique_lock<std::mutex> lock(mutex_);
    if (!came_.wait_for(lock, std::chrono::minutes(1), [this] { return messages_ > awaited_; }))
      throw std::runtime_error("no markers came");
    ++awaited_;
  }

 private:
  void take(const visualization_msgs::MarkerArray::ConstPtr&) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++messages_;
    came_.notify_one();
  }

  std::mutex mutex_;
  std::condition_variable came_;
  int messages_ = 0, awaited_ = 0;
  ros::Subscriber subscriber_;
};

int run(int argc, char** argv) {
  ros::init(argc, argv, "cost", ros::init_options::AnonymousName);
  ros::NodeHandle node("~");
  ros::AsyncSpinner spinner(1);
  spinner.start();
  const double rate = node.param("rate", 0.0);
  std::unique_ptr<MarkerPublisher> publisher;
  std::unique_ptr<Listener> listener;
  Besides besides;
  besides.set_up = [&](const DeformableBody& body) {
    NodeSettings settings;
    settings.scene = body.scene();
    settings.markers.rate = rate;
    publisher = std::make_unique<MarkerPublisher>(node, settings, body);
    if (node.param("listens", false)) listener = std::make_unique<Listener>(node);
  };
  besides.in_step = [&](const DeformableBody& body) {
    publisher->offer(body, {}, StepResult(), false,
                     rate > 0 ? publisher->nextOffer() : std::chrono::steady_clock::now());
  };
  besides.between = [&](const DeformableBody&) {
    if (listener) listener->wait();
  };
  std::printf("%s\n", costOf(costOptions(argc, argv), besides).dump().c_str());
  return 0;
}

}  // namespace
}  // namespace incision::report

int main(int argc, char** argv) {
  try {
    return incision::report::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

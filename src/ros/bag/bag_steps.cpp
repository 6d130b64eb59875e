#include "incision/ros/bag/bag_steps.h"

#include <algorithm>
#include <utility>

#include "incision/base/input_error.h"
#include "incision/base/printable.h"
#include "incision/ros/live_config.h"
#include "incision/ros/parameters.h"

namespace incision {
namespace {

/// `rosbag play` publishes the time of the first message for this long before the message.
constexpr std::chrono::milliseconds STANDSTILL(100);
static_assert(STANDSTILL > CLOCK_DELAY);

/// As a node's name is written, with one slash before it.
std::string nodeName(std::string name) {
  while (!name.empty() && name.back() == '/') name.pop_back();
  return name.empty() || name.front() != '/' ? "/" + name : name;
}

bool hasFrames(const DeformableBody& body) {
  const Scene& scene = body.scene();
  const auto has_frame = [](const auto& thing) { return !thing.frame.empty(); };
  return !body.obstacles().links.empty() || std::any_of(scene.boundary.begin(), scene.boundary.end(), has_frame) ||
         std::any_of(scene.tools.begin(), scene.tools.end(), has_frame);
}

Scene loadForNode(const BatchOptions& options) {
  Scene scene = loadScene(options.scene, options.overrides);
  leaveClampsToFrames(&scene);
  return scene;
}

/// Adds a scene's topics to a list.
struct TopicList {
  std::string node;
  std::vector<BagTopic>* topics;

  template <class Message>
  void operator()(const std::string& topic, const Receiver<Message>& receive) const {
    topics->push_back(bagTopic<Message>(node + "/" + topic, true, receive));
  }
};

}  // namespace

const BatchProgram BAG = {"incision_bag",
                          R"(usage: incision_bag BAG SCENE.yaml [options]

Runs a bag of cuts, tools' poses and transforms through a scene as the node
would, as fast as it goes, and ends with one line of JSON on standard output.

  --node NAME        the node whose topics the bag has (default /incision)
  --steps N          steps to take at most (default: to the bag's end)
)",
                          true, loadForNode, [](const BatchOptions& options, DeformableBody* body) {
                            return std::unique_ptr<StepSource>(std::make_unique<BagSteps>(options, body));
                          }};

BagSteps::BagSteps(const BatchOptions& options, DeformableBody* body)
    : body_(*body),
      time_step_(body->scene().solver.time_step),
      settings_(commandSettings(body->scene(), true, NodeSettings().transform_timeout)),
      answers_(settings_.tools),
      frames_(buffer_, body->scene().body.frame),
      commands_(settings_, frames_, answers_, wakeup_),
      messages_(*body, commands_, answers_),
      pacer_(time_step_, NodeSettings().max_lag),
      input_(*body, pacer_, commands_, frames_, answers_),
      watch_(pacer_, commands_, answers_),
      reader_(options.bag, topics(nodeName(options.node))),
      has_clock_(reader_.has("/clock")),
      now_(toSteady(reader_.begin()) - STANDSTILL) {}

std::vector<BagTopic> BagSteps::topics(const std::string& node) {
  std::vector<BagTopic> topics;
  messages_.forEachTopic(TopicList{node == "/" ? "" : node, &topics});
  const bool has_frames = hasFrames(body_);
  for (const bool is_static : {false, true})
    topics.push_back(bagTopic<tf2_msgs::TFMessage>(
        is_static ? "/tf_static" : "/tf", has_frames,
        [this, is_static](const tf2_msgs::TFMessage& message, SteadyTime) { receive(message, is_static); }));
  topics.push_back(bagTopic<dynamic_reconfigure::Config>(
      (node == "/" ? "" : node) + "/parameter_updates", false,
      [this](const dynamic_reconfigure::Config& message, SteadyTime) { receive(message); }));
  topics.push_back(bagTopic<rosgraph_msgs::Clock>(
      "/clock", false,
      [this](const rosgraph_msgs::Clock& message, SteadyTime received) { receive(message, received); }));
  return topics;
}

void BagSteps::receive(const rosgraph_msgs::Clock& message, SteadyTime received) {
  clock_ = static_cast<Nanoseconds>(message.clock.toNSec());
  pacer_.tick(received, clock_);
}

/// Like tf's listener, which forgets all when the clock goes back.
void BagSteps::receive(const tf2_msgs::TFMessage& message, bool is_static) {
  if (clock_ < std::exchange(tf_clock_, clock_)) buffer_.clear();
  for (const geometry_msgs::TransformStamped& transform : message.transforms)
    if (!buffer_.setTransform(transform, "bag", is_static))
      answers_.warn("a transform", "tf takes no transform of \"" + printable(transform.child_frame_id) + "\" in \"" +
                                       printable(transform.header.frame_id) + "\" stamped " +
                                       std::to_string(transform.header.stamp.toSec()) +
                                       ": it is no transform, or it has come before, or too late");
}

/// What held in the node from then on, but for the threads.
void BagSteps::receive(const dynamic_reconfigure::Config& message) {
  try {
    LiveSettings settings = changed({body_.live(), {}}, message, "parameter_updates").body;
    settings.threads = body_.live().threads;
    body_.set(settings);
  } catch (const InputError& error) {
    answers_.warn("what was set anew", error.what());
  }
}

bool BagSteps::prepare() {
  while (true) {
    answers_.setTime(now_, body_.time());
    if (input_.update(now_).step) break;
    if (!advance()) return false;
  }
  watch_.look(now_);
  input_.lead(now_);
  return true;
}

/// Goes on to when something happens next, if it does. Of what is recorded at one time all comes before a step.
bool BagSteps::advance() {
  const SteadyTime next = std::min({reader_.next(), nextTick(), pacer_.nextUpdate()});
  const bool is_over = next == SteadyTime::max();
  if (is_over && !commands_.waitForTransforms()) return false;
  now_ =
      is_over ? now_ + std::chrono::nanoseconds(std::llround(1e9 * settings_.transform_timeout)) : std::max(now_, next);
  while (reader_.next() <= now_) reader_.deliver();
  while (nextTick() <= now_) tick();
  if (commands_.waitForTransforms()) commands_.poll(now_);
  return true;
}

/// When the next tick is received, which is the time that it tells but for the first.
SteadyTime BagSteps::nextTick() const {
  if (has_clock_) return SteadyTime::max();
  if (ticks_ == 0) return toSteady(reader_.begin()) - STANDSTILL;
  const Nanoseconds time = std::max(startOfStep(reader_.begin(), time_step_, ticks_), reader_.begin());
  return time > reader_.end() ? SteadyTime::max() : toSteady(time);
}

void BagSteps::tick() {
  const SteadyTime received = nextTick();
  clock_ = ticks_ == 0 ? reader_.begin() : std::chrono::nanoseconds(received.time_since_epoch()).count();
  pacer_.tick(received, clock_);
  ++ticks_;
}

void BagSteps::taken(const StepResult& step) {
  input_.stepTaken();
  for (const CutResult& cut : step.cuts) answers_.report(cut);
}

void BagSteps::finish(const std::vector<CutResult>& cuts) {
  answers_.setTime(now_, body_.time());
  for (const CutResult& cut : cuts) answers_.report(cut);
  commands_.refuseAll({Refusal::BY_RESET, "the run has ended before it took effect"});
}

void BagSteps::recall(const std::string& leads) {
  input_.recall(readLeads(leads, input_.keep()), {Refusal::BY_RESET, "the body was restored"});
}

std::int64_t BagSteps::steps() const {
  return 1 + static_cast<std::int64_t>(1e-9 * static_cast<double>(reader_.end() - reader_.begin()) / time_step_);
}

std::vector<Quantity> BagSteps::quantities() const {
  std::vector<Quantity> all = {{"messages", reader_.delivered()}};
  for (const Quantity& quantity : answers_.quantities()) all.push_back(quantity);
  const auto count = [&](const char* name, std::uint64_t value) {
    all.push_back({name, static_cast<std::int64_t>(value)});
  };
  count("late_commands", commands_.late());
  count("thinned_poses", commands_.thinned());
  count("ignored_transforms", input_.ignored());
  all.push_back({"skipped_time", pacer_.skipped()});
  return all;
}

}  // namespace incision

#include "incision/ros/node.h"

#include <ros/console.h>

#include <cmath>

#include "incision/ros/conversions.h"

namespace incision {
namespace {

/// States that may wait for a slow subscriber: a few seconds of steps.
constexpr std::uint32_t STATE_QUEUE = 500;

/// Clock messages that may wait while a service is answered.
constexpr std::uint32_t CLOCK_QUEUE = 1000;

/// The state is published this often while no steps are taken, and shutting down is noticed.
constexpr std::chrono::milliseconds HEARTBEAT(100);

/// A step waits for commands that wait for their transform as long as it is less than this [s] behind /clock: messages
/// with unknown frames can delay the body by no more.
constexpr double MAX_HOLD = 0.5;

std::unique_ptr<Pacer> makePacer(const NodeSettings& settings) {
  const double time_step = settings.scene.solver.time_step;
  if (ros::Time::isSimTime()) return std::make_unique<ClockPacer>(time_step, settings.max_lag);
  return std::make_unique<WallPacer>(time_step);
}

std::optional<Edge> edgeOf(const NodeSettings& settings) {
  const auto& tool = settings.scene.tool;
  if (!tool) return std::nullopt;
  return bladeEdge(*tool, settings.descriptions.tool, tool->description);
}

SteadyTime now() { return std::chrono::steady_clock::now(); }

}  // namespace

IncisionNode::IncisionNode()
    : settings_(loadSettings(node_)),
      body_(settings_.scene, loadMesh(settings_.scene), settings_.descriptions),
      edge_(edgeOf(settings_)),
      pacer_(makePacer(settings_)),
      tasks_(wakeup_),
      reporter_(node_, settings_.scene.body.frame, settings_.scene.fracture.has_value()),
      markers_(node_, settings_.scene.body.frame, settings_.marker_rate, body_.obstacles(), edge_),
      state_(node_.advertise<BodyState>("state", STATE_QUEUE)),
      pause_service_(node_.advertiseService("pause", &IncisionNode::pauseService, this)),
      step_service_(node_.advertiseService("step", &IncisionNode::stepService, this)),
      reset_service_(node_.advertiseService("reset", &IncisionNode::resetService, this)),
      input_(node_, settings_, agenda_, reporter_, wakeup_),
      tracker_(input_.transforms(), settings_.scene.body.frame, body_.obstacles(), settings_.scene.solver.time_step),
      spinner_(1) {
  if (edge_) tool_ = std::make_unique<ToolDriver>(node_, settings_.scene, *edge_, input_.transforms());
  const BodyCounts counts = body_.counts();
  reporter_.setPieces(counts.pieces);
  // Also because roscpp registers the node once more at its first message: were that the one that a node of the same
  // name has taken over, the master would end both.
  ROS_INFO_STREAM("a body of " << counts.elements << " elements in frame \"" << settings_.scene.body.frame << "\"");
  if (auto* pacer = dynamic_cast<ClockPacer*>(pacer_.get()))
    clock_ = node_.subscribe<rosgraph_msgs::Clock>(
        "/clock", CLOCK_QUEUE, [this, pacer](const rosgraph_msgs::Clock::ConstPtr& message) {
          pacer->tick(now(), static_cast<Nanoseconds>(message->clock.toNSec()));
          wakeup_.notify();
        });
  spinner_.start();
}

IncisionNode::~IncisionNode() { tasks_.close(); }  // or the spinner would wait for a service that waits for us

void IncisionNode::run() {
  while (ros::ok()) {
    bool changed = tasks_.run();
    pacer_->update(now());
    const bool due = stepDue();
    changed |= applyCuts(due);
    if (due) step();
    if (changed || due || now() >= next_heartbeat_) publishState();
    markers_.offer(body_, tracker_.poses(), last_step_.tool.force, now());
    if (!due) wakeup_.waitUntil(std::min({pacer_->nextUpdate(), markers_.nextOffer(), next_heartbeat_}));
  }
}

bool IncisionNode::stepDue() {
  if (paused_ || !pacer_->due()) return false;
  return pacer_->lag() >= MAX_HOLD || !input_.waitsFor(pacer_->nextStart());
}

/// Stamped commands are taken together when their step is due, since they may arrive in another order.
bool IncisionNode::applyCuts(bool step_due) {
  const Nanoseconds time = paused_ ? pacer_->clock() : step_due ? pacer_->nextStart() : 0;
  const std::vector<PlaneCut> cuts = agenda_.takeCuts(time);
  for (const PlaneCut& plane : cuts) applyCut(plane);
  return !cuts.empty();
}

void IncisionNode::applyCut(const PlaneCut& plane) {
  try {
    reporter_.report(body_.cut(plane));
  } catch (const std::exception& error) {
    reporter_.refuseCut(plane.label, {Refusal::BY_BODY, error.what()});
  }
}

StepTime IncisionNode::stepTime() const {
  if (!ros::Time::isSimTime()) return {std::chrono::nanoseconds(now().time_since_epoch()).count(), 0, paused_};
  const auto time_step = static_cast<Nanoseconds>(std::llround(1e9 * settings_.scene.solver.time_step));
  return {paused_ ? pacer_->clock() : pacer_->nextStart(), pacer_->nextStart() + time_step, paused_};
}

/// Before a step. Poses stamped later than its start wait.
void IncisionNode::leadTool(const StepTime& time) {
  if (!tool_) return;
  const ToolInput input = agenda_.takeTool(paused_ ? pacer_->clock() : pacer_->nextStart());
  for (const CutResult& stroke : tool_->lead(input, time, &body_)) reporter_.report(stroke);
}

/// Before a step: the obstacles' links go where tf has them at its end.
void IncisionNode::moveObstacles(const StepTime& time) {
  for (const LinkMove& move : tracker_.follow(time.end)) {
    if (move.at_once)
      body_.placeObstacle(move.link, move.pose);
    else
      body_.moveObstacle(move.link, move.pose);
  }
}

void IncisionNode::step() {
  try {
    const StepTime time = stepTime();
    leadTool(time);
    moveObstacles(time);
    last_step_ = body_.step();
    if (tool_) tool_->publishWrench(last_step_.tool);
    error_.clear();
  } catch (const std::exception& error) {
    stepFailed(error.what());
    return;
  }
  pacer_->stepTaken();
  real_time_factor_.add(now(), body_.time());
  for (const CutResult& result : last_step_.cuts) reporter_.report(result);
  for (const CrackResult& result : last_step_.cracks) reporter_.report(result);
}

void IncisionNode::stepFailed(const std::string& why) {
  error_ = why;
  setPaused(true);
  ROS_ERROR_STREAM("paused, because a step failed: " << why);
}

void IncisionNode::setPaused(bool paused) {
  paused_ = paused;
  real_time_factor_.restart();
  pacer_->restart();
}

void IncisionNode::reset() {
  const Refused refused{Refusal::BY_RESET, "the body was reset before this command took effect"};
  input_.clear(refused);
  for (const PlaneCut& plane : agenda_.clear()) reporter_.refuseCut(plane.label, refused);
  if (const auto stroke = settings_.scene.tool ? body_.liftTool() : std::nullopt) reporter_.report(*stroke);
  body_.reset();
  tracker_.restart();
  if (tool_) tool_->restart();
  last_step_ = StepResult();
  error_.clear();
  reporter_.setPieces(body_.counts().pieces);
  setPaused(paused_);
}

void IncisionNode::publishState() {
  next_heartbeat_ = now() + HEARTBEAT;
  if (state_.getNumSubscribers() == 0) return;
  BodyState state;
  state.header.stamp = ros::Time::now();
  state.header.frame_id = settings_.scene.body.frame;
  fillState(body_, state);
  state.paused = paused_;
  state.error = error_;
  state.step_ms = last_step_.step_ms;
  state.iterations = last_step_.iterations;
  state.residual = last_step_.residual;
  state.contacts = last_step_.contact.count;
  state.deepest_contact = last_step_.contact.deepest;
  state.real_time_factor = real_time_factor_.value();
  state.clock_lag = pacer_->lag();
  reporter_.fillState(state);
  state.late_commands = agenda_.late();
  state.thinned_poses = agenda_.thinned();
  state.ignored_transforms = tracker_.ignored();
  if (tool_) tool_->fillState(last_step_.tool, &state);
  state_.publish(state);
}

bool IncisionNode::pauseService(SetBool::Request& request, SetBool::Response& response) {
  return tasks_.ask([&] {
    setPaused(request.data);
    response.success = true;
    response.message = (paused_ ? "paused at step " : "running from step ") + std::to_string(body_.steps());
  });
}

bool IncisionNode::stepService(Trigger::Request&, Trigger::Response& response) {
  return tasks_.ask([&] {
    if (paused_) step();
    response.success = paused_ && error_.empty();
    response.message = !paused_ ? "not paused" : !error_.empty() ? error_ : "at step " + std::to_string(body_.steps());
  });
}

bool IncisionNode::resetService(Trigger::Request&, Trigger::Response& response) {
  return tasks_.ask([&] {
    reset();
    response.success = true;
    response.message = "at step 0";
  });
}

}  // namespace incision

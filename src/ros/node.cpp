#include "incision/ros/node.h"

#include <ros/console.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "incision/body/quantities.h"
#include "incision/body/remarks.h"
#include "incision/ros/conversions.h"
#include "incision/ros/leads_memory.h"
#include "incision/ros/tf_frames.h"

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
constexpr double MAX_DELAY = 0.5;

/// Least time [s] between two warnings of one kind.
constexpr double WARNING_PERIOD = 2;

std::unique_ptr<Pacer> makePacer(const NodeSettings& settings) {
  const double time_step = settings.scene.solver.time_step;
  if (ros::Time::isSimTime()) return std::make_unique<ClockPacer>(time_step, settings.max_lag);
  return std::make_unique<WallPacer>(time_step);
}

TetMesh loadMeshAloud(const Scene& scene) {
  std::vector<std::string> notes;
  TetMesh mesh = loadMesh(scene, &notes);
  for (const std::string& note : notes) ROS_WARN_STREAM(note);
  return mesh;
}

SteadyTime now() { return std::chrono::steady_clock::now(); }

}  // namespace

IncisionNode::IncisionNode()
    : settings_(loadSettings(node_)),
      body_(settings_.scene, loadMeshAloud(settings_.scene), settings_.descriptions),
      pacer_(makePacer(settings_)),
      tasks_(wakeup_),
      agenda_(settings_.scene.tools.size()),
      reporter_(node_, settings_.scene),
      markers_(node_, settings_, body_),
      state_(node_.advertise<BodyState>("state", STATE_QUEUE)),
      pause_service_(node_.advertiseService("pause", &IncisionNode::pauseService, this)),
      step_service_(node_.advertiseService("step", &IncisionNode::stepService, this)),
      reset_service_(node_.advertiseService("reset", &IncisionNode::resetService, this)),
      input_(node_, settings_, body_, agenda_, reporter_, wakeup_),
      obstacles_(LinkLookup(input_.frames(), warnOfLinks("the obstacles")), linksOf(body_.obstacles()),
                 settings_.scene.solver.time_step),
      clamps_(input_.frames(), warnOfLinks("the clamps"), settings_.scene.boundary, settings_.scene.solver.time_step),
      checkpoints_(node_, settings_, keyOf(body_, settings_.descriptions), tasks_,
                   {[this] { return save(); }, [this](const SavedState& state) { restore(state); },
                    [this] { return body_.steps(); }}),
      spinner_(1) {
  for (const std::string& remark : remarksOn(body_.scene(), body_.mesh())) ROS_WARN_STREAM(remark);
  for (const std::string& remark : remarksOnShapes(body_)) ROS_WARN_STREAM(remark);
  for (std::size_t i = 0; i < settings_.scene.tools.size(); ++i)
    tools_.emplace_back(node_, i, settings_.scene, body_.toolForm(i), input_.frames());
  reporter_.setPieces(body_.counts().pieces);
  // Also because roscpp registers the node once more at its first message: were that the one that a node of the same
  // name has taken over, the master would end both.
  ROS_INFO_STREAM(describe(body_));
  if (auto* pacer = dynamic_cast<ClockPacer*>(pacer_.get()))
    clock_ = node_.subscribe<rosgraph_msgs::Clock>(
        "/clock", CLOCK_QUEUE, [this, pacer](const rosgraph_msgs::Clock::ConstPtr& message) {
          pacer->tick(now(), static_cast<Nanoseconds>(message->clock.toNSec()));
          wakeup_.notify();
        });
  checkpoints_.restoreAtStart();
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
    checkpoints_.offer(now(), body_.topologyVersion());
    markers_.offer(body_, obstacles_.poses(), last_step_, wantsRegionStress(), now());
    if (!due) wakeup_.waitUntil(std::min({pacer_->nextUpdate(), markers_.nextOffer(), next_heartbeat_}));
  }
}

bool IncisionNode::stepDue() {
  if (paused_ || !pacer_->due()) return false;
  return pacer_->lag() >= MAX_DELAY || !input_.waitsFor(pacer_->nextStart());
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
  if (!ros::Time::isSimTime())
    return {std::chrono::nanoseconds(now().time_since_epoch()).count(), 0,
            static_cast<Nanoseconds>(ros::Time::now().toNSec()), paused_};
  const auto time_step = static_cast<Nanoseconds>(std::llround(1e9 * settings_.scene.solver.time_step));
  const Nanoseconds start = paused_ ? pacer_->clock() : pacer_->nextStart();
  return {start, pacer_->nextStart() + time_step, start, paused_};
}

/// Before a step. Poses stamped later than its start wait.
void IncisionNode::leadTools(const StepTime& time) {
  const Nanoseconds start = paused_ ? pacer_->clock() : pacer_->nextStart();
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    const ToolInput input = agenda_.takeTool(static_cast<int>(i), start);
    for (const CutResult& stroke : tools_[i].lead(input, time, &body_)) reporter_.report(stroke);
  }
}

/// Before a step: the obstacles' links go where tf has them at its end.
void IncisionNode::moveObstacles(const StepTime& time) {
  for (const LinkMove& move : obstacles_.follow(time.ros, time.end)) {
    if (move.jump_speed)
      ROS_WARN_STREAM_THROTTLE(WARNING_PERIOD, "link \"" << body_.obstacles().links[move.link].name
                                                         << "\" of the obstacles jumped, at " << *move.jump_speed
                                                         << " m/s (followed: up to " << MAX_OBSTACLE_SPEED << " m/s)");
    if (move.at_once)
      body_.placeObstacle(move.link, move.pose);
    else
      body_.moveObstacle(move.link, move.pose);
  }
}

/// Before a step: the clamps' frames go where tf has them at its end.
void IncisionNode::moveClamps(const StepTime& time) {
  for (const LinkMove& move : clamps_.follow(time.ros, time.end, time.single)) {
    if (move.jump_speed)
      ROS_WARN_STREAM_THROTTLE(WARNING_PERIOD, "frame \"" << settings_.scene.boundary[move.link].frame
                                                          << "\" of a clamp jumped, at " << *move.jump_speed
                                                          << " m/s (followed: up to " << MAX_OBSTACLE_SPEED
                                                          << " m/s): the clamp is put there at once");
    if (move.at_once)
      body_.placeClamp(move.link, move.pose);
    else
      body_.moveClamp(move.link, move.pose);
  }
}

void IncisionNode::step() {
  const bool taken = tryStep();
  if (taken) {
    pacer_->stepTaken();
    real_time_factor_.add(now(), body_.time());
  }
  reportChanges();
}

bool IncisionNode::tryStep() {
  try {
    const StepTime time = stepTime();
    leadTools(time);
    moveObstacles(time);
    moveClamps(time);
    body_.wantWrenches(markers_.wantsContacts());
    last_step_ = body_.step();
    for (ToolDriver& tool : tools_) tool.publish(last_step_, body_);
    if (!last_step_.settled)
      ROS_WARN_STREAM_THROTTLE(WARNING_PERIOD, body_.unsettledSteps() << " steps so far whose contacts did not settle");
    error_.clear();
    return true;
  } catch (const std::exception& error) {
    stepFailed(error.what());
    return false;
  }
}

/// Each change once, and those before a failure of the step too.
void IncisionNode::reportChanges() {
  const Reports untold = body_.takeReports();
  for (const auto& cuts : {std::exchange(last_step_.cuts, {}), untold.cuts})
    for (const CutResult& result : cuts) reporter_.report(result);
  for (const auto& cracks : {std::exchange(last_step_.cracks, {}), untold.cracks})
    for (const CrackResult& result : cracks) reporter_.report(result);
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

/// The commands that wait are answered; the blades are on then, or as `active` has them.
void IncisionNode::dropWaiting(const std::string& why, const std::vector<bool>& active) {
  const Refused refused{Refusal::BY_RESET, why + " before this command took effect"};
  input_.clear(refused);
  for (const PlaneCut& plane : agenda_.clear(active)) reporter_.refuseCut(plane.label, refused);
}

void IncisionNode::reset() {
  dropWaiting("the body was reset");
  for (ToolDriver& tool : tools_)
    if (const auto stroke = tool.restart(&body_)) reporter_.report(*stroke);
  body_.reset();
  obstacles_.restart();
  clamps_.restart();
  startAnew();
}

/// After the body has become another.
void IncisionNode::startAnew() {
  last_step_ = StepResult();
  error_.clear();
  reporter_.setPieces(body_.counts().pieces);
  setPaused(paused_);
}

SavedState IncisionNode::save() const {
  SavedState state = savedState(body_);
  LeadsMemory leads{{}, obstacles_.keep(), clamps_.keep()};
  for (const ToolDriver& tool : tools_) leads.tools.push_back(tool.keep());
  state.leads = toBytes(leads);
  return state;
}

/// A body that no node has saved is taken over as it stands.
void IncisionNode::restore(const SavedState& state) {
  const LeadsMemory now{std::vector<ToolDriverMemory>(tools_.size()), obstacles_.keep(), clamps_.keep()};
  const std::optional<LeadsMemory> leads = readLeads(state.leads, now);
  body_.restore(state.body);
  dropWaiting("the body was restored", leads ? leads->active() : std::vector<bool>());
  if (leads) {
    for (std::size_t i = 0; i < tools_.size(); ++i) tools_[i].recall(leads->tools[i]);
    obstacles_.recall(leads->obstacles);
    clamps_.recall(leads->clamps);
  } else {
    for (std::size_t i = 0; i < tools_.size(); ++i) tools_[i].takeOver(body_.toolPose(i));
    obstacles_.restart();
    clamps_.restart();
  }
  startAnew();
}

bool IncisionNode::wantsRegionStress() const {
  return !body_.materials().regions().areOne() && state_.getNumSubscribers() > 0;
}

void IncisionNode::publishState() {
  next_heartbeat_ = now() + HEARTBEAT;
  if (state_.getNumSubscribers() == 0) return;
  BodyState state;
  state.header.stamp = ros::Time::now();
  state.header.frame_id = settings_.scene.body.frame;
  fillState(body_, last_step_, &state);
  state.paused = paused_;
  state.error = error_;
  state.step_ms = last_step_.step_ms;
  state.contacts = last_step_.contact.count;
  state.deepest_contact = last_step_.contact.deepest;
  state.real_time_factor = real_time_factor_.value();
  state.clock_lag = pacer_->lag();
  if (wantsRegionStress()) fillRegions(body_.materials().regions(), markers_.regionStress(), &state);
  reporter_.fillState(state);
  state.late_commands = agenda_.late();
  state.thinned_poses = agenda_.thinned();
  state.ignored_transforms = obstacles_.ignored() + clamps_.ignored();
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    state.tools.push_back(tools_[i].state(last_step_, body_));
    state.tools.back().refused = reporter_.refusedOf(i);
    state.ignored_transforms += tools_[i].ignored();
  }
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

#include "incision/ros/node.h"

#include <ros/console.h>

#include <algorithm>
#include <thread>
#include <utility>

#include "incision/body/quantities.h"
#include "incision/body/remarks.h"
#include "incision/ros/conversions.h"
#include "incision/ros/ending.h"

namespace incision {
namespace {

/// Clock messages that may wait while a service is answered.
constexpr std::uint32_t CLOCK_QUEUE = 1000;

/// The state is published this often while no steps are taken, and shutting down is noticed.
constexpr std::chrono::milliseconds HEARTBEAT(100);

/// Short enough for a string that takes nothing from the heap.
constexpr const char* OUT_OF_MEMORY = "memory ran out";

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

}  // namespace

IncisionNode::IncisionNode()
    : settings_(loadSettings(node_)),
      body_(settings_.scene, loadMeshAloud(settings_.scene), settings_.descriptions),
      pacer_(makePacer(settings_)),
      tasks_(wakeup_),
      reporter_(node_, settings_.scene, &publishing_),
      markers_(node_, settings_, body_),
      first_steps_(settings_.scene.solver.time_step),
      slowness_(settings_.scene.solver.time_step, settings_.scene.contact && settings_.scene.contact->self),
      state_(node_, body_),
      pause_service_(node_.advertiseService("pause", &IncisionNode::pauseService, this)),
      step_service_(node_.advertiseService("step", &IncisionNode::stepService, this)),
      reset_service_(node_.advertiseService("reset", &IncisionNode::resetService, this)),
      input_(node_, settings_, body_, reporter_, wakeup_),
      step_input_(body_, *pacer_, input_.commands(), input_.frames(), reporter_),
      watch_(*pacer_, input_.commands(), reporter_),
      reconfigure_(
          node_, {body_.live(), settings_.markers}, tasks_, &publishing_,
          [this](const NodeLiveSettings& settings) { set(settings); },
          [this](const Refused& refused) { reporter_.refuseSettings(refused); }),
      checkpoints_(node_, settings_, keyOf(body_, settings_.descriptions), tasks_,
                   {[this] { return save(); }, [this](const SavedState& state) { restore(state); },
                    [this] { return body_.steps(); }}),
      diagnostics_(
          node_, settings_,
          [this] {
            return InputCounts{reporter_.counts(), input_.commands().late(), input_.commands().thinned(), 0};
          },
          [this] {
            return Waiting{input_.commands().waitingForTransform(), input_.commands().waitingForStep()};
          }),
      spinner_(1) {
  for (const std::string& remark : remarksOn(body_.scene(), body_.mesh())) ROS_WARN_STREAM(remark);
  for (const std::string& remark : remarksOnShapes(body_)) ROS_WARN_STREAM(remark);
  for (std::size_t i = 0; i < settings_.scene.tools.size(); ++i)
    tools_.emplace_back(node_, i, settings_.scene, &publishing_);
  reporter_.setPieces(body_.counts().pieces);
  // Also because roscpp registers the node once more at its first message: were that the one that a node of the same
  // name has taken over, the master would end both.
  ROS_INFO_STREAM(describe(body_));
  if (auto* pacer = dynamic_cast<ClockPacer*>(pacer_.get()))
    clock_ = node_.subscribe<rosgraph_msgs::Clock>(
        "/clock", CLOCK_QUEUE, [this, pacer](const rosgraph_msgs::Clock::ConstPtr& message) {
          guarded([&] { pacer->tick(steadyNow(), static_cast<Nanoseconds>(message->clock.toNSec())); });
          wakeup_.notify();
        });
  checkpoints_.restoreAtStart();
  spinner_.start();
  endWhenAsked();
}

/// Services first, or the spinner would wait for one that waits for us.
IncisionNode::~IncisionNode() {
  tasks_.close();
  input_.close({Refusal::BY_RESET, "the node has ended before it took effect"});
  reporter_.flush();
}

/// A part of what a turn does may find no memory: then that part is left out, and the node goes on.
template <class Part>
void IncisionNode::guarded(const Part& part) {
  try {
    part();
  } catch (const std::bad_alloc&) {
    reporter_.warn(OUT_OF_MEMORY, OUT_OF_MEMORY);
  }
}

void IncisionNode::run() {
  slowness_.restart(steadyNow());
  while (!endAsked()) {
    bool changed = false;
    StepInput::Due due;
    guarded([&] { changed = tasks_.run(); });
    guarded([&] { due = step_input_.update(steadyNow()); });
    if (due.step) step();
    changed |= due.cut || due.step;
    if (changed || steadyNow() >= next_heartbeat_) guarded([&] { publishState(); });
    publishing_.flush();
    guarded([&] { tellCondition(); });
    guarded([&] { watch_.look(steadyNow()); });
    guarded([&] { tellSlowness(); });
    guarded([&] { checkpoints_.offer(steadyNow(), body_.topologyVersion()); });
    guarded([&] { markers_.offer(body_, step_input_.obstaclePoses(), last_step_, wantsRegionStress(), steadyNow()); });
    if (!due.step) wakeup_.waitUntil(std::min({pacer_->nextUpdate(), markers_.nextOffer(), next_heartbeat_}));
  }
}

void IncisionNode::step() {
  const bool taken = tryStep();
  if (taken) {
    step_input_.stepTaken();
    guarded([&] {
      real_time_factor_.add(steadyNow(), body_.time());
      diagnostics_.stepTaken(last_step_);
      slowness_.stepTaken(last_step_);
      if (const auto pace = first_steps_.add(last_step_.step_ms)) reporter_.inform(*pace);
    });
  }
  reportChanges();
}

bool IncisionNode::tryStep() {
  try {
    step_input_.lead(steadyNow());
    body_.wantWrenches(markers_.wantsContacts());
    last_step_ = body_.step();
  } catch (const std::bad_alloc&) {
    stepFailed(OUT_OF_MEMORY);
    return false;
  } catch (const std::exception& error) {
    stepFailed(error.what());
    return false;
  }
  error_.clear();
  guarded([&] { tellStep(); });
  return true;
}

/// To those who wait for it: how the tools are.
void IncisionNode::tellStep() {
  for (std::size_t i = 0; i < tools_.size(); ++i) tools_[i].publish(last_step_, body_, step_input_.tools()[i]);
  publishing_.flush();
  if (!last_step_.settled)
    reporter_.warn("settling", std::to_string(body_.unsettledSteps()) + " steps so far that did not settle");
}

/// Each change once, and those before a failure of the step too.
void IncisionNode::reportChanges() {
  const Reports told{std::exchange(last_step_.cuts, {}), std::exchange(last_step_.cracks, {})};
  const Reports untold = body_.takeReports();
  for (const Reports* reports : {&told, &untold}) {
    for (const CutResult& result : reports->cuts) reporter_.report(result);
    for (const CrackResult& result : reports->cracks) reporter_.report(result);
  }
}

void IncisionNode::stepFailed(const char* why) {
  setPaused(true);
  error_ = OUT_OF_MEMORY;
  guarded([&] {
    error_ = why;
    ROS_ERROR_STREAM("paused, because a step failed: " << why
                                                       << " (~reset starts anew, ~restore goes back to a checkpoint)");
  });
}

void IncisionNode::setPaused(bool paused) {
  step_input_.setPaused(paused);
  restartPace();
}

void IncisionNode::reset() {
  const Refused refused = {Refusal::BY_RESET, "the body was reset before it took effect"};
  for (const CutResult& stroke : body_.reset()) reporter_.report(stroke);
  step_input_.restart(refused);
  for (ToolPublisher& tool : tools_) guarded([&] { tool.restart(); });
  startAnew();
}

/// After the body has become another.
void IncisionNode::startAnew() {
  last_step_ = StepResult();
  error_.clear();
  reporter_.setPieces(body_.counts().pieces);
  restartPace();
}

void IncisionNode::restartPace() {
  real_time_factor_.restart();
  slowness_.restart(steadyNow());
}

SavedState IncisionNode::save() const {
  SavedState state = savedState(body_);
  state.leads = toBytes(step_input_.keep());
  return state;
}

/// All that may throw comes before the body has become another. One that no node has saved is taken over as it stands.
void IncisionNode::restore(const SavedState& state) {
  const Refused refused = {Refusal::BY_RESET, "the body was restored before it took effect"};
  std::optional<LeadsMemory> leads = readLeads(state.leads, step_input_.keep());
  body_.restore(state.body);
  step_input_.recall(std::move(leads), refused);
  startAnew();
  guarded([&] { reconfigure_.show(body_.live()); });
}

bool IncisionNode::wantsRegionStress() const { return !body_.materials().regions().areOne() && state_.wanted(); }

void IncisionNode::publishState() {
  next_heartbeat_ = steadyNow() + HEARTBEAT;
  if (!state_.wanted()) return;
  BodyState state;
  state.header.stamp = ros::Time::now();
  state.header.frame_id = settings_.scene.body.frame;
  state.paused = step_input_.paused();
  state.error = error_;
  state.step_ms = last_step_.step_ms;
  state.contacts = last_step_.contact.count;
  state.deepest_contact = last_step_.contact.deepest;
  state.real_time_factor = real_time_factor_.value();
  state.clock_lag = pacer_->lag();
  if (wantsRegionStress()) fillRegions(body_.materials().regions(), markers_.regionStress(), &state);
  reporter_.fillState(state);
  const Commands& commands = input_.commands();
  state.skipped_time = pacer_->skipped();
  state.late_commands = commands.late();
  state.thinned_poses = commands.thinned();
  state.waiting_for_transform = commands.waitingForTransform();
  state.waiting_for_step = commands.waitingForStep();
  state.ignored_transforms = step_input_.ignored();
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    state.tools.push_back(tools_[i].state(last_step_, body_, step_input_.tools()[i]));
    state.tools.back().refused = reporter_.refusedOf(i);
  }
  state_.give(last_step_, &state);
}

void IncisionNode::tellCondition() {
  diagnostics_.tell([this](Condition* condition) {
    condition->paused = step_input_.paused();
    condition->by_clock = ros::Time::isSimTime();
    condition->error = error_;
    condition->steps = body_.steps();
    condition->real_time_factor = real_time_factor_.value();
    condition->clock_lag = pacer_->lag();
    condition->tolerance = body_.live().tolerance;
    condition->ignored_transforms = step_input_.ignored();
    for (std::size_t i = 0; i < tools_.size(); ++i)
      condition->stale[i] = static_cast<char>(step_input_.tools()[i].stale());
  });
}

/// /clock may be as slow as it likes.
void IncisionNode::tellSlowness() {
  if (step_input_.paused() || pacer_->goesByStamps()) return;
  const auto machine_threads = static_cast<int>(std::thread::hardware_concurrency());
  if (const auto said = slowness_.look(steadyNow(), body_.live().threads, machine_threads))
    reporter_.warn("pace", *said);
}

/// Between steps.
void IncisionNode::set(const NodeLiveSettings& settings) {
  body_.set(settings.body);
  markers_.set(settings.markers);
}

bool IncisionNode::pauseService(SetBool::Request& request, SetBool::Response& response) {
  return tasks_.ask([&] {
    setPaused(request.data);
    response.success = true;
    response.message = (request.data != 0 ? "paused at step " : "running from step ") + std::to_string(body_.steps());
  });
}

bool IncisionNode::stepService(Trigger::Request&, Trigger::Response& response) {
  return tasks_.ask([&] {
    const bool paused = step_input_.paused();
    if (paused) step();
    response.success = paused && error_.empty();
    response.message = !paused ? "not paused" : !error_.empty() ? error_ : "at step " + std::to_string(body_.steps());
  });
}

bool IncisionNode::resetService(Trigger::Request&, Trigger::Response& response) {
  return tasks_.ask([&] {
    try {
      reset();
      response.success = true;
      response.message = "at step 0";
    } catch (const std::bad_alloc&) {
      response.message = OUT_OF_MEMORY;
    }
  });
}

}  // namespace incision

#include "incision/ros/state_publisher.h"

#include <algorithm>

#include "incision/body/quantities.h"
#include "incision/ros/conversions.h"

namespace incision {
namespace {

/// States that may wait for a slow subscriber: a few seconds of steps.
constexpr std::uint32_t STATE_QUEUE = 500;

/// Memory for those that wait to be reckoned [bytes]: where the thread has no processor, a body of a hundred thousand
/// elements then loses states that are older than some tens of steps.
constexpr std::size_t DRAFT_MEMORY = std::size_t{64} << 20;

/// States after which a topology is likely to stay for more.
constexpr int CALM = 3;

std::size_t mostDrafts(const DeformableBody& body) {
  const std::size_t bytes = 2 * sizeof(Vec3) * body.positions().size() + 1;
  return std::clamp<std::size_t>(DRAFT_MEMORY / bytes, 10, STATE_QUEUE);
}

}  // namespace

StatePublisher::Topic::Topic(const ros::Publisher& of_topic, const DeformableBody& body, std::size_t most)
    : publisher(of_topic), materials(body.materials()), settings(body.scene().body), queue(most) {}

void StatePublisher::Topic::send() {
  queue.sendAll([this](Draft& draft) {
    if (draft.mesh) finish(&draft);
    publisher.publish(draft.message);
  });
}

void StatePublisher::Topic::finish(Draft* draft) {
  if (!view || &view->mesh() != draft->mesh.get())
    view = std::make_unique<StateView>(draft->mesh, materials, settings, draft->motion.x);
  draft->message.state_hash = hexadecimal(view->hash(draft->steps, draft->motion));
  fillState(
      quantitiesOf(draft->counts, view->motion(draft->motion, draft->gravity), draft->unsettled_steps, draft->step),
      &draft->message);
  draft->mesh.reset();
}

StatePublisher::StatePublisher(ros::NodeHandle& node, const DeformableBody& body)
    : body_(body),
      publisher_(node.advertise<BodyState>("state", STATE_QUEUE)),
      topic_(std::make_shared<Topic>(publisher_, body, mostDrafts(body))) {
  thread_.add(topic_);
}

/// The mesh where it has stayed for some states, else none.
const std::shared_ptr<const CutMesh>& StatePublisher::calmMesh() {
  if (version_ != body_.topologyVersion()) {
    version_ = body_.topologyVersion();
    mesh_.reset();
    states_ = 0;
  }
  states_ = std::min(states_ + 1, CALM);
  if (!mesh_ && states_ == CALM) mesh_ = std::make_shared<CutMesh>(body_.mesh());
  return mesh_;
}

void StatePublisher::give(const StepResult& last_step, BodyState* state) {
  state->step = body_.steps();
  state->time = body_.time();
  const std::shared_ptr<const CutMesh>& mesh = calmMesh();
  if (!mesh) {
    state->state_hash = hexadecimal(body_.stateHash());
    fillState(quantitiesOf(body_, last_step), state);
  }
  topic_->queue.give([&](Draft* draft) {
    if (mesh) {
      draft->steps = body_.steps();
      draft->unsettled_steps = body_.unsettledSteps();
      draft->counts = body_.counts();
      draft->step.contact = last_step.contact;
      draft->step.iterations = last_step.iterations;
      draft->step.residual = last_step.residual;
      draft->step.solves = last_step.solves;
      draft->gravity = body_.live().gravity;
      draft->motion.x = body_.positions();
      draft->motion.v = body_.velocities();
    }
    draft->mesh = mesh;
    std::swap(draft->message, *state);
  });
  thread_.note();
  thread_.flush();
}

}  // namespace incision

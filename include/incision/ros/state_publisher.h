#pragma once

#include <incision/BodyState.h>
#include <ros/node_handle.h>

#include <cstdint>
#include <memory>

#include "incision/body/state_view.h"
#include "incision/ros/publishing_thread.h"

namespace incision {

/// Publishes the state of a body, in order. The stepping thread only copies the motion; hash and energies, which take
/// all of the body, are reckoned on a thread of its own. That assembles a copy of the mesh first, which takes longer
/// than these and could not keep up while each step cuts: so it does when the topology has stayed for some states, and
/// those until then are reckoned at once.
class StatePublisher {
 public:
  /// The body must outlive this.
  StatePublisher(ros::NodeHandle& node, const DeformableBody& body);

  /// Whether somebody listens.
  bool wanted() const { return publisher_.getNumSubscribers() > 0; }

  /// Publishes what `state` says, which is used up, and what it says of the body itself, as that now is after
  /// `last_step`.
  void give(const StepResult& last_step, BodyState* state);

 private:
  /// What is still to be reckoned.
  struct Draft {
    BodyState message;
    std::int64_t steps = 0, unsettled_steps = 0;
    BodyCounts counts;
    StepResult step;  // its numbers
    Vec3 gravity = Vec3::Zero();
    Motion motion;
    std::shared_ptr<const CutMesh> mesh;  // none: nothing is
  };
  struct Topic : Sender {
    Topic(const ros::Publisher& of_topic, const DeformableBody& body, std::size_t most);
    void send() override;
    void finish(Draft* draft);

    ros::Publisher publisher;
    const Materials materials;
    const BodySettings settings;
    MessageQueue<Draft> queue;
    std::unique_ptr<StateView> view;
  };
  const std::shared_ptr<const CutMesh>& calmMesh();

  const DeformableBody& body_;
  ros::Publisher publisher_;
  std::shared_ptr<Topic> topic_;
  std::shared_ptr<const CutMesh> mesh_;  // as it is, once it has stayed
  std::uint64_t version_ = 0;            // of the topology
  int states_ = 0;                       // given since it changed
  PublishingThread thread_;
};

}  // namespace incision

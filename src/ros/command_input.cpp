#include "incision/ros/command_input.h"

namespace incision {
namespace {

ros::NodeHandle withQueue(ros::NodeHandle node, ros::CallbackQueue& queue) {
  node.setCallbackQueue(&queue);
  return node;
}

}  // namespace

CommandInput::CommandInput(ros::NodeHandle& node, const NodeSettings& settings, const DeformableBody& body,
                           Answers& answers, Wakeup& wakeup)
    : listener_(buffer_, node),
      frames_(buffer_, settings.scene.body.frame),
      commands_(commandSettings(settings.scene, ros::Time::isSimTime(), settings.transform_timeout), frames_, answers,
                wakeup),
      messages_(body, commands_, answers),
      spinner_(1, &callbacks_) {
  ros::NodeHandle commands = withQueue(node, callbacks_);
  messages_.forEachTopic([&](const std::string& topic, const auto& receive) { subscribe(commands, topic, receive); });
  poll_ = commands.createWallTimer(
      ros::WallDuration(TRANSFORM_POLL),
      [this](const ros::WallTimerEvent&) {
        try {
          commands_.poll(steadyNow());
        } catch (const std::bad_alloc&) {  // looked at again at the next poll
        }
        if (!commands_.waitForTransforms()) poll_.stop();
      },
      false, false);
  spinner_.start();
}

template <class Message>
void CommandInput::subscribe(ros::NodeHandle& node, const std::string& topic, const Receiver<Message>& receive) {
  subscribers_.push_back(node.subscribe<Message>(
      topic, MESSAGE_QUEUE,
      [this, receive](const boost::shared_ptr<const Message>& message) {
        receive(*message, steadyNow());  // which answers what it has no memory for
        if (commands_.waitForTransforms()) poll_.start();
      },
      ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay()));
}

void CommandInput::close(const Refused& refused) {
  spinner_.stop();
  callbacks_.callAvailable();
  subscribers_.clear();
  commands_.refuseAll(refused);
}

}  // namespace incision

#pragma once

#include <ros/message_traits.h>
#include <rosbag/message_instance.h>

#include <functional>
#include <string>

#include "incision/ros/bag/bag_message.h"
#include "incision/ros/command_messages.h"

namespace incision {

/// A topic that is looked for in a bag.
struct BagTopic {
  std::string name, type, md5sum;
  bool of_scene;  ///< something of the scene hangs on it, and not the clock alone
  /// Reads a message; throws where it is damaged. The receiver is called only where there is a time of receipt.
  std::function<void(const rosbag::MessageInstance&, const SteadyTime* received)> read;
};

/// A topic of which each message goes to a receiver.
template <class Message>
BagTopic bagTopic(const std::string& name, bool of_scene, const Receiver<Message>& receive) {
  return {name, ros::message_traits::DataType<Message>::value(), ros::message_traits::MD5Sum<Message>::value(),
          of_scene, [receive](const rosbag::MessageInstance& instance, const SteadyTime* received) {
            const Message message = readMessage<Message>(instance);
            if (received != nullptr) receive(message, *received);
          }};
}

}  // namespace incision

#pragma once

#include <ros/serialization.h>
#include <rosbag/bag.h>
#include <rosbag/message_instance.h>
#include <sensor_msgs/JointState.h>
#include <tf2_msgs/TFMessage.h>

#include <cstdint>
#include <vector>

namespace incision {

using Bytes = std::vector<std::uint8_t>;

/// The bytes of a message. Throws rosbag::BagException where they cannot be read.
Bytes bytesOf(const rosbag::MessageInstance& instance);

/// Throws where the bytes are fewer than the lengths in them say: ROS makes room for these before it looks. Only
/// messages with lists need it.
void checkLengths(const Bytes& bytes, const sensor_msgs::JointState*);
void checkLengths(const Bytes& bytes, const tf2_msgs::TFMessage*);
inline void checkLengths(const Bytes&, const void*) {}

/// Reads a message of which the type has been checked. Throws a std::exception where it is damaged.
template <class Message>
Message readMessage(const rosbag::MessageInstance& instance) {
  Bytes bytes = bytesOf(instance);
  checkLengths(bytes, static_cast<const Message*>(nullptr));
  Message message;
  ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::deserialize(stream, message);
  return message;
}

}  // namespace incision

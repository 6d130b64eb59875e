#include "incision/ros/bag/bag_message.h"

#include <gtest/gtest.h>

namespace incision {
namespace {

template <class Message>
Bytes bytesOf(const Message& message) {
  Bytes bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

/// Whether the lengths in the bytes are refused.
template <class Message>
bool refused(const Bytes& bytes) {
  try {
    checkLengths(bytes, static_cast<const Message*>(nullptr));
    return false;
  } catch (const std::exception&) {
    return true;
  }
}

/// No list may take more room than its message: of a message cut short, or with any of its bytes made as large as can
/// be, what is read must fit.
template <class Message, class Entries>
void expectNoMoreThanTheBytes(const Message& message, const Entries& entries) {
  const Bytes good = bytesOf(message);
  EXPECT_FALSE(refused<Message>(good));
  EXPECT_TRUE(refused<Message>(Bytes()));
  int large = 0;
  for (std::size_t i = 0; i < good.size(); ++i) {
    Bytes bytes = good;
    bytes[i] = 0xFF;
    if (refused<Message>(bytes)) {
      ++large;
      continue;
    }
    Message read;
    ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
    try {
      ros::serialization::deserialize(stream, read);
      EXPECT_LE(entries(read), good.size());
    } catch (const ros::serialization::StreamOverrunException&) {  // of a text, for which no room is made before
    }
  }
  EXPECT_GE(large, 4);
}

TEST(BagMessage, AJawsMessageHasNoLongerListsThanBytes) {
  sensor_msgs::JointState message;
  message.header.frame_id = "body";
  message.name = {"jaw", "other"};
  message.position = {0.1, 0.2};
  message.effort = {3};
  expectNoMoreThanTheBytes(message, [](const sensor_msgs::JointState& read) {
    return read.name.size() + read.position.size() + read.velocity.size() + read.effort.size();
  });
}

TEST(BagMessage, TransformsAreNoMoreThanTheirBytes) {
  tf2_msgs::TFMessage message;
  message.transforms.resize(3);
  for (auto& transform : message.transforms) transform.child_frame_id = "hand";
  expectNoMoreThanTheBytes(message, [](const tf2_msgs::TFMessage& read) { return read.transforms.size(); });
}

}  // namespace
}  // namespace incision

// Where memory runs out in giving or sending messages, those that were given arrive all the same: whole, once, in
// order.
#include <gtest/gtest.h>
#include <ros/serialization.h>
#include <sensor_msgs/JointState.h>

#include <atomic>
#include <chrono>
#include <new>
#include <string>
#include <thread>

#include "incision/ros/publishing_thread.h"
#include "support/allocation_count.h"

namespace incision::test {
namespace {

using sensor_msgs::JointState;

constexpr std::size_t MOST = 8;

/// As a topic with a subscriber, but for the connection.
class Line : public Sender {
 public:
  void send() override {
    if (!open_) return;
    queue_.sendAll([this](const JointState& message) {
      const ros::SerializedMessage bytes = ros::serialization::serializeMessage(message);
      received_.emplace_back(bytes.buf.get(), bytes.buf.get() + bytes.num_bytes);
      ++arrived_;
    });
  }
  void give(int number) {
    queue_.give([&](JointState* message) {
      message->name.assign(3, "the joint of a message with the number " + std::to_string(number));
      message->position.assign(100, number);
    });
  }
  /// Numbers of what has come, each of which must be whole.
  std::vector<int> numbers() const {
    std::vector<int> list;
    for (const std::vector<std::uint8_t>& bytes : received_) {
      JointState message;
      ros::serialization::IStream stream(const_cast<std::uint8_t*>(bytes.data()) + 4,
                                         static_cast<std::uint32_t>(bytes.size()) - 4);
      ros::serialization::deserialize(stream, message);
      list.push_back(static_cast<int>(message.position.at(0)));
      const std::vector<double> same(100, list.back());
      EXPECT_EQ(message.position, same);
      EXPECT_EQ(message.name,
                std::vector<std::string>(3, "the joint of a message with the number " + std::to_string(list.back())));
    }
    return list;
  }
  int arrived() const { return arrived_; }
  /// From then on it sends.
  void open() { open_ = true; }

 private:
  MessageQueue<JointState> queue_{MOST};
  std::vector<std::vector<std::uint8_t>> received_;
  std::atomic<int> arrived_ = 0;
  std::atomic<bool> open_ = false;
};

/// Gives messages, tries to send them in between, and refuses some of what that takes. Returns how many were refused.
std::int64_t refuse(std::int64_t n, std::int64_t count) {
  PublishingThread thread;
  const auto line = std::make_shared<Line>();
  line->open();
  thread.add(line);
  std::vector<int> given;
  given.reserve(MOST);
  const auto trying = [](const auto& call) {
    try {
      call();
      return true;
    } catch (const std::bad_alloc&) {
      return false;
    }
  };
  const std::int64_t refused = refusing(n, count, [&] {
    for (int number = 0; number < static_cast<int>(MOST); ++number) {
      if (trying([&] { line->give(number); })) given.push_back(number);
      if (number % 3 == 2) trying([&] { thread.sendAll(); });
    }
  });
  thread.sendAll();
  EXPECT_EQ(line->numbers(), given) << "number " << n;
  return refused;
}

TEST(PublishingWithoutMemory, LosesNoMessageThatWasGiven) {
  for (const std::int64_t count : {1, 20}) {
    std::int64_t n = 1;
    while (refuse(n, count) > 0 && !HasFailure()) ++n;
    EXPECT_GT(n, 20);
  }
}

TEST(PublishingWithoutMemory, IsTriedAgainByTheThreadItself) {
  std::int64_t refused = 1, n = 1;
  for (; refused > 0; n += 7) {
    PublishingThread thread;
    const auto line = std::make_shared<Line>();
    thread.add(line);
    for (int number = 0; number < static_cast<int>(MOST); ++number) line->give(number);
    refused = refusing(n, 2, [&] {
      line->open();
      thread.note();
      thread.flush();
      const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
      while (line->arrived() < static_cast<int>(MOST) && std::chrono::steady_clock::now() < deadline)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    });
    EXPECT_EQ(line->numbers(), (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7})) << "number " << n;
  }
  EXPECT_GT(n, 15);
}

}  // namespace
}  // namespace incision::test

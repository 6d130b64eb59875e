#include "incision/pace/message_queue.h"

#include <gtest/gtest.h>

#include <string>
#include <thread>

namespace incision {
namespace {

template <class Message>
std::vector<Message> sent(MessageQueue<Message>* queue) {
  std::vector<Message> all;
  queue->sendAll([&](const Message& message) { all.push_back(message); });
  return all;
}

void give(MessageQueue<int>* queue, int from, int to) {
  for (int i = from; i < to; ++i) queue->give([&](int* message) { *message = i; });
}

TEST(MessageQueue, KeepsTheOrder) {
  MessageQueue<int> queue(MessageQueue<int>::ALL);
  give(&queue, 0, 3);
  EXPECT_EQ(sent(&queue), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(sent(&queue), std::vector<int>());
  give(&queue, 3, 5);
  EXPECT_EQ(sent(&queue), (std::vector<int>{3, 4}));
}

TEST(MessageQueue, LosesTheOldestAlone) {
  MessageQueue<int> queue(3);
  for (int round = 0; round < 3; ++round) {
    give(&queue, 0, 8);
    EXPECT_EQ(sent(&queue), (std::vector<int>{5, 6, 7}));
  }
}

TEST(MessageQueue, LosesNothingBetweenThreads) {
  constexpr int COUNT = 20000;
  MessageQueue<int> queue(MessageQueue<int>::ALL);
  std::thread giver([&] { give(&queue, 0, COUNT); });
  std::vector<int> all;
  while (all.size() < COUNT) {
    const std::vector<int> some = sent(&queue);
    all.insert(all.end(), some.begin(), some.end());
  }
  giver.join();
  for (int i = 0; i < COUNT; ++i) ASSERT_EQ(all[static_cast<std::size_t>(i)], i);
}

// A message's own memory is used again.
TEST(MessageQueue, WritesOverOlderMessages) {
  MessageQueue<std::string> queue(10);
  const std::string text(100, 'x');
  const auto giveText = [&](const char** at) {
    queue.give([&](std::string* message) {
      message->assign(text);
      *at = message->data();
    });
  };
  const char *first = nullptr, *second = nullptr, *third = nullptr;
  giveText(&first);
  sent(&queue);
  giveText(&second);
  sent(&queue);
  giveText(&third);
  EXPECT_EQ(first, third);
}

TEST(MessageQueue, LosesNothingWhereMemoryRunsOut) {
  MessageQueue<int> queue(10);
  give(&queue, 0, 2);
  EXPECT_THROW(queue.give([](int*) { throw std::bad_alloc(); }), std::bad_alloc);
  give(&queue, 2, 5);
  std::vector<int> sent;
  const auto send = [&](int message) {
    if (message == 3 && sent.back() == 2 && sent.size() == 3) {
      sent.push_back(-1);  // this trial
      throw std::bad_alloc();
    }
    sent.push_back(message);
  };
  EXPECT_THROW(queue.sendAll(send), std::bad_alloc);
  give(&queue, 5, 6);
  queue.sendAll(send);
  EXPECT_EQ(sent, (std::vector<int>{0, 1, 2, -1, 3, 4, 5}));
}

}  // namespace
}  // namespace incision

#pragma once

#include <ros/publisher.h>

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "incision/pace/message_queue.h"
#include "incision/pace/wakeup.h"

namespace incision {

/// Something with messages to send.
class Sender {
 public:
  virtual ~Sender() = default;
  /// Sends all that wait. Called by one thread at a time.
  virtual void send() = 0;
};

/// Publishes for threads that have better to do. roscpp serialises a message, and wakes the thread that writes it to
/// connections, on the thread that publishes it.
class PublishingThread {
 public:
  PublishingThread();
  /// Sends what still waits.
  ~PublishingThread();

  void add(const std::shared_ptr<Sender>& sender);

  /// Sends what still waits at once, on the thread that calls it. What std::bad_alloc keeps from being sent waits on.
  void sendAll();

  /// There is something to send, after the next flush.
  void note() { noted_.store(true, std::memory_order_relaxed); }
  /// Has it sent what was given. To wake a thread is dearer than to give a message, so those of a step do it together.
  void flush() {
    if (noted_.exchange(false, std::memory_order_relaxed)) wakeup_.notify();
  }

 private:
  void run();
  bool trySendAll();

  std::mutex mutex_;
  std::vector<std::shared_ptr<Sender>> senders_;
  std::atomic<bool> noted_ = false, stopping_ = false;
  Wakeup wakeup_;
  std::thread thread_;
};

/// The messages of a topic, given to a PublishingThread.
template <class Message>
class Outlet {
 public:
  /// No topic: nothing is wanted.
  Outlet() = default;
  /// As a MessageQueue of up to `most`. The thread must outlive this.
  Outlet(PublishingThread* thread, ros::Publisher publisher, std::size_t most)
      : thread_(thread), topic_(std::make_shared<Topic>(std::move(publisher), most)) {
    thread_->add(topic_);
  }

  /// Whether somebody listens.
  bool wanted() const { return topic_ && topic_->publisher.getNumSubscribers() > 0; }

  /// `fill(Message*)` writes a message over an older one. It is sent after the thread's next flush. Thread-safe; waits
  /// for no connection.
  template <class Fill>
  void give(const Fill& fill) {
    topic_->queue.give(fill);
    thread_->note();
  }

 private:
  struct Topic : Sender {
    Topic(ros::Publisher of_topic, std::size_t most) : publisher(std::move(of_topic)), queue(most) {}
    void send() override {
      queue.sendAll([this](const Message& message) { publisher.publish(message); });
    }

    const ros::Publisher publisher;
    MessageQueue<Message> queue;
  };

  PublishingThread* thread_ = nullptr;
  std::shared_ptr<Topic> topic_;
};

}  // namespace incision

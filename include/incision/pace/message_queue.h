#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <mutex>
#include <utility>
#include <vector>

namespace incision {

/// Messages on their way from threads that must not wait to one that sends them, in the order in which they were given.
/// Messages are written over older ones, so that giving one that has no more in it than those before allocates nothing.
template <class Message>
class MessageQueue {
 public:
  /// However many wait.
  static constexpr std::size_t ALL = std::numeric_limits<std::size_t>::max();

  /// Up to `most` wait; beyond that the oldest is lost.
  explicit MessageQueue(std::size_t most) : most_(most) {}

  /// `fill(Message*)` writes a message over an older one. Any thread; waits for none that sends. Where it throws, there
  /// is no message more.
  template <class Fill>
  void give(const Fill& fill) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (count_ == most_) {
      std::rotate(waiting_.begin(), waiting_.begin() + 1, waiting_.end());
      --count_;
    }
    if (count_ == waiting_.size()) waiting_.emplace_back();
    fill(&waiting_[count_]);
    ++count_;
  }

  /// Calls send(message) for all that wait, which it may change. Where it throws, that message is the first of those
  /// that are sent next time. By one thread at a time.
  template <class Send>
  void sendAll(const Send& send) {
    sendTaken(send);
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      std::swap(waiting_, sending_);
      taken_ = std::exchange(count_, 0);
      next_ = 0;
    }
    sendTaken(send);
  }

 private:
  template <class Send>
  void sendTaken(const Send& send) {
    for (; next_ < taken_; ++next_) send(sending_[next_]);
  }

  const std::size_t most_;
  std::mutex mutex_;
  std::vector<Message> waiting_, sending_;  // the first `count_` of those that wait are new
  std::size_t count_ = 0;
  std::size_t next_ = 0, taken_ = 0;  // of those that are sent
};

}  // namespace incision

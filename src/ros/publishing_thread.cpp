#include "incision/ros/publishing_thread.h"

namespace incision {
namespace {

/// How long to wait for memory where there was none for a message.
constexpr std::chrono::milliseconds PAUSE(100);

}  // namespace

PublishingThread::PublishingThread() : thread_([this] { run(); }) {}

PublishingThread::~PublishingThread() {
  stopping_ = true;
  wakeup_.notify();
  thread_.join();
}

void PublishingThread::add(const std::shared_ptr<Sender>& sender) {
  const std::lock_guard<std::mutex> lock(mutex_);
  senders_.push_back(sender);
}

void PublishingThread::sendAll() {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& sender : senders_) sender->send();
}

void PublishingThread::run() {
  while (!stopping_) {
    const bool sent = trySendAll();
    wakeup_.waitUntil(sent ? SteadyTime::max() : steadyNow() + PAUSE);
  }
  trySendAll();
}

bool PublishingThread::trySendAll() {
  try {
    sendAll();
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

}  // namespace incision

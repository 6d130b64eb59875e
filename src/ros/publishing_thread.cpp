#include "incision/ros/publishing_thread.h"

namespace incision {

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
    sendAll();
    wakeup_.waitUntil(SteadyTime::max());
  }
  sendAll();
}

}  // namespace incision

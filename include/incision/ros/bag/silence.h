#pragma once

#include <console_bridge/console.h>

namespace incision {

/// While it lives, rosbag and tf say nothing by themselves: what there is to say is said once, by those who use them.
class Silence {
 public:
  Silence() : level_(console_bridge::getLogLevel()) {
    console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_NONE);
  }
  ~Silence() { console_bridge::setLogLevel(level_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  const console_bridge::LogLevel level_;
};

}  // namespace incision

#pragma once

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "incision/ros/bag/bag_topic.h"

namespace incision {

/// A time of recording, taken for one of a clock that never jumps.
inline SteadyTime toSteady(Nanoseconds time) { return SteadyTime(std::chrono::nanoseconds(time)); }

/// Reads the messages of a bag in the order in which they were recorded. Times are those of recording.
class BagReader {
 public:
  /// Opens the bag and reads it once to its end. Throws InputError, with the file and what is wrong, where it is no
  /// whole bag, has none of the topics, or one of another type.
  BagReader(const std::string& path, const std::vector<BagTopic>& topics);

  /// Of the first and the last message, whatever its topic, by which `rosbag play --clock` has its clock start and end.
  Nanoseconds begin() const { return begin_; }
  Nanoseconds end() const { return end_; }
  /// Whether it has messages of this topic.
  bool has(const std::string& topic) const;

  /// When the next message was recorded; the end of time after the last.
  SteadyTime next() const;
  /// Gives the next message to its receiver. Throws InputError where it cannot be read any more.
  void deliver();
  /// Messages delivered so far.
  std::int64_t delivered() const { return delivered_; }

 private:
  void open();
  void find(rosbag::View& all);
  void read(const rosbag::MessageInstance& message, const SteadyTime* received) const;
  void readAll();

  const std::string path_;
  const std::vector<BagTopic> topics_;
  rosbag::Bag bag_;
  std::map<std::string, const BagTopic*> found_;  ///< by the bag's names
  std::unique_ptr<rosbag::View> view_;
  rosbag::View::iterator at_;
  Nanoseconds begin_ = 0, end_ = 0;
  std::int64_t delivered_ = 0;
};

}  // namespace incision

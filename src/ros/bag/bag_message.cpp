#include "incision/ros/bag/bag_message.h"

#include <cstring>
#include <stdexcept>

namespace incision {
namespace {

/// Bytes of a transform with empty names.
constexpr std::size_t LEAST_TRANSFORM = 76;

/// Of a header before its frame: seq and stamp.
constexpr std::size_t HEADER_START = 12;

/// Walks through a message.
class Cursor {
 public:
  explicit Cursor(const Bytes& bytes) : bytes_(bytes) {}

  void skip(std::size_t count) {
    if (count > bytes_.size() - at_) throw std::length_error("a message is shorter than it says");
    at_ += count;
  }

  /// How many entries a list has, which take at least so many bytes each.
  std::size_t count(std::size_t least) {
    const std::size_t start = at_;
    skip(sizeof(std::uint32_t));
    std::uint32_t count = 0;
    std::memcpy(&count, bytes_.data() + start, sizeof count);
    if (count > (bytes_.size() - at_) / least) throw std::length_error("a list is longer than its message");
    return count;
  }

 private:
  const Bytes& bytes_;
  std::size_t at_ = 0;
};

}  // namespace

Bytes bytesOf(const rosbag::MessageInstance& instance) {
  Bytes bytes(instance.size());
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  instance.write(stream);
  return bytes;
}

void checkLengths(const Bytes& bytes, const sensor_msgs::JointState*) {
  Cursor cursor(bytes);
  cursor.skip(HEADER_START);
  cursor.skip(cursor.count(1));
  for (std::size_t names = cursor.count(sizeof(std::uint32_t)); names > 0; --names) cursor.skip(cursor.count(1));
  for (int list = 0; list < 3; ++list) cursor.skip(sizeof(double) * cursor.count(sizeof(double)));
}

void checkLengths(const Bytes& bytes, const tf2_msgs::TFMessage*) { Cursor(bytes).count(LEAST_TRANSFORM); }

}  // namespace incision

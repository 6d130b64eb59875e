#include "incision/base/archive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "incision/base/input_error.h"
#include "incision/base/memory.h"

namespace incision {
namespace {

template <typename T>
std::string written(const T& value) {
  std::ostringstream bytes;
  ArchiveWriter archive(bytes);
  archive(value);
  return bytes.str();
}

template <typename T>
T readBack(const std::string& bytes) {
  ArchiveReader archive(bytes);
  T value;
  archive(value);
  return value;
}

TEST(Archive, ReadsMatricesAsTheyWereWritten) {
  const Eigen::Vector3d fixed(1.0 / 3, -0.0, std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(readBack<Eigen::Vector3d>(written(fixed)), fixed);
  EXPECT_TRUE(std::signbit(readBack<Eigen::Vector3d>(written(fixed)).y()));
  const Eigen::Matrix<float, 3, 4> many = Eigen::Matrix<float, 3, 4>::Random();
  EXPECT_EQ((readBack<Eigen::Matrix<float, 3, 4>>(written(many))), many);
  const Eigen::Quaterniond turn(0.1, 0.2, 0.3, 0.4);
  EXPECT_EQ(readBack<Eigen::Quaterniond>(written(turn)).coeffs(), turn.coeffs());
}

TEST(Archive, WritesEqualMapsAlike) {
  std::unordered_map<int, double> up, down(1000);
  for (int k = 0; k < 100; ++k) up[k] = down[99 - k] = 0;
  for (int k = 0; k < 100; ++k) up[k] = down[k] = 0.1 * k;
  EXPECT_EQ(written(up), written(down));
  EXPECT_EQ((readBack<std::unordered_map<int, double>>(written(up))), up);
}

TEST(Archive, ThrowsWhereBytesEndEarly) {
  const std::string bytes = written(std::vector<Eigen::Vector3d>(3, Eigen::Vector3d::Ones()));
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_THROW(readBack<std::vector<Eigen::Vector3d>>(bytes.substr(0, length)), InputError) << length;
}

// The first eight bytes of a list are its length, and one more comes before them.
TEST(Archive, MakesNoRoomForLengthsThatTheBytesCannotHold) {
  for (std::string bytes : {written(std::vector<double>{1}), written(std::vector<Eigen::Vector3d>(1, {1, 2, 3})),
                            written(std::string("text")), written(std::unordered_map<int, double>{{1, 2}})}) {
    for (int k = 1; k <= 8; ++k) bytes[k] = k <= 6 ? '\xff' : '\x00';
    EXPECT_THROW(readBack<std::vector<double>>(bytes), InputError);
    EXPECT_THROW(readBack<std::vector<Eigen::Vector3d>>(bytes), InputError);
    EXPECT_THROW(readBack<std::string>(bytes), InputError);
    EXPECT_THROW((readBack<std::unordered_map<int, double>>(bytes)), InputError);
  }
}

TEST(Archive, RefusesNumbersThatCannotBe) {
  constexpr double INF = std::numeric_limits<double>::infinity();
  EXPECT_THROW(readBack<double>(written(NAN)), InputError);
  EXPECT_THROW(readBack<std::vector<double>>(written(std::vector<double>{1, -INF})), InputError);
  EXPECT_THROW(readBack<Eigen::Vector3d>(written(Eigen::Vector3d(0, 0, INF))), InputError);
  EXPECT_THROW(readBack<bool>(written(std::uint8_t{2})), InputError);
  EXPECT_TRUE(readBack<bool>(written(true)));
}

TEST(Archive, RefusesAnotherOrderOfBytes) {
  std::string bytes = written(1.5);
  bytes[0] = static_cast<char>(1 - bytes[0]);
  EXPECT_THROW(readBack<double>(bytes), InputError);
}

struct Count {
  int count = 0;
};

template <class Archive>
void serialize(Archive& archive, Count& memory) {
  auto& [count] = memory;
  archive(count);
}

void check(const Count& memory, const MemoryLimits& limits) {
  require(memory.count <= limits.nodes, "it counts too far");
}

/// Something with a memory.
class Counter : public WithMemory<Remembers, Count> {
 public:
  void count() { ++memory_.count; }
  int counted() const { return memory_.count; }
};

TEST(Memory, IsRecalledAsItWasWritten) {
  Counter one, other;
  one.count();
  std::stringstream bytes;
  {
    ArchiveWriter archive(bytes);
    one.write(one.keep(), &archive);
  }
  one.count();
  const std::string written = bytes.str();
  EXPECT_THROW(
      {
        ArchiveReader archive(written);
        other.read(&archive);
      },
      InputError);
  ArchiveReader archive(written);
  archive.limits.nodes = 1;
  const std::any kept = other.read(&archive);
  EXPECT_EQ(other.counted(), 0);
  other.recall(kept);
  EXPECT_EQ(other.counted(), 1);
}

}  // namespace
}  // namespace incision

#include "incision/base/archive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

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
  std::istringstream in(bytes);
  ArchiveReader archive(in);
  T value;
  archive(value);
  return value;
}

TEST(Archive, ReadsMatricesAsTheyWereWritten) {
  const Eigen::Vector3d fixed(1.0 / 3, -0.0, std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(readBack<Eigen::Vector3d>(written(fixed)), fixed);
  EXPECT_TRUE(std::signbit(readBack<Eigen::Vector3d>(written(fixed)).y()));
  for (const int columns : {0, 1, 4}) {
    const Eigen::MatrixXf dynamic = Eigen::MatrixXf::Random(3, columns);
    EXPECT_EQ(readBack<Eigen::MatrixXf>(written(dynamic)), dynamic);
  }
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
    EXPECT_THROW(readBack<std::vector<Eigen::Vector3d>>(bytes.substr(0, length)), cereal::Exception) << length;
}

/// Something with a memory.
class Counter : public WithMemory<Remembers, int> {
 public:
  void count() { ++memory_; }
  int counted() const { return memory_; }
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
  ArchiveReader archive(bytes);
  const std::any kept = other.read(&archive);
  EXPECT_EQ(other.counted(), 0);
  other.recall(kept);
  EXPECT_EQ(other.counted(), 1);
}

}  // namespace
}  // namespace incision

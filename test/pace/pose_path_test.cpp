#include "incision/pace/pose_path.h"

#include <gtest/gtest.h>

#include <random>

#include "pace/things_in_tests.h"

namespace incision {
namespace {

const Edge EDGE = {Vec3(0, 0, -0.02), Vec3(0, 0, 0.05)};

Pose turnedAt(double x, double y = 0, double turn = 0) {
  return {Vec3(x, y, 0), Eigen::Quaterniond(Eigen::AngleAxisd(turn, Vec3::UnitX()))};
}

TEST(PosePath, TravelIsThatOfTheOriginOrAnEndWhicheverIsFarther) {
  EXPECT_NEAR(0.3, travel(turnedAt(0), turnedAt(0.3), EDGE), POSE_ROUNDING);
  EXPECT_NEAR(2 * 0.05 * std::sin(0.5), travel(turnedAt(0), turnedAt(0, 0, 1), EDGE), POSE_ROUNDING);
}

TEST(PosePath, AStraightEvenPathIsItsLastPose) {
  std::vector<Pose> path;
  for (int i = 1; i <= 100; ++i) path.push_back(turnedAt(1e-4 * i, 2e-4 * i, 1e-4 * i));
  const std::vector<Pose> kept = simplified(turnedAt(0), path, EDGE);
  ASSERT_EQ(1u, kept.size());
  EXPECT_EQ(path.back().position, kept[0].position);
}

TEST(PosePath, ACornerStays) {
  std::vector<Pose> path;
  for (int i = 1; i <= 50; ++i) path.push_back(turnedAt(1e-3 * i));
  for (int i = 1; i <= 50; ++i) path.push_back(turnedAt(0.05, 1e-3 * i));
  const std::vector<Pose> kept = simplified(turnedAt(0), path, EDGE);
  ASSERT_EQ(2u, kept.size());
  EXPECT_NEAR(0.05, kept[0].position.x(), 10 * PATH_TOLERANCE);  // the way turns within the tolerance
}

TEST(PosePath, AStandstillWithinAPathStays) {
  std::vector<Pose> path;
  for (int i = 1; i <= 10; ++i) path.push_back(turnedAt(1e-3 * i));
  for (int i = 1; i <= 10; ++i) path.push_back(turnedAt(1e-2));
  EXPECT_EQ(2u, simplified(turnedAt(0), path, EDGE).size());
}

/// Whatever the path, the tool passes every pose within the tolerance of every coordinate.
TEST(PosePath, EveryPoseLeftOutIsPassedAllTheSame) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise;
  for (int path_number = 0; path_number < 100; ++path_number) {
    std::vector<Pose> path = {turnedAt(0)};
    Vec3 speed = Vec3::Zero();
    for (int i = 0; i < 200; ++i) {
      for (double& s : speed) s += 1e-5 * noise(random);
      path.push_back({path.back().position + speed, Eigen::Quaterniond::Identity()});
    }
    const std::vector<Pose> rest(path.begin() + 1, path.end());
    const std::vector<Pose> kept = simplified(path[0], rest, EDGE);
    EXPECT_LT(kept.size(), rest.size());
    std::size_t last = 0;
    for (const Pose& pose : kept) {
      std::size_t next = last + 1;
      while (path[next].position != pose.position) ++next;
      for (std::size_t i = last; i < next; ++i) {
        const double share = static_cast<double>(i - last) / static_cast<double>(next - last);
        const Vec3 passed = between(path[last], pose, share).position;
        EXPECT_LE((passed - path[i].position).cwiseAbs().maxCoeff(), PATH_TOLERANCE + POSE_ROUNDING);
      }
      last = next;
    }
    EXPECT_EQ(path.size(), last + 1);
  }
}

TEST(PosePath, TheFrontAndTheRestAreTheWholeWay) {
  std::vector<Pose> way = {turnedAt(1), turnedAt(1, 3)};
  const std::vector<Pose> front = takeFront(0.5, turnedAt(0), EDGE, &way);
  ASSERT_EQ(2u, front.size());
  EXPECT_EQ(1, front[0].position.x());
  EXPECT_NEAR(1, front[1].position.y(), POSE_ROUNDING);
  ASSERT_EQ(1u, way.size());
  EXPECT_EQ(1u, takeFront(1, front[1], EDGE, &way).size());
  EXPECT_TRUE(way.empty());
}

TEST(PosePath, AWayOfNoLengthIsGoneAtOnce) {
  std::vector<Pose> way = {turnedAt(0), turnedAt(0)};
  EXPECT_EQ(2u, takeFront(0.1, turnedAt(0), EDGE, &way).size());
  EXPECT_TRUE(way.empty());
}

}  // namespace
}  // namespace incision

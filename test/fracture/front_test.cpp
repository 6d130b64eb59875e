#include "incision/fracture/front.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "support/random.h"

namespace incision::test {
namespace {

/// A front where the plane n·(x − p) = 0 crosses the face.
Front frontOfPlane(const std::array<Vec3, 3>& face, const Vec3& n, const Vec3& p) {
  Front front{face, Vec3::Zero(), n};
  for (int i = 0; i < 3; ++i) front.phi[i] = n.dot(face[i] - p);
  return front;
}

std::array<Vec3, 3> randomFace(Random* random) { return {random->vector(1), random->vector(1), random->vector(1)}; }

Vec3 inFace(const std::array<Vec3, 3>& face) { return 0.4 * face[0] + 0.35 * face[1] + 0.25 * face[2]; }

TEST(Front, ACrackThatNeedNotTurnGoesOnInItsPlane) {
  Random random(1);
  for (int k = 0; k < 200; ++k) {
    const auto face = randomFace(&random);
    const Vec3 n = random.direction(), p = inFace(face), beyond = random.vector(2);
    if (std::abs(n.dot((face[1] - face[0]).cross(face[2] - face[0]).normalized())) > 0.9) continue;  // along the face
    for (const Vec3& wanted : {n, Vec3(-n)})
      EXPECT_NEAR(phiBeyond(frontOfPlane(face, n, p), wanted, beyond), n.dot(beyond - p), 1e-10);
  }
}

TEST(Front, ACrackTurnsAboutItsLineOnTheFace) {
  Random random(2);
  const std::array<Vec3, 3> face = {Vec3(0, -1, -1), Vec3(0, 1, -1), Vec3(0, 0, 1)};  // across x
  for (int k = 0; k < 200; ++k) {
    const double from = random.uniform(-0.5, 0.5), turn = random.uniform(-0.7, 0.7);
    const auto normal = [](double angle) { return Vec3(std::sin(angle), 0, std::cos(angle)); };
    const Front front = frontOfPlane(face, normal(from), Vec3(0, 0, 0.2));
    // What the wanted normal has along the line cannot be met and must not matter.
    const Vec3 wanted = normal(from + turn) + Vec3(0, random.uniform(-1, 1), 0);
    const double angle = std::clamp(from + turn, from - MAX_TURN, from + MAX_TURN);
    const Vec3 on_plane = Vec3(0, 0, 0.2) + Vec3(std::cos(angle), random.uniform(-1, 1), -std::sin(angle));
    EXPECT_NEAR(phiBeyond(front, wanted, on_plane), 0, 1e-12);
  }
}

TEST(Front, ACrackNeverTurnsSharperThanItMay) {
  Random random(3);
  const std::array<Vec3, 3> face = {Vec3(0, -1, -1), Vec3(0, 1, -1), Vec3(0, 0, 1)};
  for (int k = 0; k < 500; ++k) {
    const Front front = frontOfPlane(face, Vec3::UnitZ(), Vec3(0, 0, 0.2));
    const Vec3 wanted = random.direction();
    const double rise = -(phiBeyond(front, wanted, Vec3(1, 0, 0.2)) - 0);  // of the crack's plane over one metre ahead
    EXPECT_LE(std::abs(std::atan(rise)), MAX_TURN + 1e-12);
  }
}

TEST(Front, ItsMiddleLiesOnTheCrackAndHeadsForAPoint) {
  Random random(4);
  for (int k = 0; k < 200; ++k) {
    const auto face = randomFace(&random);
    const Vec3 n = random.direction(), p = inFace(face), point = random.vector(2);
    const Front front = frontOfPlane(face, n, p);
    EXPECT_NEAR(n.dot(middleOf(front) - p), 0, 1e-12);
    EXPECT_NEAR(normalTowards(front, point).normalized().dot(point - middleOf(front)), 0, 1e-10);
  }
}

}  // namespace
}  // namespace incision::test

// A piece that is driven faster and faster turns no farther in the shortest parts of a step than half a radian.
#include <gtest/gtest.h>

#include <cmath>

#include "support/given_springs.h"

namespace incision {
namespace {

constexpr double MOST_TURN = 0.5, DEFORMED = 1.2;

/// A stiff bar along x, and what turns it about z: a spring at each end with a force that stays as it is.
struct Driven {
  explicit Driven(double force) : rig(block({2, 1, 1}, Vec3(0.2, 0.1, 0.1)), settings()) {
    for (const double end : {0.0, 0.2}) {
      Spring spring;
      for (int c = 0; c < rig.mesh.numCopies(); ++c)
        if (std::abs(rig.motion.x[static_cast<std::size_t>(c)].x() - end) < 1e-9) spring.add(c, 0.25);
      EXPECT_EQ(spring.count, 4);
      spring.force = Vec3(0, end > 0 ? force : -force, 0);
      springs.push_back(spring);
    }
  }
  static RigSettings settings() {
    RigSettings settings;
    settings.material = {1e9, 0.3, 1000, 0, 0};
    return settings;
  }
  double fastest() const { return largest(rig.motion.v); }

  Rig rig;
  std::vector<Spring> springs;
};

TEST(FarTurn, OfAWholeStepIsThatOfItsShortestParts) {
  Driven driven(1e5);
  GivenSprings given(driven.springs);
  Couplers couplers({&given});
  const double radius = 0.5 * Vec3(0.2, 0.1, 0.1).norm(), shortest = driven.rig.time_step / (1 << MAX_HALVINGS);
  for (int k = 0; k < 10; ++k) {
    ASSERT_TRUE(advanceWith(&driven.rig, &couplers));
    EXPECT_LT(driven.fastest(), DEFORMED * MOST_TURN / shortest * radius) << k;
  }
}

}  // namespace
}  // namespace incision

// What an impact turns, or bends, may end where the step did not foresee it: it is in no obstacle all the same.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <vector>

#include "incision/contact/body_contact.h"
#include "support/contacts.h"
#include "support/given_springs.h"
#include "support/random.h"
#include "support/sanitized.h"

namespace incision {
namespace {

/// A bar that is turned at random and thrown at the ground.
struct Thrown {
  Thrown(double young_modulus, double time_step, double friction, test::Random* random)
      : rig(block({4, 2, 1}, test::ELEMENT * Vec3(4, 2, 1)), settings(young_modulus, time_step)),
        ground(groundWith(friction)),
        obstacles(loadObstacles(ground, "", "")),
        surface(rig.mesh),
        skin(surface, rig.materials, 1),
        contact(ground, obstacles, motions, &skin),
        couplers({&contact}) {
    couplers.changed(rig.mesh);
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(3, random->direction()));
    const Vec3 velocity(3 * random->vector(1).x(), 0, -20);
    for (Vec3& x : rig.motion.x) x = turn * x;
    const double lift = 0.02 - lowest();
    for (Vec3& x : rig.motion.x) x.z() += lift;
    rig.motion.v.assign(rig.motion.x.size(), velocity);
  }
  static RigSettings settings(double young_modulus, double time_step) {
    RigSettings settings;
    settings.material = {young_modulus, 0.3, 1000, 0, 0};
    settings.solver.time_step = time_step;
    return settings;
  }
  static ContactSettings groundWith(double friction) {
    ContactSettings settings;
    settings.ground = 0;
    settings.friction = friction;
    return settings;
  }
  double lowest() const {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& x : rig.motion.x) least = std::min(least, x.z());
    return least;
  }

  Rig rig;
  ContactSettings ground;
  Obstacles obstacles;
  std::vector<RigidMotion> motions;  // of the obstacles' links: there are none
  CurrentSurface surface;
  ContactSkin skin;
  BodyContact contact;
  Couplers couplers;
};

TEST(Tumbling, EndsNoStepFarInTheGround) {
  for (const double time_step : {0.005, 0.02})
    for (const double young_modulus : {1e6, 1e8})
      for (unsigned seed = 0; seed < (test::SANITIZED ? 2 : 20); ++seed) {
        test::Random random(seed);
        Thrown thrown(young_modulus, time_step, seed % 2 > 0 ? 0.5 : 0, &random);
        for (int k = 0; k < 6; ++k) {
          ASSERT_TRUE(advanceWith(&thrown.rig, &thrown.couplers));
          EXPECT_GT(thrown.lowest(), -0.15 * test::ELEMENT) << young_modulus << ", " << time_step << ", seed " << seed;
        }
      }
}

}  // namespace
}  // namespace incision

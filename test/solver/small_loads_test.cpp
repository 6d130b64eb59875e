#include <gtest/gtest.h>

#include "support/rig.h"

namespace incision {
namespace {

constexpr double TOLERANCE = 1e-6;

/// What a residual may do to the deflection of so slender and so uneven a beam.
constexpr double CONDITION = 100;

/// A cantilever of a soft layer on a stiff one, at rest, bent in one long step by a load on its end.
struct Layered : Rig {
  explicit Layered(double traction, Method method = Method::ITERATIVE)
      : Rig(block({40, 2, 4}, Vec3(1, 0.05, 0.1)), settings(traction, method)) {}

  static RigSettings settings(double traction, Method method) {
    RigSettings settings;
    settings.material = {1e4, 0.3, 1000, 0, 0};
    settings.regions.emplace_back();
    settings.regions[0].place = RestBox{Vec3(-1, -1, -1), Vec3(2, 2, 0.05)};
    settings.regions[0].young_modulus = 1e8;
    settings.conditions.clamps = {{slab(0, 0), Vec3::Zero()}};
    settings.conditions.loads = {{slab(0, 1), Vec3(0, 0, -traction), 0}};
    settings.warping = false;
    settings.solver = {1e3, method, TOLERANCE, 1};
    return settings;
  }
};

TEST(SmallLoads, AreOffByNoMoreThanTheResidualMayDo) {
  Layered large(1, Method::DIRECT);
  ASSERT_TRUE(large.advance());
  const double bent = largest(large.displacements());
  double residual = 0;
  for (double traction = 1; traction > 1e-9; traction /= 10) {
    Layered small(traction);
    ASSERT_TRUE(small.advance());
    residual = small.step.stats().residual;
    const double allowed = CONDITION * std::max(residual, TOLERANCE);
    EXPECT_NEAR(largest(small.displacements()) / (traction * bent), 1, allowed) << traction;
    if (traction == 1) {
      EXPECT_LT(residual, 10 * TOLERANCE);
    }
  }
  EXPECT_GT(residual, 0.5);
}

TEST(SmallLoads, OfNoneTheResidualIsThatOfRounding) {
  Layered rest(0);
  ASSERT_TRUE(rest.advance());
  EXPECT_LT(rest.step.stats().residual, TOLERANCE);
}

}  // namespace
}  // namespace incision

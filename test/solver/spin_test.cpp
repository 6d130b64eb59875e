// A piece in free flight turns as a rigid body does.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "incision/solver/rigid_pieces.h"
#include "support/random.h"
#include "support/rig.h"
#include "support/sanitized.h"

namespace incision {
namespace {

constexpr int STEPS = test::SANITIZED ? 100 : 1000;

Vec3 angularMomentum(const Rig& rig, int piece) {
  const std::vector<double>& masses = rig.step.assembly().masses();
  double mass = 0;
  Vec3 centre = Vec3::Zero(), sum = Vec3::Zero();
  for (std::size_t c = 0; c < masses.size(); ++c) {
    if (rig.step.pieceOf()[c] != piece) continue;
    mass += masses[c];
    centre += masses[c] * rig.motion.x[c];
  }
  centre /= mass;
  for (std::size_t c = 0; c < masses.size(); ++c)
    if (rig.step.pieceOf()[c] == piece) sum += masses[c] * (rig.motion.x[c] - centre).cross(rig.motion.v[c]);
  return sum;
}

// Thrown, spinning, and set swinging by up to `swing` [m/s].
void launch(test::Random* random, double swing, Rig* rig) {
  const Vec3 velocity = random->vector(1), rate = random->vector(15);
  for (std::size_t c = 0; c < rig->motion.x.size(); ++c)
    rig->motion.v[c] = velocity + rate.cross(rig->motion.x[c]) + random->vector(swing);
}

// The guess of what couplers do may strike a piece that nothing touches in the end: Δv then takes that back.
TEST(Spin, IsThatOfFreeFlightWhereOnlyTheGuessStruckAPiece) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    test::Random random(60 + seed);
    Rig rig(block({3, 1, 1}, Vec3(0.3, 0.1, 0.1)), RigSettings());
    launch(&random, 0, &rig);
    const Assembly& assembly = rig.step.assembly();
    RigidPieces rigid;
    rigid.topologyChanged(rig.step.pieceOf(), 1, rig.step.held(), true);
    StepBase base;
    rigid.euler(assembly, rig.motion, rig.time_step, &base);
    const StepBase free = base;

    const TurnLimits none = {INFINITY, INFINITY};
    const std::vector<Vec3> nothing(rig.motion.x.size(), Vec3::Zero());
    std::vector<Vec3> impulses = nothing, given, dv = nothing;
    impulses[0] = random.vector(5);  // it weighs 3 kg
    ASSERT_TRUE(rigid.kick(assembly, rig.motion.x, impulses, &base, &given, none));
    for (std::size_t c = 0; c < dv.size(); ++c) dv[c] = -given[c] / assembly.masses()[c];
    ASSERT_TRUE(rigid.takeChange(assembly, base, dv, nothing, rig.motion.x, none));
    Motion end = rig.motion;
    rigid.finish(base, dv, &end);
    double struck = 0;
    for (std::size_t c = 0; c < dv.size(); ++c) {
      struck = std::max(struck, (base.x[c] - free.x[c]).norm());
      EXPECT_LT((end.x[c] - free.x[c] - rig.time_step * free.u[c]).norm(), 1e-12);
      EXPECT_LT((end.v[c] - free.v[c] - free.u[c]).norm(), 1e-11);
    }
    EXPECT_GT(struck, 0.01);
  }
}

// What swings is stretched by the spin, and a step counts that with the arms it began with: of a stiff piece that is
// hardly anything.
TEST(Spin, OfStiffFreePiecesIsKeptForAThousandSteps) {
  for (unsigned seed = 0; seed < (test::SANITIZED ? 1 : 3); ++seed)
    for (const double young_modulus : {1e6, 1e8, 1e9})
      for (const double time_step : {1e-3, 1e-2, 4e-2}) {
        test::Random random(40 + seed);
        RigSettings settings;
        settings.material = {young_modulus, 0.3, 1000, 0, 0};
        settings.solver.time_step = time_step;
        Rig rig(block({3, 1, 1}, Vec3(0.3, 0.1, 0.1) + 0.1 * Vec3(seed, seed % 2, 0)), settings);
        rig.cut(plane(Vec3(0.17, 0.05, 0.05), random.direction()));
        ASSERT_EQ(rig.pieces(), 2);
        launch(&random, young_modulus < 1e9 ? 0 : 1e-3, &rig);
        const Vec3 first[] = {angularMomentum(rig, 0), angularMomentum(rig, 1)};
        for (int k = 1; k <= STEPS; ++k) {
          ASSERT_TRUE(rig.advance());
          if (k % 50 != 0) continue;
          for (const int piece : {0, 1})
            ASSERT_LT((angularMomentum(rig, piece) - first[piece]).norm(), 1e-9 * first[piece].norm())
                << "seed " << seed << ", E " << young_modulus << ", step " << k << " of " << time_step << " s";
        }
      }
}

}  // namespace
}  // namespace incision

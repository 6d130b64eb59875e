#include <gtest/gtest.h>

#include <algorithm>

#include "support/contacts.h"
#include "support/sanitized.h"

namespace incision::test {
namespace {

/// Blocks that four random planes cut to pieces as they fall on the ground from a millimetre above it: chaotic motion,
/// so a law is one of many runs.
struct Ensemble {
  Ensemble(double E, double dt, double mu) : young_modulus(E), time_step(dt), friction(mu) {}

  double young_modulus, time_step, friction;
  int steps = 0, rises = 0, unsettled = 0;
  double highest = 0;
  std::vector<int> solves;

  void run(unsigned seed, int count) {
    Scene scene = fallingToPieces(young_modulus, 3, 4, seed);
    scene.solver = {time_step, Method::AUTO, 1e-6, 1};
    scene.contact->friction = friction;
    DeformableBody body(scene, loadMesh(scene));
    const double whole = energyOf(body, 0);
    double last = whole;
    for (int k = 0; k < count; ++k) {
      const StepResult step = body.step();
      const double now = energyOf(body, step.contact.energy);
      ++steps;
      unsettled += !step.settled;
      rises += step.settled && now > last + 1e-6 * whole;
      highest = std::max(highest, now / whole);
      solves.push_back(step.solves);
      last = now;
    }
    EXPECT_GT(body.counts().pieces, 8) << seed;
  }

  static double energyOf(const DeformableBody& body, double springs) {
    const BodyMotion motion = body.motion();
    return motion.kinetic_energy + motion.elastic_energy + motion.potential_energy + springs;
  }

  int quantile(double share) {
    std::sort(solves.begin(), solves.end());
    return solves[static_cast<std::size_t>(share * static_cast<double>(solves.size() - 1))];
  }
};

class Falling : public ::testing::TestWithParam<double> {};

// A piece that turns by a radian in a step may still gain some by friction: a step in some thousands.
TEST_P(Falling, PiecesSettleAndGainNoEnergyHoweverStiff) {
  for (const double friction : {0.0, 0.3}) {
    Ensemble ensemble(GetParam(), 0.01, friction);
    for (unsigned seed = 0; seed < (SANITIZED ? 1 : 3); ++seed) ensemble.run(seed, SANITIZED ? 10 : 30);
    EXPECT_LE(200 * ensemble.rises, ensemble.steps) << friction;
    EXPECT_LE(100 * ensemble.unsettled, ensemble.steps) << friction;
    EXPECT_LT(ensemble.highest, 1.02) << friction;
    EXPECT_LE(ensemble.quantile(0.95), 15) << friction;
  }
}

INSTANTIATE_TEST_SUITE_P(Stiffness, Falling, ::testing::Values(1e4, 1e6, 1e9));

TEST(FullFalling, PiecesSettleAndGainNoEnergyHoweverStiff) {
  for (const double young_modulus : {1e4, 1e6, 1e9})
    for (const double time_step : {0.001, 0.01}) {
      Ensemble ensemble(young_modulus, time_step, 0.3);
      for (unsigned seed = 0; seed < 20; ++seed) ensemble.run(seed, 60);
      EXPECT_LE(500 * ensemble.rises, ensemble.steps) << young_modulus << ' ' << time_step;
      EXPECT_LE(200 * ensemble.unsettled, ensemble.steps) << young_modulus << ' ' << time_step;
      EXPECT_LT(ensemble.highest, 1.05) << young_modulus << ' ' << time_step;
      EXPECT_LE(ensemble.quantile(0.5), 8) << young_modulus << ' ' << time_step;
      EXPECT_LE(ensemble.quantile(0.99), 25) << young_modulus << ' ' << time_step;
    }
}

}  // namespace
}  // namespace incision::test

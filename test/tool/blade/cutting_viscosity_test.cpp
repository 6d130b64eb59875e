#include <gtest/gtest.h>

#include <vector>

#include "support/pushed_blade.h"
#include "support/sanitized.h"

namespace incision {
namespace {

constexpr double SLOW_FORCE = 100;  // [N/m]
constexpr double VISCOSITY = 400;   // [N s/m²]

Scene viscousBlock(double force, double viscosity) {
  Scene scene = blockAndEdge(3, force);
  bladeOf(&scene.tools[0]).cutting.resistance.viscosity = viscosity;
  return scene;
}

TEST(CuttingViscosity, ASteadyCutTakesTheCuttingForceAndTheViscosityTimesTheSpeed) {
  const std::vector<double> speeds = test::SANITIZED ? std::vector<double>{0.2} : std::vector<double>{0.02, 0.1, 0.4};
  for (const double force : {0.0, SLOW_FORCE})
    for (const double speed : speeds) {
      Pushed pushed(viscousBlock(force, VISCOSITY));
      pushed.to(0.08, speed);
      const double wanted = (force + VISCOSITY * speed) * BLOCK_HEIGHT;
      for (const double x : {0.088, 0.1, 0.112}) {
        pushed.to(x, speed);
        EXPECT_NEAR(pushed.report.force.x(), -wanted, 0.05 * wanted) << force << " " << speed << " " << x;
      }
    }
}

TEST(CuttingViscosity, TheWorkIsTheAreaTimesWhatCuttingTakesAtThatSpeed) {
  const double speed = 0.1, wanted = SLOW_FORCE + VISCOSITY * speed;
  Pushed pushed(viscousBlock(SLOW_FORCE, VISCOSITY));
  pushed.to(0.04, speed);
  const double work = pushed.work, energy = pushed.energy(), area = pushed.report.stroke_area;
  pushed.to(0.13, speed);
  const double spent = pushed.work - work - (pushed.energy() - energy), cut = pushed.report.stroke_area - area;
  EXPECT_NEAR(spent, wanted * cut, 0.03 * wanted * cut);
}

TEST(CuttingViscosity, WhereTheEdgeStopsTheForceFallsToTheCuttingForceAndNoFarther) {
  Scene scene = viscousBlock(SLOW_FORCE, VISCOSITY);
  scene.body.material.stiffness_damping = 0.05;  // so that what is pressed does not swing back
  Pushed pushed(scene);
  pushed.to(0.08, 0.4);
  EXPECT_GT(-pushed.report.force.x(), 1.8 * SLOW_FORCE * BLOCK_HEIGHT);
  for (int k = 0; k < 300; ++k) pushed.report = pushed.body.step().tools[0];
  EXPECT_NEAR(-pushed.report.force.x(), SLOW_FORCE * BLOCK_HEIGHT, 0.03 * SLOW_FORCE * BLOCK_HEIGHT);
}

TEST(CuttingViscosity, GoingBackItIsFree) {
  Pushed pushed(viscousBlock(SLOW_FORCE, VISCOSITY));
  pushed.to(0.08, 0.1);
  pushed.to(0.065, 0.05);  // the tissue has sprung back
  pushed.most = 0;
  pushed.to(-0.02, 0.4);
  EXPECT_LT(pushed.most, 1e-9 * SLOW_FORCE);
}

TEST(CuttingViscosity, TheLengthOfAStepCountsForNothing) {
  double forces[2];
  for (const int refined : {0, 1}) {
    Scene scene = viscousBlock(SLOW_FORCE, VISCOSITY);
    scene.solver.time_step /= refined ? 4 : 1;
    Pushed pushed(scene);
    pushed.to(0.1, 0.2);
    forces[refined] = pushed.report.force.x();
  }
  EXPECT_NEAR(forces[1], forces[0], 0.03 * std::abs(forces[0]));
}

TEST(CuttingViscosity, AsItVanishesSoDoesWhatItDoes) {
  Pushed without(viscousBlock(SLOW_FORCE, 0)), vanishing(viscousBlock(SLOW_FORCE, 1e-9));
  for (const double x : {-0.001, 0.01, 0.03, 0.06}) {
    without.to(x, 0.1);
    vanishing.to(x, 0.1);
    EXPECT_NEAR(vanishing.report.force.x(), without.report.force.x(), 1e-6 * SLOW_FORCE * BLOCK_HEIGHT) << x;
  }
}

TEST(CuttingViscosity, ARegionMayHaveAnother) {
  Scene scene = viscousBlock(SLOW_FORCE, 0);
  RegionSettings thick;
  thick.place = {Vec3(0.08, -1, -1), Vec3(0.14, 1, 1)};
  thick.cutting_viscosity = VISCOSITY;
  scene.body.regions = {thick};
  Pushed pushed(scene);
  pushed.to(0.05, 0.2);
  EXPECT_NEAR(pushed.report.force.x(), -SLOW_FORCE * BLOCK_HEIGHT, 0.03 * SLOW_FORCE * BLOCK_HEIGHT);
  pushed.to(0.11, 0.2);
  const double wanted = (SLOW_FORCE + VISCOSITY * 0.2) * BLOCK_HEIGHT;
  EXPECT_NEAR(pushed.report.force.x(), -wanted, 0.05 * wanted);
}

}  // namespace
}  // namespace incision

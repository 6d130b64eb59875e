#include "incision/body/stress_view.h"

#include <gtest/gtest.h>

#include "support/cuts.h"
#include "support/scenes.h"

namespace incision::test {
namespace {

Scene barInTwoRegions(Pressure pressure) {
  Scene scene = swingingBar({8, 2, 2}, 1e5);
  scene.body.pressure = pressure;
  RegionSettings stiff;
  stiff.place = {Vec3(0.5, -1, -1), Vec3(2, 2, 2)};
  stiff.young_modulus = 1e6;
  stiff.poisson_ratio = 0.2;
  scene.body.regions = {stiff};
  return scene;
}

TEST(StressView, FindsWhatTheBodyDoes) {
  for (const Pressure pressure : {Pressure::ELEMENT, Pressure::AVERAGED}) {
    const Scene scene = barInTwoRegions(pressure);
    DeformableBody body(scene, loadMesh(scene));
    run(&body, 5);
    ASSERT_EQ(body.cut(plane(Vec3(0.6, 0.1, 0.1), Vec3(1, 0.2, 0.1))).status, CutStatus::APPLIED);
    StressView view(std::make_shared<CutMesh>(body.mesh()), body.materials(), scene.body, body.positions());
    for (int k = 0; k < 5; ++k) {
      run(&body, 3);
      const std::vector<double> found = view.vonMises(body.positions());
      const std::vector<Mat3> stress = body.partStress();
      ASSERT_EQ(found.size(), stress.size());
      double largest = 0;
      for (double value : found) largest = std::max(largest, value);
      ASSERT_GT(largest, 100);
      for (std::size_t p = 0; p < found.size(); ++p) ASSERT_NEAR(found[p], vonMises(stress[p]), 1e-9 * largest);
    }
  }
}

TEST(StressView, ARegionsMeanIsByVolume) {
  const Scene scene = barInTwoRegions(Pressure::ELEMENT);
  DeformableBody body(scene, loadMesh(scene));
  ASSERT_EQ(body.cut(plane(Vec3(0.6, 0.1, 0.1), Vec3(1, 0.2, 0.1))).status, CutStatus::APPLIED);
  const StressView view(std::make_shared<CutMesh>(body.mesh()), body.materials(), scene.body, body.positions());
  std::vector<double> of_parts;
  double sum = 0, volume = 0;
  for (const Part& part : body.mesh().parts()) {
    of_parts.push_back(part.fraction);
    if (body.materials().regions().of(part.element) == 0) continue;
    sum += part.fraction * part.fraction * elementVolume(body.mesh().mesh(), part.element);
    volume += part.fraction * elementVolume(body.mesh().mesh(), part.element);
  }
  const std::vector<RegionStress> found = view.ofRegions(of_parts);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].mean, 1, 1e-12);
  EXPECT_NEAR(found[1].mean, sum / volume, 1e-12);
  EXPECT_EQ(found[1].largest, 1);
}

}  // namespace
}  // namespace incision::test

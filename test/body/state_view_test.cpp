#include "incision/body/state_view.h"

#include <gtest/gtest.h>

#include "support/cuts.h"
#include "support/scenes.h"

namespace incision::test {
namespace {

TEST(StateView, TellsWhatTheBodyDoes) {
  for (const Pressure pressure : {Pressure::ELEMENT, Pressure::AVERAGED})
    for (const Mass mass : {Mass::LUMPED, Mass::CONSISTENT}) {
      Scene scene = swingingBar({8, 2, 2}, 1e5);
      scene.body.pressure = pressure;
      scene.body.mass = mass;
      DeformableBody body(scene, loadMesh(scene));
      run(&body, 5);
      ASSERT_EQ(body.cut(plane(Vec3(0.6, 0.1, 0.1), Vec3(1, 0.2, 0.1))).status, CutStatus::APPLIED);
      StateView view(std::make_shared<CutMesh>(body.mesh()), body.materials(), scene.body, body.positions());
      for (int k = 0; k < 5; ++k) {
        run(&body, 3);
        const Motion now{body.positions(), body.velocities()};
        EXPECT_EQ(view.hash(body.steps(), now), body.stateHash());
        const BodyMotion found = view.motion(now, scene.gravity), expected = body.motion();
        EXPECT_EQ(found.mass, expected.mass);
        EXPECT_EQ(found.momentum, expected.momentum);
        EXPECT_EQ(found.kinetic_energy, expected.kinetic_energy);
        EXPECT_EQ(found.potential_energy, expected.potential_energy);
        EXPECT_EQ(found.max_displacement, expected.max_displacement);
        EXPECT_GT(expected.elastic_energy, 0);
        EXPECT_NEAR(found.elastic_energy, expected.elastic_energy, 1e-12 * expected.elastic_energy);
      }
    }
}

}  // namespace
}  // namespace incision::test

// Whatever numbers a scene has, a step is taken and everything is finite, or it fails and the body is as it was.
#include <gtest/gtest.h>

#include <sstream>

#include "support/broken_plate.h"
#include "support/sanitized.h"

namespace incision::test {
namespace {

struct Extreme {
  const char* name;
  void (*apply)(Scene* scene);
};

const Extreme EXTREMES[] = {
    {"WeightBeyondAllNumbers", [](Scene* scene) { scene->gravity = Vec3(1e308, 0, -1e308); }},
    {"WeightWhoseSquareIsNoNumber", [](Scene* scene) { scene->gravity = Vec3(0, 0, -1e200); }},
    {"StifferThanAnythingInLongSteps",
     [](Scene* scene) {
       scene->body.material.young_modulus = 1e15;
       scene->solver.time_step = 1;
     }},
    {"StiffnessThatIsNone", [](Scene* scene) { scene->body.material.young_modulus = 1e-300; }},
    {"StiffnessBeyondAllNumbers", [](Scene* scene) { scene->body.material.young_modulus = 1e300; }},
    {"MassBeyondAllNumbers", [](Scene* scene) { scene->body.material.density = 1e300; }},
    {"MassThatIsNone", [](Scene* scene) { scene->body.material.density = 1e-300; }},
    {"DampingBeyondAllNumbers",
     [](Scene* scene) { scene->body.material.mass_damping = scene->body.material.stiffness_damping = 1e300; }},
    {"LoadsBeyondAllNumbers",
     [](Scene* scene) {
       const RestBox everything{Vec3::Constant(-10), Vec3::Constant(10)};
       scene->loads = {{everything, Vec3(1e300, -1e300, 0), 0}, {everything, Vec3(0, 0, 1e300), 1}};
     }},
    {"ACrackThatTakesNoEnergyAndNoStress",
     [](Scene* scene) {
       scene->fracture->tensile_strength = 1e-300;
       scene->fracture->fracture_energy = 1e-300;
     }},
    {"ACrackThatTakesAllEnergy", [](Scene* scene) { scene->fracture->fracture_energy = 1e300; }},
};

bool areFinite(const DeformableBody& body) {
  for (const auto* list : {&body.positions(), &body.velocities()})
    for (const Vec3& value : *list)
      if (!value.allFinite()) return false;
  return true;
}

std::string saved(const DeformableBody& body) {
  std::ostringstream bytes;
  body.save(bytes);
  return bytes.str();
}

class ExtremeNumbers : public ::testing::TestWithParam<std::tuple<int, Method>> {};

TEST_P(ExtremeNumbers, FailAStepOrLeaveEverythingFinite) {
  const auto [extreme, method] = GetParam();
  Scene scene = everythingAtOnce(method);
  EXTREMES[extreme].apply(&scene);
  DeformableBody body(scene, loadMesh(scene));
  const std::string start = saved(body);
  const std::uint64_t hash = body.stateHash();
  for (int k = 0; k < (SANITIZED ? 3 : 8); ++k) {
    const std::vector<Vec3> before = body.positions();
    const std::int64_t steps = body.steps();
    try {
      body.step();
      EXPECT_EQ(body.steps(), steps + 1);
    } catch (const StepFailed&) {
      EXPECT_EQ(body.steps(), steps);
      for (std::size_t c = 0; c < before.size(); ++c) EXPECT_EQ(before[c], body.positions()[c]);
    }
    ASSERT_TRUE(areFinite(body)) << k;
    EXPECT_NO_THROW(body.restore(saved(body)));
  }
  body.restore(start);
  EXPECT_EQ(body.stateHash(), hash);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ExtremeNumbers,
                         ::testing::Combine(::testing::Range(0, static_cast<int>(std::size(EXTREMES))),
                                            ::testing::Values(Method::DIRECT, Method::ITERATIVE)),
                         [](const auto& instance) {
                           return std::string(EXTREMES[std::get<0>(instance.param)].name) +
                                  (std::get<1>(instance.param) == Method::DIRECT ? "Direct" : "Iterative");
                         });

}  // namespace
}  // namespace incision::test

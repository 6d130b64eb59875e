// What is set anew while a body runs holds as if the scene had said so.
#include <gtest/gtest.h>

#include <functional>
#include <sstream>

#include "incision/base/input_error.h"
#include "support/scenes.h"
#include "support/tool.h"

namespace incision::test {
namespace {

/// A bar that a blade cuts into, against resistance that is another in its outer half.
Scene bladedBar() {
  Scene scene = swingingBar({12, 3, 3}, 1e5);
  RegionSettings outer;
  outer.place = Place(Vec3(0.5, -1, -1), Vec3(2, 1, 1));
  outer.cutting_force = 30;
  scene.body.regions = {outer};
  ToolSettings tool = bladeTool(Edge{Vec3(0, 0, -0.3), Vec3(0, 0, 0.3)});
  tool.name = "blade";
  bladeOf(&tool).cutting.resistance.force = 20;
  bladeOf(&tool).cutting.resistance.viscosity = 8;
  bladeOf(&tool).cutting.resistance.onset = 10;
  scene.tools = {tool};
  return scene;
}

void guide(DeformableBody* body) {
  const double y = -0.05 + 0.01 * static_cast<double>(body->steps());
  Pose pose;
  pose.position = Vec3(0.31 + 0.5 * y, y, 0);
  body->guideTool({pose});
}

void runGuided(DeformableBody* body, int steps) {
  for (int k = 0; k < steps; ++k) {
    guide(body);
    body->step();
  }
}

struct Change {
  std::function<void(LiveSettings*)> set;
  std::function<void(Scene*)> said;  // the same by the scene
};

const std::map<std::string, Change> CHANGES = {
    {"Nothing", {[](LiveSettings*) {}, [](Scene*) {}}},
    {"Gravity",
     {[](LiveSettings* live) { live->gravity = Vec3(1, 2, -3); },
      [](Scene* scene) { scene->gravity = Vec3(1, 2, -3); }}},
    {"Tolerance",
     {[](LiveSettings* live) { live->tolerance = 1e-2; }, [](Scene* scene) { scene->solver.tolerance = 1e-2; }}},
    {"Threads", {[](LiveSettings* live) { live->threads = 1; }, [](Scene* scene) { scene->solver.threads = 1; }}},
    {"CuttingForce",
     {[](LiveSettings* live) { live->cutting_force_factor = 2; },
      [](Scene* scene) {
        scene->body.regions[0].cutting_force = 60;
        bladeOf(&scene->tools[0]).cutting.resistance.force = 40;
        bladeOf(&scene->tools[0]).cutting.resistance.viscosity = 16;
        bladeOf(&scene->tools[0]).cutting.resistance.onset = 20;
      }}},
};

void change(DeformableBody* body, const Change& how) {
  LiveSettings live = body->live();
  how.set(&live);
  body->set(live);
}

constexpr int LIVE_STEPS = 14;

class SetAnew : public ::testing::TestWithParam<std::pair<const std::string, Change>> {};

TEST_P(SetAnew, AtTheStartIsAsSaidByTheScene) {
  for (const auto& [method, integrator] :
       {std::make_pair(Method::DIRECT, Integrator::EULER), std::make_pair(Method::ITERATIVE, Integrator::BDF2)}) {
    Scene scene = bladedBar();
    scene.solver.method = method;
    scene.solver.integrator = integrator;
    Scene said = scene;
    GetParam().second.said(&said);
    DeformableBody body = makeBody(scene), other = makeBody(said);
    change(&body, GetParam().second);
    runGuided(&body, LIVE_STEPS);
    runGuided(&other, LIVE_STEPS);
    EXPECT_EQ(body.stateHash(), other.stateHash());
    EXPECT_EQ(body.motion().potential_energy, other.motion().potential_energy);
  }
}

TEST_P(SetAnew, OutlastsAReset) {
  Scene said = bladedBar();
  GetParam().second.said(&said);
  DeformableBody body = makeBody(bladedBar()), other = makeBody(said);
  runGuided(&body, 3);
  change(&body, GetParam().second);
  body.reset();
  runGuided(&body, LIVE_STEPS);
  runGuided(&other, LIVE_STEPS);
  EXPECT_EQ(body.stateHash(), other.stateHash());
}

TEST_P(SetAnew, IsSavedWithTheBody) {
  DeformableBody body = makeBody(bladedBar()), other = makeBody(bladedBar());
  runGuided(&body, LIVE_STEPS / 2);
  change(&body, GetParam().second);
  runGuided(&body, 2);
  other.restore(bytesOf(body));
  EXPECT_EQ(other.live().threads, bladedBar().solver.threads);
  runGuided(&body, LIVE_STEPS);
  runGuided(&other, LIVE_STEPS);
  EXPECT_EQ(body.stateHash(), other.stateHash());
}

INSTANTIATE_TEST_SUITE_P(Of, SetAnew, ::testing::ValuesIn(CHANGES.begin(), CHANGES.end()),
                         [](const auto& of) { return of.param.first; });

// Or the tests above would show nothing.
TEST(SettingAnew, ChangesWhatTheBodyDoes) {
  const auto hashAfter = [](const Change& how) {
    DeformableBody body = makeBody(bladedBar());
    runGuided(&body, LIVE_STEPS / 2);
    change(&body, how);
    runGuided(&body, LIVE_STEPS / 2);
    return body.stateHash();
  };
  const std::uint64_t unchanged = hashAfter(CHANGES.at("Nothing"));
  for (const char* name : {"Gravity", "Tolerance", "CuttingForce"})
    EXPECT_NE(hashAfter(CHANGES.at(name)), unchanged) << name;
  EXPECT_EQ(hashAfter(CHANGES.at("Threads")), unchanged);
}

TEST(SettingAnew, ACuttingForceOfNoneFreesTheEdge) {
  DeformableBody body = makeBody(bladedBar());
  runGuided(&body, LIVE_STEPS);
  LiveSettings live = body.live();
  live.cutting_force_factor = 0;
  body.set(live);
  guide(&body);
  EXPECT_EQ(body.step().tools[0].force, Vec3::Zero());
}

TEST(SettingAnew, WhatTheSceneCouldNotSayIsRefused) {
  DeformableBody body = makeBody(bladedBar());
  const LiveSettings before = body.live();
  LiveSettings wrong = before;
  wrong.tolerance = 1;
  EXPECT_THROW(body.set(wrong), InputError);
  wrong = before;
  wrong.gravity.y() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(body.set(wrong), InputError);
  EXPECT_EQ(body.live(), before);
}

}  // namespace
}  // namespace incision::test

// What is saved and restored is as if it had never been saved.
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <sstream>

#include "incision/base/input_error.h"
#include "support/broken_plate.h"
#include "support/contacts.h"
#include "support/failing_solver.h"
#include "support/forceps.h"
#include "support/sanitized.h"
#include "support/scenes.h"
#include "support/tool.h"
#include "support/turning.h"

namespace incision::test {
namespace {

void restore(DeformableBody* body, const std::string& bytes) { body->restore(bytes); }

/// A scene, and what is done to its body before a step.
struct Case {
  Scene scene;
  Descriptions descriptions = {};
  std::function<void(DeformableBody*, std::int64_t)> command = [](DeformableBody*, std::int64_t) {};

  DeformableBody makeBody() const { return DeformableBody(scene, loadMesh(scene), descriptions); }
  void step(DeformableBody* body) const {
    command(body, body->steps());
    body->step();
  }
};

/// A bar that swings, and is cut in its first steps.
Case cutBar(const std::function<void(Scene*)>& change) {
  Case made{softBar()};
  made.scene.body.grid->cells = {12, 3, 3};
  made.scene.gravity = Vec3(0, 1, -9.81);
  made.scene.boundary = {clampLeftEnd()};
  made.scene.cuts = crossingCuts(0.02);
  change(&made.scene);
  return made;
}

/// The bar breaks too, and its cracks run into each other.
Case brokenBar() {
  return cutBar([](Scene* scene) {
    scene->solver.method = Method::ITERATIVE;
    scene->fracture = FractureSettings();
    scene->fracture->tensile_strength = 1500;
    scene->fracture->fuse_distance = 0.1;
    scene->fracture->fuse_angle = 0.5;
  });
}

/// A block in two that falls upon a ground over which a box moves, and the box takes along what it meets.
Case rubbingBlock(Method method) {
  Case made{blockAbove(0, {8, 4, 4}, Vec3(0, 0, 0.002))};
  made.scene.solver.method = method;
  made.scene.cuts = {{0.01, plane(Vec3(0.19, 0, 0), Vec3(1, 0.2, 0.3))}};
  made.scene.contact->obstacles = "room.urdf";
  made.descriptions.obstacles = urdfOf("<box size='0.1 1 1'/>", "-0.06 0 0.5");
  made.command = [](DeformableBody* body, std::int64_t step) {
    Pose pose;
    pose.position = Vec3(0.002 * static_cast<double>(step), 0, 0);
    body->moveObstacle(0, pose);
  };
  return made;
}

/// The bar held by a hand that moves and turns it, and by another that a scene leads.
Case ledBar() {
  Case made = cutBar([](Scene* scene) {
    scene->boundary[0].frame = "hand";
    Clamp right;
    right.place = Place(Vec3(1 - 1e-6, -1, -1), Vec3(2, 1, 1));
    for (const double t : {0.05, 0.2, 0.3}) right.poses.push_back({t, turningFrame(t)});
    scene->boundary.push_back(right);
  });
  made.command = [](DeformableBody* body, std::int64_t step) {
    if (step >= 2) body->moveClamp(0, turningFrame(0.01 * static_cast<double>(step)));
  };
  return made;
}

/// A blade that is guided from step to step, some steps ahead, off for a while.
Case guidedBlade() {
  Case made{plateAndBlade()};
  made.scene.solver.method = Method::AUTO;
  bladeOf(&made.scene.tools[0]).cutting.resistance.force = 20;
  made.command = [](DeformableBody* body, std::int64_t step) {
    const double x = -0.05 + 0.02 * static_cast<double>(step);
    if (step == 20 || step == 26) body->activateTool(step == 26);
    body->guideTool({poseAt(x, 0.21 + 0.05 * std::sin(8 * x)), poseAt(x + 0.01, 0.21 + 0.05 * std::sin(8 * x))});
  };
  return made;
}

/// A guided blade that tissue resists the more the faster it cuts, and that takes more to begin.
Case viscousBlade() {
  Case made = guidedBlade();
  bladeOf(&made.scene.tools[0]).cutting.resistance.viscosity = 10;
  bladeOf(&made.scene.tools[0]).cutting.resistance.onset = 100;
  return made;
}

/// Forceps that close on a slab, carry it up faster than they can hold it, and open.
Case graspedSlab(Method method) {
  Case made{slabAndForceps(0.05, true)};
  made.scene.solver.method = method;
  made.descriptions.tools = {forcepsUrdf({})};
  made.command = [](DeformableBody* body, std::int64_t step) {
    if (step == 0) {
      body->placeTool(AT_EDGE);
      body->guideJaw(FORCEPS_OPEN);
    }
    if (step == 1) body->guideJaw(0.03);
    if (step >= 5)
      body->guideTool(
          {{AT_EDGE.position - Vec3(5e-5 * std::pow(static_cast<double>(step) - 5, 2), 0, 0), AT_EDGE.orientation}});
    if (step == 40) body->guideJaw(FORCEPS_OPEN);
  };
  return made;
}

const std::map<std::string, std::function<Case()>> CASES = {
    {"BarDirect", [] { return cutBar([](Scene*) {}); }},
    {"BarIterative", [] { return cutBar([](Scene* scene) { scene->solver.method = Method::ITERATIVE; }); }},
    {"BarSecondOrder",
     [] {
       return cutBar([](Scene* scene) {
         scene->solver.method = Method::ITERATIVE;
         scene->solver.integrator = Integrator::BDF2;
       });
     }},
    {"BarUnwarped",
     [] {
       return cutBar([](Scene* scene) {
         scene->solver.method = Method::ITERATIVE;
         scene->body.warping = false;
       });
     }},
    {"BarAveraged",
     [] {
       return cutBar([](Scene* scene) {
         scene->solver.method = Method::ITERATIVE;
         scene->body.pressure = Pressure::AVERAGED;
         scene->body.mass = Mass::CONSISTENT;
       });
     }},
    {"BarBreaking", brokenBar},
    {"PlateDirect", [] { return Case{everythingAtOnce(Method::DIRECT)}; }},
    {"PlateIterative", [] { return Case{everythingAtOnce(Method::ITERATIVE)}; }},
    {"BlockDirect", [] { return rubbingBlock(Method::DIRECT); }},
    {"BlockIterative", [] { return rubbingBlock(Method::ITERATIVE); }},
    {"BladeGuided", guidedBlade},
    {"BladeViscous", viscousBlade},
    {"BarLed", ledBar},
    {"SlabGraspedDirect", [] { return graspedSlab(Method::DIRECT); }},
    {"SlabGraspedIterative", [] { return graspedSlab(Method::ITERATIVE); }},
};

class SavedBody : public ::testing::TestWithParam<std::pair<const std::string, std::function<Case()>>> {};

TEST_P(SavedBody, GoesOnAsIfItHadNeverBeenSaved) {
  constexpr int LATER = 30;
  const std::vector<std::int64_t> saved_at =
      SANITIZED ? std::vector<std::int64_t>{12} : std::vector<std::int64_t>{3, 12, 23};
  const Case one = GetParam().second();
  DeformableBody body = one.makeBody();
  std::vector<std::uint64_t> hashes = {body.stateHash()};
  std::map<std::int64_t, std::string> saved;
  while (body.steps() < saved_at.back() + LATER) {
    if (std::count(saved_at.begin(), saved_at.end(), body.steps()) > 0) saved[body.steps()] = bytesOf(body);
    one.step(&body);
    hashes.push_back(body.stateHash());
  }
  for (const auto& [step, bytes] : saved) {
    DeformableBody other = one.makeBody();
    restore(&other, bytes);
    ASSERT_EQ(other.steps(), step);
    EXPECT_TRUE(bytesOf(other) == bytes) << step;
    for (int k = 0; k < LATER; ++k) {
      one.step(&other);
      ASSERT_EQ(other.stateHash(), hashes[static_cast<std::size_t>(other.steps())]) << "step " << other.steps();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, SavedBody, ::testing::ValuesIn(CASES), [](const auto& of) { return of.param.first; });

// The first solve of a step does not converge, so that some steps are solved directly.
TEST(SavedBodies, GoOnWithTheSolverThatStandsIn) {
  const Scene scene = cutBar([](Scene* bar) {
                        bar->solver.method = Method::ITERATIVE;
                        bar->cuts.clear();
                      }).scene;
  for (const int steps : {6, 21}) {  // 22 steps later it is the iteration's turn again
    Fallible one(scene), other(scene);
    for (int k = 0; k < steps; ++k) {
      if (k == 2) one.failures.fail({0});
      one.body.step();
    }
    EXPECT_GT(one.failures.count, 1);
    restore(&other.body, bytesOf(one.body));
    for (int k = 0; k < 10; ++k) {
      one.body.step();
      other.body.step();
      ASSERT_EQ(other.body.stateHash(), one.body.stateHash()) << steps << ' ' << k;
    }
  }
}

TEST(SavedBodies, GoOnAlikeWhateverTheThreadCount) {
  const Case one = rubbingBlock(Method::ITERATIVE);
  Case other = one;
  other.scene.solver.threads = 2;
  DeformableBody body = one.makeBody(), twin = other.makeBody();
  for (int k = 0; k < 12; ++k) one.step(&body);
  restore(&twin, bytesOf(body));
  for (int k = 0; k < 10; ++k) {
    one.step(&body);
    other.step(&twin);
    ASSERT_EQ(twin.stateHash(), body.stateHash()) << k;
  }
}

TEST(SavedBodies, CanBeRestoredIntoABodyThatHasDoneOtherThings) {
  const Case one{everythingAtOnce(Method::DIRECT)};
  DeformableBody body = one.makeBody(), other = one.makeBody();
  for (int k = 0; k < 12; ++k) body.step();
  const std::string bytes = bytesOf(body);
  EXPECT_EQ(other.cut(plane(Vec3(0.3, 0.2, 0.1), Vec3(0.2, 1, 0.1))).status, CutStatus::APPLIED);
  for (int k = 0; k < 5; ++k) other.step();
  restore(&other, bytes);
  EXPECT_TRUE(bytesOf(other) == bytes);
  for (int k = 0; k < 10; ++k) {
    body.step();
    other.step();
    ASSERT_EQ(other.stateHash(), body.stateHash()) << k;
  }
  other.reset();
  EXPECT_TRUE(bytesOf(other) == bytesOf(one.makeBody()));
}

class FailedAndSaved : public ::testing::TestWithParam<Method> {};

// What is due takes effect before a step fails; so the bytes are taken after a first failure.
TEST_P(FailedAndSaved, StepsLeaveNoTraceInTheBytes) {
  const Scene scene = everythingAtOnce(GetParam());
  Fallible failing(scene), twin(scene);
  for (int k = 0; k < 16; ++k) {
    failing.failOnce(ALL);
    const std::string before = bytesOf(failing.body);
    failing.failOnce(ALL);
    EXPECT_TRUE(bytesOf(failing.body) == before) << k;
    failing.failOnce(afterAPart());
    EXPECT_TRUE(bytesOf(failing.body) == before) << k;
    failing.body.step();
    twin.body.step();
    ASSERT_EQ(failing.body.stateHash(), twin.body.stateHash()) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, FailedAndSaved, ::testing::Values(Method::DIRECT, Method::ITERATIVE));

TEST(SavedBodies, LeaveABodyAsItIsWhereTheyDoNotFit) {
  const Case one{everythingAtOnce(Method::DIRECT)};
  DeformableBody body = one.makeBody();
  for (int k = 0; k < 8; ++k) body.step();
  const std::string bytes = bytesOf(body);
  DeformableBody other = one.makeBody();
  other.step();
  const std::string before = bytesOf(other);
  for (std::size_t length = 0; length < bytes.size(); length += 1 + length / 3) {
    EXPECT_THROW(restore(&other, bytes.substr(0, length)), InputError) << length;
    ASSERT_TRUE(bytesOf(other) == before) << length;
  }
  EXPECT_THROW(restore(&other, bytes.substr(0, bytes.size() - 1)), InputError);
  std::vector<Scene> others(4, one.scene);
  others[0].body.grid->cells = {8, 4, 3};
  others[1].tools.clear();
  others[2].fracture.reset();
  others[3].contact.reset();
  for (const Scene& scene : others) {
    DeformableBody stranger(scene, loadMesh(scene));
    EXPECT_THROW(restore(&other, bytesOf(stranger)), InputError);
    EXPECT_THROW(restore(&stranger, bytes), InputError);
  }
  EXPECT_TRUE(bytesOf(other) == before);
}

}  // namespace
}  // namespace incision::test

// What is saved and restored is as if it had never been saved.
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <sstream>

#include "incision/base/input_error.h"
#include "support/broken_plate.h"
#include "support/contacts.h"
#include "support/failing_solver.h"
#include "support/sanitized.h"

namespace incision::test {
namespace {

std::string bytesOf(const DeformableBody& body) {
  std::ostringstream bytes;
  body.save(bytes);
  return bytes.str();
}

void restore(DeformableBody* body, const std::string& bytes) {
  std::istringstream in(bytes);
  body->restore(in);
}

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

/// A block in pieces that falls upon a ground that a box moves over, and the box takes along what it meets.
Case rubbingBlock(Method method) {
  Case made{blockAbove(0, {6, 4, 4}, Vec3(0, 0, 0.002))};
  made.scene.solver.method = method;
  made.scene.cuts = {{0.01, plane(Vec3(0.14, 0, 0), Vec3(1, 0.2, 0.3))},
                     {0.03, plane(Vec3(0, 0, 0.11), Vec3(0.3, 0.2, 1))}};
  made.scene.contact->obstacles = "room.urdf";
  made.descriptions.obstacles = urdfOf("<box size='0.1 1 1'/>", "-0.06 0 0.5");
  made.command = [](DeformableBody* body, std::int64_t step) {
    Pose pose;
    pose.position = Vec3(0.002 * static_cast<double>(step), 0, 0);
    body->moveObstacle(0, pose);
  };
  return made;
}

/// A blade that is guided from step to step, some steps ahead, off for a while.
Case guidedBlade() {
  Case made{plateAndBlade()};
  made.scene.solver.method = Method::AUTO;
  made.scene.tool->cutting_force = 20;
  made.command = [](DeformableBody* body, std::int64_t step) {
    const double x = -0.05 + 0.02 * static_cast<double>(step);
    if (step == 20 || step == 26) body->activateTool(step == 26);
    body->guideTool({poseAt(x, 0.21 + 0.05 * std::sin(8 * x)), poseAt(x + 0.01, 0.21 + 0.05 * std::sin(8 * x))});
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
    EXPECT_EQ(bytesOf(other), bytes) << step;
    for (int k = 0; k < LATER; ++k) {
      one.step(&other);
      ASSERT_EQ(other.stateHash(), hashes[static_cast<std::size_t>(other.steps())]) << "step " << other.steps();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, SavedBody, ::testing::ValuesIn(CASES), [](const auto& info) { return info.param.first; });

// The first solve does not converge, so that some steps are solved directly.
TEST(SavedBodies, GoOnWithTheSolverThatStandsIn) {
  const Scene scene = rubbingBlock(Method::ITERATIVE).scene;
  Fallible one(scene), other(scene);
  for (int k = 0; k < 12; ++k) {
    if (k == 2) one.failures.fail({0});
    one.body.step();
  }
  restore(&other.body, bytesOf(one.body));
  for (int k = 0; k < 20; ++k) {
    one.body.step();
    other.body.step();
    ASSERT_EQ(other.body.stateHash(), one.body.stateHash()) << k;
  }
}

}  // namespace
}  // namespace incision::test

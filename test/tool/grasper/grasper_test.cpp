#include "incision/tool/grasper/grasper.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>

#include "incision/base/input_error.h"
#include "incision/body/deformable_body.h"
#include "support/failing_solver.h"
#include "support/forceps.h"
#include "support/sanitized.h"
#include "support/scenes.h"

namespace incision::test {
namespace {

constexpr double EXACT = 1e-10;

/// What a hand does with graspers.
struct Hand {
  explicit Hand(const Scene& scene, const std::string& urdf = forcepsUrdf({}))
      : body(scene, loadMesh(scene), {std::vector<std::string>(scene.tools.size(), urdf), ""}),
        pose(scene.tools.size()),
        from(pose) {}

  /// Takes a step. Where nothing else acts it changes the momentum by just what the tools and the weight do.
  void step() {
    const Vec3 momentum = body.motion().momentum;
    result = body.step();
    Vec3 outside = weight();
    for (std::size_t i = 0; i < pose.size(); ++i) outside -= from[i].orientation * report(static_cast<int>(i)).force;
    largest = std::max({largest, outside.norm(), weight().norm()});
    if (is_free) {
      const double dt = body.scene().solver.time_step;
      EXPECT_LE((body.motion().momentum - momentum - dt * outside).norm(), EXACT * dt * largest) << body.steps();
    }
    from = pose;
  }
  void rest(int steps) {
    for (int k = 0; k < steps; ++k) step();
  }
  void place(const Pose& at, double angle, int i = 0) {
    const std::size_t tool = static_cast<std::size_t>(i);
    body.guideJaw(angle, tool);
    step();
    body.placeTool(at, tool);
    pose[tool] = at;
    from = pose;
    step();
  }
  void turnJaw(double to, int steps, int i = 0) {
    const std::size_t tool = static_cast<std::size_t>(i);
    const double start = body.toolJaw(tool);
    for (int k = 1; k <= steps; ++k) {
      body.guideJaw(start + (to - start) * k / steps, tool);
      step();
    }
  }
  void carry(const Vec3& way, int steps, int i = 0) {
    const std::size_t tool = static_cast<std::size_t>(i);
    const Vec3 start = pose[tool].position;
    for (int k = 1; k <= steps; ++k) {
      from = pose;
      pose[tool].position = start + way * k / steps;
      body.guideTool({pose[tool]}, tool);
      step();
    }
  }
  const ToolReport& report(int i = 0) const { return result.tools[i]; }
  Vec3 weight() const { return body.motion().mass * body.scene().gravity; }
  double energy() const { return body.motion().kinetic_energy + body.motion().elastic_energy; }

  DeformableBody body;
  std::vector<Pose> pose, from;  // of the tools now, and when the step started
  StepResult result;
  bool is_free = false;  // nothing but tools and the weight acts on the body
  double largest = 0;
};

/// The scene with its first tool at the slab from the start, opened so far that it just does not touch. It closes in
/// the first step.
Scene closing(Scene scene) {
  const double dt = scene.solver.time_step;
  scene.tools[0].poses = {{0, AT_EDGE}, {dt, AT_EDGE}};
  scene.tools[0].jaw->angles = {{0, 0.12}, {dt, 0.03}};
  return scene;
}

/// A hand that has closed its first jaws on the slab before that has fallen far.
std::unique_ptr<Hand> holding(const Scene& scene, int steps = 400) {
  auto hand = std::make_unique<Hand>(closing(scene));
  hand->pose[0] = hand->from[0] = AT_EDGE;
  hand->rest(1 + steps);
  return hand;
}

TEST(Grasper, TellsTheWeightOfWhatItHolds) {
  struct Case {
    Method method;
    double time_step, young_modulus;
    bool touching;
  };
  const std::vector<Case> cases = {{Method::DIRECT, 0.005, 3e4, true},    {Method::DIRECT, 0.005, 3e4, false},
                                   {Method::DIRECT, 0.02, 3e5, true},     {Method::DIRECT, 0.001, 3e5, true},
                                   {Method::ITERATIVE, 0.005, 3e4, true}, {Method::ITERATIVE, 0.02, 3e4, false},
                                   {Method::ITERATIVE, 0.01, 3e5, false}};
  for (const auto& [method, dt, E, touching] : SANITIZED ? std::vector<Case>{cases[0]} : cases) {
    Scene scene = slabAndForceps(2, touching);
    scene.solver.method = method;
    scene.solver.time_step = dt;
    scene.body.material.young_modulus = E;
    const auto held = holding(scene, static_cast<int>(2.5 / dt));
    Hand& hand = *held;
    EXPECT_EQ(hand.report().gripped, 2);
    EXPECT_LT((hand.report().force - hand.weight()).norm(), 1e-6 * hand.weight().norm())
        << touching << " " << dt << " " << E;
    EXPECT_NEAR(hand.report().force.x(), SLAB_MASS * SLAB_GRAVITY, 1e-6 * SLAB_MASS * SLAB_GRAVITY);
  }
}

TEST(Grasper, LiftsTurnsAndLetsGoOfIt) {
  for (const bool touching : {true, false}) {
    const auto held = holding(slabAndForceps(2, touching), 20);
    Hand& hand = *held;
    const Vec3 way(-0.05, 0.02, 0.01), before = hand.body.nodePositions()[0];
    hand.carry(way, 60);
    hand.rest(100);
    EXPECT_LT((hand.body.nodePositions()[0] - before - way).norm(), 3e-3);
    EXPECT_GT(hand.report().gripped, 1.9);
    hand.turnJaw(FORCEPS_OPEN, 10);
    EXPECT_EQ(hand.report().gripped, 0);
    hand.rest(40);
    EXPECT_EQ(hand.report().force, Vec3::Zero());
    EXPECT_GT((hand.body.nodePositions()[0] - before - way).x(), 0.02);
  }
}

// Without contact nothing else holds it.
TEST(Grasper, TakesTheMomentumThatTheBodyGains) {
  for (const bool touching : {true, false}) {
    Scene scene = slabAndForceps(0.1, touching, 2);
    scene.body.material.mass_damping = 0;
    Hand hand(scene);
    hand.is_free = true;
    hand.place(AT_EDGE, FORCEPS_OPEN);
    hand.turnJaw(0.03, 2);
    hand.carry(Vec3(-0.02, 0.01, 0.01), 20);
    hand.place(AT_SIDE, FORCEPS_OPEN, 1);
    hand.turnJaw(0.03, 10, 1);
    hand.carry(Vec3(-0.02, 0.01, 0.01), 4);
    hand.turnJaw(FORCEPS_OPEN, 5);
    hand.rest(20);
    EXPECT_GT(hand.largest, 0.05);
  }
}

TEST(Grasper, ReleasedItFallsFromTheNextStepOn) {
  const auto held = holding(slabAndForceps(2, false));
  Hand& hand = *held;
  hand.turnJaw(FORCEPS_CLOSED + 0.01, 1);
  const Vec3 momentum = hand.body.motion().momentum;
  hand.step();
  EXPECT_EQ(hand.report().force, Vec3::Zero());
  const double dt = 0.005, damped = 1 + 10 * dt;
  EXPECT_LT((damped * hand.body.motion().momentum - momentum - dt * hand.weight()).norm(),
            EXACT * dt * SLAB_MASS * SLAB_GRAVITY);
}

TEST(Grasper, LetsGoWhereItIsSwitchedOffLiftedOrPutElsewhere) {
  const std::vector<std::function<void(DeformableBody*)>> interruptions = {
      [](DeformableBody* body) { body->activateTool(false); }, [](DeformableBody* body) { body->liftTool(); },
      [](DeformableBody* body) { body->placeTool(AT_EDGE); }};
  for (const auto& interrupt : interruptions) {
    const auto held = holding(slabAndForceps(2, false), 20);
    Hand& hand = *held;
    EXPECT_GT(hand.report().gripped, 0);
    interrupt(&hand.body);
    hand.step();
    EXPECT_EQ(hand.report().gripped, 0);
    EXPECT_EQ(hand.report().force, Vec3::Zero());
    // Closed as it is, it does not grip again.
    hand.body.activateTool(true);
    hand.rest(3);
    EXPECT_EQ(hand.report().gripped, 0);
  }
}

TEST(Grasper, GripsOnlyAsItsJawsClose) {
  Scene scene = slabAndForceps(2, false);
  scene.gravity.setZero();
  Hand hand(scene);
  hand.place(AT_EDGE, 0.03);
  hand.rest(5);
  EXPECT_EQ(hand.report().gripped, 0);
  hand.turnJaw(FORCEPS_OPEN, 5);
  EXPECT_EQ(hand.report().gripped, 0);
  hand.body.activateTool(false);
  hand.turnJaw(0.03, 5);
  EXPECT_EQ(hand.report().gripped, 0);
  hand.body.activateTool(true);
  hand.turnJaw(FORCEPS_OPEN, 5);
  hand.turnJaw(FORCEPS_CLOSED, 5);
  EXPECT_EQ(hand.report().gripped, 2);
  EXPECT_LT(hand.energy(), 1e-20);
}

TEST(Grasper, StaysAsFarOpenAsTheSceneLeavesIt) {
  Scene scene = slabAndForceps(2, false);
  scene.tools[0].poses = {{0, AT_EDGE}};
  scene.tools[0].jaw->angles = {{0, FORCEPS_OPEN}};
  Hand hand(scene);
  hand.rest(3);
  EXPECT_EQ(hand.report().jaw, FORCEPS_OPEN);
  EXPECT_EQ(hand.report().gripped, 0);
}

TEST(Grasper, ClosesOnNothingAndOnItself) {
  for (const bool touching : {true, false}) {
    Scene scene = slabAndForceps(2, touching);
    scene.gravity.setZero();
    Hand hand(scene);
    hand.place(facingX(-0.1), FORCEPS_OPEN);
    for (const double angle : {0.03, -0.05, FORCEPS_OPEN, -1.0, 0.0}) hand.turnJaw(angle, 3);
    EXPECT_EQ(hand.report().gripped, 0);
    EXPECT_EQ(hand.report().force, Vec3::Zero());
    EXPECT_EQ(hand.report().jaw_torque, 0);
    EXPECT_LT(hand.energy(), 1e-25);
  }
}

// The jaws work against what they press: what the joint gives is in the tissue, but for what the damping takes.
TEST(Grasper, TorqueOfTheJawsIsTheWorkThatTheyDo) {
  for (const bool both : {true, false}) {
    Scene scene = slabAndForceps(2, true);
    scene.gravity.setZero();
    scene.body.material.mass_damping = 100;
    scene.tools[0].friction = 0;
    scene.boundary = {SLAB_END};
    Hand hand(scene, forcepsUrdf({}, both));
    hand.place(facingX(-0.012, both ? 0 : -0.001), FORCEPS_OPEN);
    hand.turnJaw(0.15, 20);
    double work = 0;
    const double to = 0.06;  // the grip stays open
    const int steps = 1000;
    const double turn = (hand.body.toolJaw() - to) / steps;
    for (int k = 0; k < steps; ++k) {
      hand.body.guideJaw(hand.body.toolJaw() - turn);
      hand.step();
      EXPECT_GE(hand.report().jaw_torque, 0);
      work += hand.report().jaw_torque * turn;
    }
    const double energy = hand.body.motion().elastic_energy + hand.result.contact.energy;
    EXPECT_GT(energy, 1e-7);
    EXPECT_NEAR(work, energy, 0.05 * energy) << both;
  }
}

TEST(Grasper, PassesTheSlabToAnother) {
  for (const bool touching : {true, false}) {
    const auto held = holding(slabAndForceps(2, touching, 2), 50);
    Hand& hand = *held;
    hand.place(AT_SIDE, FORCEPS_OPEN, 1);
    hand.turnJaw(0.03, 30, 1);
    hand.rest(50);
    EXPECT_EQ(hand.report(1).gripped, 2);
    hand.turnJaw(FORCEPS_OPEN, 30);
    hand.carry(Vec3(-0.05, 0, 0), 30);
    hand.rest(700);
    EXPECT_EQ(hand.report(0).gripped, 0);
    EXPECT_EQ(hand.report(0).force, Vec3::Zero());
    EXPECT_GT(hand.report(1).gripped, 1.5);
    EXPECT_LT((hand.pose[1].orientation * hand.report(1).force - hand.weight()).norm(), 1e-6 * hand.weight().norm());
  }
}

// No more force than there may be, and no more energy than that has done as work.
TEST(Grasper, MovedTenCentimetresInOneStepBringsNoEnergy) {
  for (const bool touching : {true, false}) {
    Scene scene = slabAndForceps(0.2, touching);
    scene.gravity.setZero();
    scene.body.material.mass_damping = 0;
    Hand hand(scene);
    hand.place(AT_EDGE, FORCEPS_OPEN);
    hand.turnJaw(0.03, 20);
    hand.rest(50);
    const double before = hand.energy() + hand.result.contact.energy;
    hand.carry(Vec3(-0.1, 0, 0), 1);
    double work = -hand.report().force.x() * -0.1;
    EXPECT_GE(work, 0);
    for (int k = 0; k < 40; ++k) {
      EXPECT_LT(hand.energy() + hand.result.contact.energy, (1 + 1e-6) * (work + before)) << touching << " " << k;
      hand.step();
    }
  }
}

// The slab is held at its other end, and pulled till it tears.
TEST(Grasper, TearsWhatItPulls) {
  Scene scene = slabAndForceps(50, false);
  scene.gravity.setZero();
  scene.boundary = {SLAB_END};
  scene.fracture = FractureSettings();
  scene.fracture->tensile_strength = 5e3;
  Hand hand(scene);
  hand.place(AT_EDGE, FORCEPS_OPEN);
  hand.turnJaw(0.03, 20);
  hand.carry(Vec3(-0.03, 0, 0), 200);
  EXPECT_GT(hand.body.counts().pieces, 1);
  EXPECT_GT(hand.report().gripped, 40);
  hand.rest(100);
  EXPECT_LT(hand.report().force.norm(), 1e-3);
}

// The direct solve of the whole step fails, those of its halves do not.
TEST(Grasper, HoldsThroughAStepInHalves) {
  Scene scene = closing(slabAndForceps(0.05, true));
  scene.body.material.mass_damping = 0;
  Fallible one(scene, {{forcepsUrdf({})}, ""});
  one.failures.fail({0});
  one.body.step();
  EXPECT_GT(one.failures.count, 1);
  for (int k = 1; k < 30; ++k) {
    one.body.guideTool({facingX(AT_EDGE.position.x() - 1e-4 * k)});
    const BodyMotion before = one.body.motion();
    one.failures.fail({0});
    const ToolReport report = one.body.step().tools[0];
    EXPECT_GE(one.failures.count, 3);
    const Vec3 force = report.force - before.mass * scene.gravity,
               gained = one.body.motion().momentum - before.momentum;
    EXPECT_LE((gained + scene.solver.time_step * force).norm(), EXACT * scene.solver.time_step * 0.1) << k;
    if (k == 20) {
      EXPECT_GT(report.gripped, 0);
      one.failOnce(ALL);
    }
  }
}

TEST(Grasper, IdleIsAsIfItWereNotThere) {
  Scene with = slabAndForceps(2, false), without = with;
  without.tools.clear();
  Hand hand(with);
  hand.place(AT_EDGE, FORCEPS_OPEN);
  DeformableBody body(without, loadMesh(without));
  run(&body, 2);
  for (int k = 0; k < 20; ++k) {
    hand.step();
    body.step();
    ASSERT_EQ(hand.body.stateHash(), body.stateHash()) << k;
  }
}

std::string refusal(const ToolSettings& tool, const std::string& urdf = forcepsUrdf({})) {
  Scene scene = slabAndForceps(2, false);
  scene.tools = {tool};
  try {
    DeformableBody(scene, loadMesh(scene), {{urdf}, ""});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Grasper, IsRefusedWhereItCannotClose) {
  ToolSettings tool = graspingTool("forceps", 2);
  EXPECT_EQ(refusal(tool), "");
  tool.jaw->joint = "jaws";
  EXPECT_EQ(refusal(tool).find("forceps.urdf: joint 'jaws' does not exist"), 0u);
  tool.jaw->joint = "jaw";
  tool.kind = GrasperSettings{1, 2};
  EXPECT_EQ(refusal(tool), "forceps.urdf: joint 'jaw': closed at 1 (allowed: from -1 to less than 1, its limits)");
  tool.kind = GrasperSettings{-0.001, 2};
  EXPECT_EQ(
      refusal(tool, forcepsUrdf({}, true, "prismatic")),
      "forceps.urdf: joint 'jaw': closed at -0.001, where there is no room between the jaws (allowed: an angle at "
      "which there is some)");
}

}  // namespace
}  // namespace incision::test

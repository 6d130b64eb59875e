#include "incision/tool/grasper/grasper.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>

#include "incision/base/input_error.h"
#include "incision/body/deformable_body.h"
#include "support/forceps.h"
#include "support/sanitized.h"
#include "support/scenes.h"

namespace incision::test {
namespace {

constexpr double EXACT = 1e-10, G = 9.81, OPEN = 0.5, CLOSED = 0.05, MASS = 2.4e-3;

/// The lower edge of the slab below.
const Clamp FAR_END = {Place(Vec3(0.04 - 1e-6, -1, -1), Vec3(1, 1, 1)), Vec3::Zero()};

/// Forceps with which a scene has its tissue held.
ToolSettings graspingTool(const std::string& name, double grip) {
  ToolSettings tool;
  tool.name = name;
  tool.description = "forceps.urdf";
  tool.link = "palm";
  tool.kind = GrasperSettings{CLOSED, grip};
  tool.jaw.emplace().joint = "jaw";
  return tool;
}

/// A slab 40 × 20 × 3 mm round z = 0, its upper edge at x = 0, and graspers of so much strength; x points down.
Scene slab(double grip, bool touching, int tools = 1) {
  Scene scene;
  scene.body.grid = GridSettings{{8, 4, 1}, Vec3(0.04, 0.02, 0.003), Vec3(0, -0.01, -0.0015)};
  scene.body.material = {3e4, 0.3, 1000, 10, 2e-3};
  scene.solver = {0.005, Method::DIRECT, 1e-10, 1};
  scene.gravity = Vec3(G, 0, 0);
  if (touching) scene.contact = ContactSettings();
  for (int i = 0; i < tools; ++i) scene.tools.push_back(graspingTool("forceps" + std::to_string(i), grip));
  return scene;
}

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

Pose facingX(double x, double z = 0) { return {Vec3(x, 0, z), Eigen::Quaterniond::Identity()}; }
/// The slab's upper edge lies 12 mm along the jaws.
const Pose AT_EDGE = facingX(-0.012);
/// Its edge at y = −0.01 does, below the jaws that hold the upper edge.
const Pose AT_SIDE = {Vec3(0.014, -0.022, 0), Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitZ()))};

/// A hand that has closed its jaws on the slab before that has fallen far.
std::unique_ptr<Hand> holding(const Scene& scene, int steps = 400) {
  auto hand = std::make_unique<Hand>(scene);
  hand->place(AT_EDGE, OPEN);
  hand->turnJaw(0.03, 2);
  hand->rest(steps);
  return hand;
}

TEST(Grasper, TellsTheWeightOfWhatItHolds) {
  for (const bool touching : {true, false}) {
    const auto held = holding(slab(2, touching));
    Hand& hand = *held;
    EXPECT_EQ(hand.report().gripped, 2);
    EXPECT_LT((hand.report().force - hand.weight()).norm(), 1e-6 * hand.weight().norm()) << touching;
    EXPECT_NEAR(hand.report().force.x(), MASS * G, 1e-6 * MASS * G);
  }
}

TEST(Grasper, LiftsTurnsAndLetsGoOfIt) {
  for (const bool touching : {true, false}) {
    const auto held = holding(slab(2, touching), 20);
    Hand& hand = *held;
    const Vec3 way(-0.05, 0.02, 0.01), before = hand.body.nodePositions()[0];
    hand.carry(way, 60);
    hand.rest(100);
    EXPECT_LT((hand.body.nodePositions()[0] - before - way).norm(), 3e-3);
    EXPECT_GT(hand.report().gripped, 1.9);
    hand.turnJaw(OPEN, 10);
    EXPECT_EQ(hand.report().gripped, 0);
    hand.rest(40);
    EXPECT_EQ(hand.report().force, Vec3::Zero());
    EXPECT_GT((hand.body.nodePositions()[0] - before - way).x(), 0.02);
  }
}

// Without contact nothing else holds it.
TEST(Grasper, TakesTheMomentumThatTheBodyGains) {
  for (const bool touching : {true, false}) {
    Scene scene = slab(0.1, touching, 2);
    scene.body.material.mass_damping = 0;
    Hand hand(scene);
    hand.is_free = true;
    hand.place(AT_EDGE, OPEN);
    hand.turnJaw(0.03, 2);
    hand.carry(Vec3(-0.02, 0.01, 0.01), 20);
    hand.place(AT_SIDE, OPEN, 1);
    hand.turnJaw(0.03, 10, 1);
    hand.carry(Vec3(-0.02, 0.01, 0.01), 4);
    hand.turnJaw(OPEN, 5);
    hand.rest(20);
    EXPECT_GT(hand.largest, 0.05);
  }
}

TEST(Grasper, ReleasedItFallsFromTheNextStepOn) {
  const auto held = holding(slab(2, false));
  Hand& hand = *held;
  hand.turnJaw(CLOSED + 0.01, 1);
  const Vec3 momentum = hand.body.motion().momentum;
  hand.step();
  EXPECT_EQ(hand.report().force, Vec3::Zero());
  const double dt = 0.005, damped = 1 + 10 * dt;
  EXPECT_LT((damped * hand.body.motion().momentum - momentum - dt * hand.weight()).norm(), EXACT * dt * MASS * G);
}

TEST(Grasper, LetsGoWhereItIsSwitchedOffLiftedOrPutElsewhere) {
  const std::vector<std::function<void(DeformableBody*)>> interruptions = {
      [](DeformableBody* body) { body->activateTool(false); }, [](DeformableBody* body) { body->liftTool(); },
      [](DeformableBody* body) { body->placeTool(AT_EDGE); }};
  for (const auto& interrupt : interruptions) {
    const auto held = holding(slab(2, false), 20);
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
  Scene scene = slab(2, false);
  scene.gravity.setZero();
  Hand hand(scene);
  hand.place(AT_EDGE, 0.03);
  hand.rest(5);
  EXPECT_EQ(hand.report().gripped, 0);
  hand.turnJaw(OPEN, 5);
  EXPECT_EQ(hand.report().gripped, 0);
  hand.body.activateTool(false);
  hand.turnJaw(0.03, 5);
  EXPECT_EQ(hand.report().gripped, 0);
  hand.body.activateTool(true);
  hand.turnJaw(OPEN, 5);
  hand.turnJaw(CLOSED, 5);
  EXPECT_EQ(hand.report().gripped, 2);
  EXPECT_LT(hand.energy(), 1e-20);
}

TEST(Grasper, ClosesOnNothingAndOnItself) {
  for (const bool touching : {true, false}) {
    Scene scene = slab(2, touching);
    scene.gravity.setZero();
    Hand hand(scene);
    hand.place(facingX(-0.1), OPEN);
    for (const double angle : {0.03, -0.05, OPEN, -1.0, 0.0}) hand.turnJaw(angle, 3);
    EXPECT_EQ(hand.report().gripped, 0);
    EXPECT_EQ(hand.report().force, Vec3::Zero());
    EXPECT_EQ(hand.report().jaw_torque, 0);
    EXPECT_LT(hand.energy(), 1e-25);
  }
}

// The jaws work against what they press: what the joint gives is in the tissue, but for what the damping takes.
TEST(Grasper, TorqueOfTheJawsIsTheWorkThatTheyDo) {
  for (const bool both : {true, false}) {
    Scene scene = slab(2, true);
    scene.gravity.setZero();
    scene.body.material.mass_damping = 100;
    scene.tools[0].friction = 0;
    scene.boundary = {FAR_END};
    Hand hand(scene, forcepsUrdf({}, both));
    hand.place(facingX(-0.012, both ? 0 : -0.001), OPEN);
    hand.turnJaw(0.15, 20);
    double work = 0;
    const double to = 0.06;  // the grip stays open
    const int steps = 2000;
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
    const auto held = holding(slab(2, touching, 2), 50);
    Hand& hand = *held;
    hand.place(AT_SIDE, OPEN, 1);
    hand.turnJaw(0.03, 30, 1);
    hand.rest(50);
    EXPECT_EQ(hand.report(1).gripped, 2);
    hand.turnJaw(OPEN, 30);
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
    Scene scene = slab(0.2, touching);
    scene.gravity.setZero();
    scene.body.material.mass_damping = 0;
    Hand hand(scene);
    hand.place(AT_EDGE, OPEN);
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
  Scene scene = slab(50, false);
  scene.gravity.setZero();
  scene.boundary = {FAR_END};
  scene.fracture = FractureSettings();
  scene.fracture->tensile_strength = 5e3;
  Hand hand(scene);
  hand.place(AT_EDGE, OPEN);
  hand.turnJaw(0.03, 20);
  hand.carry(Vec3(-0.03, 0, 0), 200);
  EXPECT_GT(hand.body.counts().pieces, 1);
  EXPECT_GT(hand.report().gripped, 40);
  hand.rest(100);
  EXPECT_LT(hand.report().force.norm(), 1e-3);
}

TEST(Grasper, IdleIsAsIfItWereNotThere) {
  Scene with = slab(2, false), without = with;
  without.tools.clear();
  Hand hand(with);
  hand.place(AT_EDGE, OPEN);
  DeformableBody body(without, loadMesh(without));
  run(&body, 2);
  for (int k = 0; k < 20; ++k) {
    hand.step();
    body.step();
    ASSERT_EQ(hand.body.stateHash(), body.stateHash()) << k;
  }
}

std::string refusal(const ToolSettings& tool, const std::string& urdf = forcepsUrdf({})) {
  Scene scene = slab(2, false);
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

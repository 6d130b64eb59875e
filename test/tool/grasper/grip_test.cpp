#include "incision/tool/grasper/grip.h"

#include <gtest/gtest.h>

#include <memory>

#include "incision/cut/point.h"
#include "support/cuts.h"
#include "support/forceps.h"
#include "support/given_springs.h"
#include "support/sanitized.h"

namespace incision::test {
namespace {

constexpr double BALANCED = 1e-10, G = 9.81, CLOSED = 0.1;
/// A step has settled when its forces are as near as that to what they should be.
constexpr double SETTLED = 1e-3;

/// A block whose top is z = 0, hanging below; free.
const Vec3 SIZE(0.02, 0.02, 0.04);
TetMesh hangingBlock(const std::array<int, 3>& cells = {2, 2, 4}) {
  TetMesh mesh = block(cells, SIZE);
  for (Vec3& node : mesh.nodes) node -= Vec3(SIZE.x() / 2, SIZE.y() / 2, SIZE.z());
  return mesh;
}

RigSettings settingsOf(double young_modulus, double time_step, Method method = Method::DIRECT, double damping = 20) {
  RigSettings settings;
  settings.material = {young_modulus, 0.3, 1000, damping, 0};
  settings.conditions.gravity = Vec3(0, 0, -G);
  settings.solver = {time_step, method, 1e-10, 1};
  return settings;
}

/// Jaws that point downwards from their tool, which stands at `position`.
Pose down(const Vec3& position) { return {position, Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitY()))}; }

/// A body and so many grips, each of a tool of its own, none of which touches it.
struct GripRig : Rig {
  GripRig(TetMesh rest, const RigSettings& settings, double most, int tools = 1, const ForcepsForm& form = {})
      : Rig(std::move(rest), settings), weight(0, 0, 0), mouth(forceps(form), CLOSED) {
    for (int i = 0; i < tools; ++i) {
      tool.push_back(std::make_unique<ToolInStep>());
      grip.push_back(std::make_unique<Grip>(most, mouth, tool.back().get(), materials, mesh));
      list.push_back(grip.back().get());
    }
    couplers = Couplers(list);
    double mass = 0;
    for (const double m : step.assembly().masses()) mass += m;
    weight = mass * settings.conditions.gravity;
  }

  void place(const Pose& pose, int i = 0) {
    tool[i]->groups = {{pose, pose}};
    tool[i]->in_place = true;
  }
  void close(int i = 0) { grip[i]->close(tool[i]->groups[0].to, motion.x); }

  /// Takes a step in which the first tool goes to `pose`. Returns the force on it.
  Vec3 moveTo(const Pose& pose) {
    const Vec3 before = momentum();
    tool[0]->groups[0].to = pose;
    for (auto& each : tool) each->felt = {Wrench()};
    EXPECT_TRUE(advanceWith(this, &couplers));
    tool[0]->groups[0].from = pose;
    Vec3 felt = Vec3::Zero();
    for (auto& each : tool) felt += each->felt[0].force;
    const Vec3 damped = -massDamping() * time_step * momentum();
    largest_force = std::max({largest_force, felt.norm(), weight.norm()});
    EXPECT_LT((momentum() - before - damped - time_step * (weight - felt)).norm(),
              BALANCED * time_step * largest_force);
    return tool[0]->felt[0].force;
  }
  Vec3 rest(int steps = 1) {
    Vec3 force = Vec3::Zero();
    for (int k = 0; k < steps; ++k) force = moveTo(tool[0]->groups[0].to);
    return force;
  }
  double massDamping() const { return materials.massDamping(); }

  /// How far the middle of the body has gone down [m].
  double sunk() const {
    double sum = 0, mass = 0;
    const std::vector<Vec3> u = displacements();
    for (std::size_t c = 0; c < u.size(); ++c) {
      sum -= step.assembly().masses()[c] * u[c].z();
      mass += step.assembly().masses()[c];
    }
    return sum / mass;
  }

  Vec3 weight;
  Mouth mouth;
  std::vector<std::unique_ptr<ToolInStep>> tool;
  std::vector<std::unique_ptr<Grip>> grip;
  std::vector<Coupler*> list;
  Couplers couplers;
  double largest_force = 0;
};

const Vec3 ABOVE(0, 0, 0.005);  // of the tool: the jaws reach 15 mm into the block

const std::vector<double> STEPS = SANITIZED ? std::vector<double>{0.01} : std::vector<double>{0.001, 0.005, 0.02};
const std::vector<double> MODULI = SANITIZED ? std::vector<double>{1e4} : std::vector<double>{3e3, 3e4, 1e6};

constexpr double WEIGHT = 0.016 * G;

/// A block that hangs at rest from a strong grip.
void hang(GripRig* rig) {
  rig->place(down(ABOVE));
  rig->close();
  rig->rest(static_cast<int>(2.5 / rig->time_step));
}

/// One that hangs so, but from a grip of another strength.
void hangLike(const GripRig& strong, GripRig* rig) {
  rig->place(down(ABOVE));
  rig->motion = strong.motion;
  rig->step.recall(strong.step.keep());
  rig->couplers.recall(strong.couplers.keep());
}

struct Case {
  Method method;
  double time_step, young_modulus;
};
/// Time steps [s] and stiffnesses [Pa].
const std::vector<Case> CASES = SANITIZED
                                    ? std::vector<Case>{{Method::DIRECT, 0.01, 1e4}}
                                    : std::vector<Case>{{Method::DIRECT, 0.001, 3e4},  {Method::DIRECT, 0.005, 3e3},
                                                        {Method::DIRECT, 0.005, 1e6},  {Method::DIRECT, 0.02, 3e3},
                                                        {Method::DIRECT, 0.02, 1e6},   {Method::ITERATIVE, 0.005, 3e3},
                                                        {Method::ITERATIVE, 0.02, 1e6}};

TEST(Grip, HoldsBelowItsStrengthAndTellsTheWeight) {
  for (const auto& [method, dt, E] : CASES) {
    GripRig strong(hangingBlock(), settingsOf(E, dt, method), 100),
        rig(hangingBlock(), settingsOf(E, dt, method), 1.1 * WEIGHT);
    hang(&strong);
    // What the block itself gives way under its weight, and what the grip does.
    EXPECT_LT(strong.sunk(), WEIGHT / (SIZE.x() * E) + 0.1 * G * dt * dt + 1e-4) << dt << " " << E;
    hangLike(strong, &rig);
    rig.rest(static_cast<int>(1 / dt));
    const double before = rig.sunk();
    const Vec3 force = rig.rest(static_cast<int>(0.5 / dt));
    EXPECT_LT((force - rig.weight).norm(), 1e-6 * WEIGHT) << dt << " " << E;
    EXPECT_NEAR(rig.grip[0]->strength(), 1.1 * WEIGHT, 1e-12) << dt << " " << E;
    EXPECT_NEAR(rig.sunk(), before, 1e-6 * before) << dt << " " << E;
  }
}

// All of it slips at once, and falls with what its weight is more than the grip, until the jaws are empty.
TEST(Grip, SlipsAboveItsStrengthByItsStrength) {
  for (const auto& [method, dt, E] : CASES) {
    const double most = 0.9 * WEIGHT;
    GripRig strong(hangingBlock(), settingsOf(E, dt, method), 100),
        rig(hangingBlock(), settingsOf(E, dt, method, 0), most);
    hang(&strong);
    hangLike(strong, &rig);
    double largest = 0, before = rig.sunk();
    while (rig.grip[0]->strength() > 0 && rig.time < 2) {
      largest = std::max(largest, -rig.moveTo(down(ABOVE)).z());
      EXPECT_GE(rig.sunk(), before - 1e-6) << dt << " " << E;
      before = rig.sunk();
    }
    EXPECT_NEAR(largest, most, 1e-2 * most) << dt << " " << E;
    EXPECT_EQ(rig.grip[0]->strength(), 0) << dt << " " << E;
    EXPECT_GT(rig.sunk(), 0.013) << dt << " " << E;
    const double speed = -rig.momentum().z() / 0.016;
    rig.moveTo(down(ABOVE));
    EXPECT_NEAR(-rig.momentum().z() / 0.016 - speed, G * dt, 1e-9);
  }
}

TEST(Grip, ReleasedItFallsAsIfNeverHeld) {
  GripRig held(hangingBlock(), settingsOf(3e4, 0.005), 10);
  held.place(down(ABOVE));
  held.close();
  held.rest(300);
  held.grip[0]->open();
  Rig never(hangingBlock(), settingsOf(3e4, 0.005));
  never.motion = held.motion;
  for (int k = 0; k < 40; ++k) {
    EXPECT_EQ(held.rest(), Vec3::Zero());
    EXPECT_TRUE(never.advance());
    for (std::size_t c = 0; c < never.motion.x.size(); ++c)
      ASSERT_LT((held.motion.x[c] - never.motion.x[c]).norm(), 1e-9) << k;
  }
  EXPECT_NEAR(held.sunk(), 0.5 * G * 0.2 * 0.2, 0.4 * G * 0.2 * 0.2);
}

TEST(Grip, ClosingMovesNothingAndBringsNoEnergy) {
  RigSettings settings = settingsOf(3e4, 0.005);
  settings.conditions.gravity.setZero();
  GripRig rig(hangingBlock(), settings, 10);
  rig.place(down(ABOVE));
  rig.close();
  EXPECT_LT(rig.rest(20).norm(), 1e-12 * 10);
  EXPECT_LT(rig.energy(), 1e-24);
}

// A block that flies by and turns is caught: what it has is no more from step to step, but for what springs give back.
TEST(Grip, CatchesWhatFliesWithoutGivingItEnergy) {
  for (const double most : {0.05, 100.0})
    for (const double dt : STEPS) {
      RigSettings settings = settingsOf(3e4, dt, Method::DIRECT, 0);
      settings.conditions.gravity.setZero();
      GripRig rig(hangingBlock(), settings, most);
      for (std::size_t c = 0; c < rig.motion.x.size(); ++c)
        rig.motion.v[c] = Vec3(0.1, 0.05, 0) + Vec3(3, 2, 1).cross(rig.motion.x[c]);
      const double at_first = rig.energy();
      rig.place(down(ABOVE));
      rig.close();
      for (int k = 0; k < 0.3 / dt; ++k) {
        rig.rest();
        ASSERT_LT(rig.energy(), (1 + 1e-6) * at_first) << most << " " << dt << " " << k;
      }
      if (most > 1) {
        EXPECT_LT(rig.energy(), 0.8 * at_first);
      }
    }
}

// Shorter steps have stiffer springs where a light body hangs on them. These come with the energy that there was.
TEST(Grip, GivesNothingWhereStepsGetShorter) {
  GripRig rig(hangingBlock(), settingsOf(1e6, 0.02), 100);
  hang(&rig);
  const double sunk = rig.sunk(), in_springs = 0.5 * WEIGHT * sunk, before = rig.energy() - WEIGHT * sunk + in_springs;
  for (const double dt : {0.005, 0.005, 0.005, 0.02, 0.001, 0.001, 0.001, 0.001, 0.02, 0.01}) {
    rig.time_step = dt;
    rig.rest();
    ASSERT_LT(rig.energy() - WEIGHT * rig.sunk(), before + 0.05 * in_springs) << dt;
  }
}

TEST(Grip, LiftsAndCarriesAlong) {
  GripRig rig(hangingBlock(), settingsOf(3e4, 0.005), 1);
  rig.place(down(ABOVE));
  rig.close();
  const Vec3 way(0.05, -0.02, 0.1);
  for (int k = 1; k <= 200; ++k) rig.moveTo(down(ABOVE + k / 200.0 * way));
  EXPECT_LT((rig.rest(400) - rig.weight).norm(), 1e-6 * rig.weight.norm());
  Vec3 turned = Vec3::Zero();  // by the weight, about the body's origin
  for (int c = 0; c < rig.mesh.numCopies(); ++c)
    turned += rig.motion.x[c].cross(rig.step.assembly().masses()[c] * Vec3(0, 0, -G));
  EXPECT_LT((rig.tool[0]->felt[0].torque - turned).norm(), 1e-6 * turned.norm());
  for (const Vec3& u : rig.displacements()) EXPECT_LT((u - way).norm(), 2e-3);
  EXPECT_EQ(rig.grip[0]->strength(), 1);
}

// The force turns with the tool.
TEST(Grip, TurnsWithTheTool) {
  RigSettings settings = settingsOf(3e4, 0.005);
  settings.conditions.gravity.setZero();
  GripRig rig(hangingBlock(), settings, 10);
  rig.place(down(ABOVE));
  rig.close();
  const auto turned = [](double angle) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
    return Pose{ABOVE, turn * down(ABOVE).orientation};
  };
  for (int k = 1; k <= 200; ++k) rig.moveTo(turned(k / 200.0));
  rig.rest(400);
  const std::vector<Vec3> X = restPositions(rig.mesh);
  for (std::size_t c = 0; c < X.size(); ++c)
    EXPECT_LT((rig.motion.x[c] - Eigen::AngleAxisd(1, Vec3::UnitZ()) * X[c]).norm(), 1e-5);
}

// What is pulled away at once is left behind, but for what the springs can do: no more than their strength.
TEST(Grip, PulledAwayTenCentimetresInOneStepItDoesNoMoreWorkThanItsStrength) {
  for (const double most : {0.1, 5.0, 1e4})
    for (const double dt : STEPS) {
      RigSettings settings = settingsOf(3e4, dt, Method::DIRECT, 0);
      settings.conditions.gravity.setZero();
      GripRig rig(hangingBlock(), settings, most);
      rig.place(down(ABOVE));
      rig.close();
      double work = 0;
      for (int k = 0; k < 30; ++k) {
        const Vec3 force = rig.moveTo(down(ABOVE + Vec3(0.1, 0, 0)));
        if (k == 0) work -= force.x() * 0.1;
        EXPECT_LE(force.norm(), (1 + SETTLED) * most);
        ASSERT_LT(rig.energy(), (1 + 1e-6) * work) << most << " " << dt << " " << k;
      }
    }
}

TEST(Grip, PassesFromOneToolToAnother) {
  GripRig rig(hangingBlock(), settingsOf(3e4, 0.005), 1, 2);
  rig.place(down(ABOVE), 0);
  // From the side, below the first.
  rig.place({Vec3(-0.015, 0, -0.03), Eigen::Quaterniond::Identity()}, 1);
  rig.close(0);
  rig.rest(200);
  rig.close(1);
  rig.rest(20);
  rig.grip[0]->open();
  rig.rest(500);
  EXPECT_EQ(rig.tool[0]->felt[0].force, Vec3::Zero());
  EXPECT_LT((rig.tool[1]->felt[0].force - rig.weight).norm(), 1e-6 * rig.weight.norm());
  EXPECT_EQ(rig.grip[1]->strength(), 1);
  EXPECT_LT(std::abs(rig.sunk()), 2e-3);
}

// Jaws half in the block, in which a cut then parts what they hold from the rest: this falls.
TEST(Grip, HoldsWhatLiesBetweenTheJawsAlone) {
  GripRig rig(hangingBlock(), settingsOf(3e4, 0.005), 1);
  rig.place(down(ABOVE));
  rig.close();
  ASSERT_TRUE(rig.cut(plane(Vec3(0, 0, -0.0163), Vec3(0.02, 0.05, 1))).changed());
  rig.couplers.changed(rig.mesh);
  ASSERT_EQ(rig.pieces(), 2);
  const double held = 1000 * SIZE.x() * SIZE.y() * 0.0163;
  const Vec3 force = rig.rest(500);
  EXPECT_NEAR(force.z(), -held * G, 0.01 * held * G);
  EXPECT_EQ(rig.grip[0]->strength(), 1);
  EXPECT_GT(rig.sunk(), 0.5);
}

TEST(Grip, OnASlitHoldsBothItsSides) {
  GripRig rig(hangingBlock(), settingsOf(3e4, 0.005), 1);
  ASSERT_TRUE(rig.cut(plane(Vec3(0, 0.0004, 0), Vec3(0.01, 1, 0.02))).changed());
  ASSERT_EQ(rig.pieces(), 2);
  rig.place(down(ABOVE));
  rig.close();
  const Vec3 force = rig.rest(600);
  EXPECT_LT((force - rig.weight).norm(), 1e-6 * rig.weight.norm());
  EXPECT_LT(rig.sunk(), 2e-3);
}

// A crumb without a node inside, between the points of the mouth.
TEST(Grip, HoldsAFragmentThatIsSmallerThanTheJaw) {
  const double size = 2e-4;
  GripRig rig(hangingBlock({1, 1, 1}), settingsOf(3e4, 0.002), 1);
  const Vec3 corner(0.0013, 0.0011, -0.008);
  for (int k = 0; k < 3; ++k) {
    ASSERT_TRUE(rig.cut(plane(corner, Vec3::Unit(k))).changed());
    ASSERT_TRUE(rig.cut(plane(corner + Vec3::Constant(size), Vec3::Unit(k))).changed());
  }
  int pieces = 0;
  const std::vector<int> piece = rig.mesh.copyPieces(&pieces);
  ASSERT_EQ(pieces, 27);
  const auto pieceAt = [&](const Vec3& X) {
    for (std::size_t p = 0; p < rig.mesh.parts().size(); ++p) {
      const Part& part = rig.mesh.parts()[p];
      const Vec3 middle = atRest(rig.mesh, part.element, rig.mesh.centroid(static_cast<int>(p)));
      if ((middle - X).cwiseAbs().maxCoeff() < size / 2) return piece[part.copies[0]];
    }
    return -1;
  };
  const int crumb = pieceAt(corner + Vec3::Constant(size / 2));
  ASSERT_GE(crumb, 0);
  rig.place(down(ABOVE + corner + Vec3(0, 0, 0.002)));
  rig.close();
  rig.rest(100);
  for (int c = 0; c < rig.mesh.numCopies(); ++c)
    if (piece[c] == crumb) {
      EXPECT_LT(rig.displacements()[c].norm(), 1e-3);
    }
}

TEST(Grip, OnNothingHoldsNothing) {
  GripRig rig(hangingBlock(), settingsOf(3e4, 0.01), 1);
  rig.place(down(ABOVE + Vec3(0.05, 0, 0)));
  rig.close();
  EXPECT_EQ(rig.grip[0]->strength(), 0);
  EXPECT_EQ(rig.rest(10), Vec3::Zero());
}

}  // namespace
}  // namespace incision::test

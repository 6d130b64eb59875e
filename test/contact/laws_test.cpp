#include <gtest/gtest.h>

#include <cmath>

#include "support/closed_surface.h"
#include "support/contacts.h"
#include "support/rig.h"
#include "support/sanitized.h"

namespace incision::test {
namespace {

const double G = 9.81;

struct Touched {
  double deepest = 0;  // over all steps [m]
  int count = 0;       // of the last
};

Touched take(DeformableBody* body, int steps) {
  Touched run;
  for (int k = 0; k < steps; ++k) {
    const ContactReport touched = body->step().contact;
    run.deepest = std::max(run.deepest, touched.deepest);
    run.count = touched.count;
  }
  return run;
}

double fastest(const DeformableBody& body) {
  double speed = 0;
  for (const Vec3& v : body.velocities()) speed = std::max(speed, v.norm());
  return speed;
}

double lowest(const DeformableBody& body) {
  double z = std::numeric_limits<double>::infinity();
  for (const Vec3& p : surfacePositions(body.surface(), body.positions())) z = std::min(z, p.z());
  return z;
}

TEST(Contact, LetsABlockRestOnTheGround) {
  const Scene scene = blockAbove(0, {4, 4, 4}, Vec3(0, 0, 0.01));
  DeformableBody body(scene, loadMesh(scene));
  EXPECT_EQ(take(&body, 1).count, 0);
  take(&body, 400);
  const Touched rest = take(&body, 10);
  EXPECT_EQ(rest.count, 25);
  EXPECT_LT(rest.deepest, 0.01 * ELEMENT);
  EXPECT_LT(fastest(body), 1e-4);
  // The step reckons with where the body would be but for its turn, of 1e-5 at most.
  EXPECT_NEAR(lowest(body), -rest.deepest, 1e-10);
}

TEST(Contact, LetsAPlateRestOnASphere) {
  Scene scene = blockAbove(-1, {8, 8, 1}, Vec3(-0.2, -0.2, 0.301));
  scene.body.material.young_modulus = 1e4;  // it drapes itself, and so cannot slide off
  scene.solver.time_step = 0.01;
  DeformableBody body = bodyAmong(scene, urdfOf("<sphere radius='0.3'/>"));
  take(&body, 500);
  const Touched rest = take(&body, 10);
  EXPECT_GT(rest.count, 20);
  EXPECT_LT(rest.deepest, 0.01 * ELEMENT);
  EXPECT_LT(fastest(body), 1e-3);
  for (const Vec3& x : body.positions()) EXPECT_GT(x.norm(), 0.3 - 0.01 * ELEMENT);
}

// What a force on each point would be is seen in the momentum that it stops.
TEST(Contact, StopsTheFastestFallWithinATenthOfAnElement) {
  for (const double speed : {1.0, 7.0}) {
    Scene scene = blockAbove(0, {4, 4, 4}, Vec3(0, 0, 0.5 * speed * speed / G));
    scene.solver.time_step = 0.5 * ELEMENT / speed;
    DeformableBody body(scene, loadMesh(scene));
    const Touched run = take(&body, static_cast<int>(1.5 * speed / G / scene.solver.time_step));
    EXPECT_GT(run.deepest, 0);
    EXPECT_LT(run.deepest, 0.1 * ELEMENT) << speed;
  }
}

// A block on a slope: gravity is turned instead of the ground.
double slideAlong(double slope, double friction, double duration) {
  Scene scene = blockAbove(0, {4, 4, 2}, Vec3::Zero());
  scene.gravity = G * Vec3(std::sin(slope), 0, -std::cos(slope));
  scene.contact->friction = friction;
  DeformableBody body(scene, loadMesh(scene));
  // It settles with gravity turned on, so only what comes after counts.
  take(&body, 200);
  const Vec3 before = centreOfMass(body);
  const double v = body.motion().momentum.x() / body.motion().mass;
  take(&body, static_cast<int>(duration / scene.solver.time_step));
  return (centreOfMass(body) - before).x() - v * duration;
}

/// In a second at an acceleration, by backward Euler.
double distance(double a) { return 0.5 * a * (1 + 0.005); }

TEST(Friction, HoldsABlockBelowItsAngleAndLetsItSlideAbove) {
  for (const double friction : {0.2, 0.5}) {
    EXPECT_LT(std::abs(slideAlong(std::atan(0.98 * friction), friction, 1)), 1e-5);
    const double slope = std::atan(1.02 * friction);
    const double a = G * (std::sin(slope) - friction * std::cos(slope));
    EXPECT_NEAR(slideAlong(slope, friction, 1), distance(a), 0.1 * distance(a));
  }
}

TEST(Friction, SlowsAFastBlockAsCoulombSays) {
  const double friction = 0.4, slope = std::atan(0.8);
  const double a = G * (std::sin(slope) - friction * std::cos(slope));
  EXPECT_NEAR(slideAlong(slope, friction, 1), distance(a), 0.02 * distance(a));
  EXPECT_NEAR(slideAlong(slope, 0, 1), distance(G * std::sin(slope)), 1e-6);
}

TEST(Friction, IsTheSameOnATiltedBox) {
  const double slope = std::atan(0.5);
  for (const double share : {0.98, 1.02}) {
    Scene scene = blockAbove(-10, {4, 4, 2}, Vec3(-0.1, -0.1, 0));
    scene.gravity = G * Vec3(std::sin(slope), 0, -std::cos(slope));
    scene.contact->friction = 0.5 / share;
    DeformableBody body = bodyAmong(scene, urdfOf("<box size='4 4 1'/>", "0 0 -0.5"));
    take(&body, 200);
    const double start = centreOfMass(body).x();
    take(&body, 100);
    const double moved = centreOfMass(body).x() - start;
    if (share < 1)
      EXPECT_LT(std::abs(moved), 1e-5);
    else
      EXPECT_GT(moved, 1e-3);
  }
}

TEST(Contact, LetsAStackOfThreeCutPiecesStand) {
  Scene scene = blockAbove(0, {4, 4, 6}, Vec3::Zero());
  scene.cuts = {{0, plane(Vec3(0.1, 0.1, 0.09), Vec3(0.05, 0, 1))}, {0, plane(Vec3(0.1, 0.1, 0.21), Vec3(0, 0.05, 1))}};
  DeformableBody body(scene, loadMesh(scene));
  take(&body, 200);
  const Vec3 start = centreOfMass(body);
  const Touched run = take(&body, SANITIZED ? 400 : 1800);  // to 3 or 10 s
  EXPECT_EQ(body.counts().pieces, 3);
  EXPECT_LT(run.deepest, 0.01 * ELEMENT);
  EXPECT_LT((centreOfMass(body) - start).norm(), 0.01 * ELEMENT);
  EXPECT_LT(fastest(body), 1e-4);
}

// Each of the pieces hangs on contacts alone: what a step leaves of its balance would shake it in the next one.
TEST(Contact, LeavesNextToNothingToSolveInAStackThatRests) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const std::vector<Vec3> tilt = randomVectors(2, 0.05, seed);
    Scene scene = blockAbove(0, {4, 4, 6}, Vec3::Zero());
    scene.solver.method = Method::ITERATIVE;
    scene.solver.tolerance = 1e-4;
    scene.cuts = {{0, plane(Vec3(0.1, 0.1, 0.09), Vec3::UnitZ() + tilt[0])},
                  {0, plane(Vec3(0.1, 0.1, 0.21), Vec3::UnitZ() + tilt[1])}};
    DeformableBody body(scene, loadMesh(scene));
    take(&body, 400);
    int iterations = 0, solves = 0;
    body.wantWrenches(true);
    const double weight = body.motion().mass * G;
    for (int k = 0; k < 100; ++k) {
      const Vec3 before = body.motion().momentum;
      const StepResult result = body.step();
      iterations += result.iterations;
      solves += result.solves;
      // Also what a step leaves because it is too little to solve for.
      const Vec3 force = Vec3(0, 0, -weight) - body.wrenches().ground.force;
      ASSERT_LT((body.motion().momentum - before - scene.solver.time_step * force).norm(),
                1e-12 * scene.solver.time_step * weight)
          << seed;
    }
    EXPECT_EQ(body.counts().pieces, 3);
    EXPECT_LE(solves, 90) << seed;
    EXPECT_LE(iterations, 200) << seed;
  }
}

/// Energies of a body that touches itself and the ground [J].
struct Energies {
  explicit Energies(const DeformableBody& body, double springs = 0) {
    const BodyMotion motion = body.motion();
    stored = motion.kinetic_energy + motion.elastic_energy + springs;
    whole = stored + motion.mass * G * centreOfMass(body).z();
  }
  double stored, whole;
};

/// The most that pieces of a body store at any time, as a share of what the fall can give, for each of some seeds;
/// ascending.
std::vector<double> mostStored(unsigned seeds, int steps) {
  std::vector<double> most;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    const Scene scene = fallingToPieces(1e6, 3, 4, seed);
    DeformableBody body(scene, loadMesh(scene));
    const double potential = Energies(body).whole;
    most.push_back(0);
    for (int k = 0; k < steps; ++k) {
      const double springs = body.step().contact.energy;
      most.back() = std::max(most.back(), Energies(body, springs).stored / potential);
    }
    EXPECT_GT(body.counts().pieces, 8) << seed;
  }
  std::sort(most.begin(), most.end());
  return most;
}

// Pieces that fall and rub are chaotic, so one run tells nothing. Stiffer ones do store more than that.
TEST(Contact, StoresNoMoreThanTheFallGives) {
  const std::vector<double> most = mostStored(SANITIZED ? 1 : 12, 20);
  EXPECT_LT(most.back(), 1);
  EXPECT_LT(most[most.size() / 2], 0.5);
}

TEST(FullContact, StoresNoMoreThanTheFallGives) {
  const std::vector<double> most = mostStored(60, 60);
  EXPECT_LT(most.back(), 1);
  EXPECT_LT(most[most.size() / 2], 0.5);
}

TEST(Contact, LetsABodyCutInTwoRestOnItself) {
  Scene scene = blockAbove(0, {4, 4, 4}, Vec3::Zero());
  DeformableBody body(scene, loadMesh(scene));
  take(&body, 300);
  const Vec3 before = centreOfMass(body);
  EXPECT_EQ(body.cut(plane(Vec3(0.1, 0.1, 0.11), Vec3::UnitZ())).status, CutStatus::APPLIED);
  take(&body, 300);
  const Touched rest = take(&body, 10);
  EXPECT_LT(rest.deepest, 0.01 * ELEMENT);
  EXPECT_LT((centreOfMass(body) - before).norm(), 0.01 * ELEMENT);
  EXPECT_LT(fastest(body), 1e-4);
}

// Free bodies cut all over, in motion as a rigid body: nothing presses.
TEST(Contact, GivesNoForceAtAFreshCut) {
  for (const bool turning : {false, true}) {
    Scene scene = blockAbove(-10, {4, 4, 4}, Vec3::Zero());
    scene.gravity.setZero();
    DeformableBody body(scene, loadMesh(scene));
    if (turning) {  // set down hard and lifted again: a body at rest that is deformed
      take(&body, 3);
    }
    EXPECT_EQ(body.cut(plane(Vec3(0.1, 0.1, 0.11), Vec3(0.3, 0.1, 1))).status, CutStatus::APPLIED);
    EXPECT_EQ(body.cut(plane(Vec3(0.09, 0.1, 0.1), Vec3(1, 0.2, 0))).status, CutStatus::APPLIED);
    EXPECT_EQ(body.cut(rectangle(Vec3(0.1, 0.2, 0.1), Vec3(0, 0.2, 1), Vec3::UnitX(), 0, 0.2)).status,
              CutStatus::APPLIED);
    EXPECT_EQ(take(&body, 20).count, 0);
    EXPECT_LT(fastest(body), 1e-12);
  }
}

// Two halves pressed on each other by the ground and a moving box do not pass through each other.
TEST(Contact, LetsFacesBornTogetherOpenAndNeverCross) {
  Scene scene = blockAbove(-10, {4, 4, 4}, Vec3::Zero());
  scene.gravity.setZero();
  scene.boundary = {{{Vec3(-1, -1, -1e-6), Vec3(1, 1, 1e-6)}, Vec3::Zero()},
                    {{Vec3(-1, -1, 0.2 - 1e-6), Vec3(1, 1, 1)}, Vec3(0.02, 0, -0.04)}};
  scene.cuts = {{0, plane(Vec3(0.1, 0.1, 0.1), Vec3(0.2, 0, 1))}};
  DeformableBody closing(scene, loadMesh(scene));
  EXPECT_LT(take(&closing, 100).deepest, 0.02 * ELEMENT);  // squeezed by 0.02 m of 0.2 m
  EXPECT_GT(take(&closing, 1).count, 20);
  // Without contact they would have crossed: hardly any elastic energy.
  EXPECT_GT(closing.motion().elastic_energy, 0.5 * 0.5 * 1e5 * std::pow(0.02 / 0.2, 2) * std::pow(0.2, 3));

  scene.boundary[1].velocity = Vec3(0, 0, 0.1);
  DeformableBody opening(scene, loadMesh(scene));
  EXPECT_EQ(take(&opening, 100).count, 0);
  EXPECT_LT(opening.motion().elastic_energy, 1e-2);
}

// Momentum of two halves thrown at each other.
TEST(Contact, KeepsTheMomentumBetweenFragments) {
  Scene scene = blockAbove(-10, {4, 2, 2}, Vec3::Zero());
  scene.gravity.setZero();
  scene.cuts = {{0, plane(Vec3(0.1, 0.05, 0.05), Vec3(1, 0.3, 0.1))}};
  // Loads push both ends towards each other, the left one harder.
  scene.loads = {{{Vec3(-1, -1, -1), Vec3(1e-6, 1, 1)}, Vec3(3000, 0, 0), 0},
                 {{Vec3(0.2 - 1e-6, -1, -1), Vec3(1, 1, 1)}, Vec3(-1000, 200, 0), 0}};
  DeformableBody body(scene, loadMesh(scene));
  int touched = 0;
  for (int k = 1; k <= 100; ++k) {
    touched += body.step().contact.count > 0;
    const Vec3 impulse = body.time() * 0.01 * Vec3(2000, 200, 0);  // faces of 0.1 × 0.1 m
    ASSERT_LT((body.motion().momentum - impulse).norm(), 1e-10 * impulse.norm()) << k;
  }
  EXPECT_GT(touched, 20);
}

TEST(Contact, LetsNothingThroughAThinPlate) {
  for (const double share : {0.2, 1.0}) {  // of an element in a step
    Scene scene = blockAbove(-10, {2, 2, 2}, Vec3(-0.05, -0.05, 0.5));
    const double speed = share * ELEMENT / scene.solver.time_step;
    scene.gravity = Vec3(0, 0, -speed * speed / (2 * 0.5));
    DeformableBody body = bodyAmong(scene, urdfOf("<box size='1 1 0.001'/>"));
    take(&body, 300);
    for (const Vec3& x : body.positions()) ASSERT_GT(x.z(), -0.001 / 2) << share;  // nothing has come out below
  }
}

// Over many runs: a step in which the pieces' contacts have not settled may lift it by a little.
TEST(Contact, LetsEnergyFall) {
  int steps = 0, rises = 0;
  double highest = 0;
  for (unsigned seed = 0; seed < (SANITIZED ? 1 : 12); ++seed) {
    const Scene scene = fallingToPieces(1e5, 4, 2, seed);
    DeformableBody body(scene, loadMesh(scene));
    const double whole = Energies(body).whole;
    double last = whole;
    for (int k = 0; k < 60; ++k) {
      const double springs = body.step().contact.energy, now = Energies(body, springs).whole;
      ++steps;
      rises += now > last + 1e-6 * whole;
      highest = std::max(highest, now / whole);
      last = now;
    }
  }
  EXPECT_LE(100 * rises, steps);
  EXPECT_LT(highest, 1 + 1e-6);
}

TEST(Contact, CarriesABodyOnAMovingObstacle) {
  Scene scene = blockAbove(-10, {4, 4, 2}, Vec3(-0.1, -0.1, 0.5));
  scene.contact->friction = 1;
  DeformableBody body = bodyAmong(scene, urdfOf("<box size='1 1 1'/>"));
  take(&body, 200);
  const Vec3 before = centreOfMass(body);
  for (int k = 1; k <= 200; ++k) {
    const double s = 0.5 * (1 - std::cos(M_PI * k / 200));
    body.moveObstacle(0, {Vec3(0.2 * s, 0, 0.1 * s), Eigen::Quaterniond::Identity()});
    body.step();
  }
  take(&body, 200);
  EXPECT_LT((centreOfMass(body) - before - Vec3(0.2, 0, 0.1)).norm(), 0.02 * ELEMENT);
}

TEST(Contact, IsForgottenByAReset) {
  Scene scene = blockAbove(0, {4, 4, 4}, Vec3(0, 0, 0.01));
  scene.cuts = {{0.1, plane(Vec3(0.1, 0.1, 0.11), Vec3(0.3, 0.1, 1))}};
  DeformableBody body = bodyAmong(scene, urdfOf("<sphere radius='0.05'/>", "0.1 0.1 0"));
  const int steps = SANITIZED ? 30 : 100;
  take(&body, steps);
  const std::uint64_t hash = body.stateHash();
  body.moveObstacle(0, {Vec3(0, 0, 0.1), Eigen::Quaterniond::Identity()});
  take(&body, 10);
  body.reset();
  take(&body, steps);
  EXPECT_EQ(body.stateHash(), hash);
}

TEST(Contact, GivesTheSameBitsWhateverTheThreads) {
  Scene scene = blockAbove(0, {6, 6, 6}, Vec3(0, 0, 0.01));
  scene.solver.method = Method::ITERATIVE;
  scene.cuts = {{0.05, plane(Vec3(0.1, 0.1, 0.11), Vec3(0.3, 0.1, 1))}};
  std::uint64_t hash = 0;
  for (const int threads : {1, 2, 4}) {
    scene.solver.threads = threads;
    DeformableBody body(scene, loadMesh(scene));
    take(&body, SANITIZED ? 20 : 60);
    if (threads == 1) hash = body.stateHash();
    EXPECT_EQ(body.stateHash(), hash);
  }
}

}  // namespace
}  // namespace incision::test

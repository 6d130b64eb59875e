#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <string>

#include "support/rig.h"

namespace incision {
namespace {

// A bar clamped at x = 0 and loaded across at x = L: with ν = 0 the clamp takes nothing from beam theory.
constexpr double E = 1e6, L = 1, H = 0.2, TRACTION = 1;
constexpr double P = TRACTION * H * H, I = H * H * H * H / 12, A = H * H;
constexpr double G = E / 2, KAPPA = 10.0 / 12;

constexpr double BENDING = P * L * L * L / (3 * E * I), SHEAR = P * L / (KAPPA * G * A);

// `n` cells across and 5 n along: cubes.
TetMesh bar(int n) { return block({5 * n, n, n}, Vec3(L, H, H)); }

RigSettings clamped() {
  RigSettings settings = statics(E, 0);
  settings.conditions.clamps = {{slab(0, 0), Vec3::Zero()}};
  return settings;
}

// Mean displacement along z of the copies at x = L whose rest position a test accepts.
double endDeflection(const Rig& rig, const std::function<bool(int copy)>& accepts) {
  double sum = 0;
  int count = 0;
  const std::vector<Vec3> u = rig.displacements();
  for (int c = 0; c < rig.mesh.numCopies(); ++c) {
    const int node = rig.mesh.copyNode(c);
    if (rig.mesh.mesh().nodes[node].x() < L - 1e-9 || !accepts(c)) continue;
    sum += u[c].z();
    ++count;
  }
  EXPECT_GT(count, 0);
  return sum / count;
}

bool ownCopies(const Rig& rig, int c) { return rig.mesh.ownCopy(rig.mesh.copyNode(c)) == c; }

// Relative errors of the stiffness over meshes, each half as coarse as the next. Linear tetrahedra are too stiff by
// O(h²) of the beam's height in cells.
struct Convergence {
  std::vector<double> errors;
  double fine() const { return errors.back(); }
  double order() const { return std::log2(errors[errors.size() - 2] / errors.back()); }
  double extrapolated() const { return errors.back() + (errors.back() - errors[errors.size() - 2]) / 3; }
};

Convergence study(const std::vector<int>& cells, double answer, const std::function<double(int n)>& deflection) {
  Convergence result;
  for (int n : cells) {
    const auto start = std::chrono::steady_clock::now();
    result.errors.push_back(answer / deflection(n) - 1);
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    ::testing::Test::RecordProperty("error_" + std::to_string(n), std::to_string(result.errors.back()));
    ::testing::Test::RecordProperty("ms_" + std::to_string(n), std::to_string(ms));
  }
  ::testing::Test::RecordProperty("order", std::to_string(result.order()));
  ::testing::Test::RecordProperty("error_extrapolated", std::to_string(result.extrapolated()));
  return result;
}

void expectConvergence(const Convergence& c, double order, double fine, double extrapolated) {
  EXPECT_GT(c.order(), order);
  EXPECT_LT(std::abs(c.fine()), fine);
  EXPECT_LT(std::abs(c.extrapolated()), extrapolated);
}

double cantilever(int n) {
  RigSettings settings = clamped();
  settings.conditions.loads = {{slab(0, L), Vec3(0, 0, TRACTION), 0}};
  Rig rig(bar(n), settings);
  EXPECT_TRUE(rig.advance());
  return endDeflection(rig, [](int) { return true; });
}

// The same bar cut along its mid-plane: through the elements where n is odd, along faces where it is even.
double splitCantilever(int n) {
  RigSettings settings = clamped();
  settings.conditions.loads = {{slab(0, L), Vec3(0, 0, TRACTION), 0}};
  Rig rig(bar(n), settings);
  const Insertion done = rig.cut(plane(Vec3(0, 0, H / 2), Vec3::UnitZ()));
  EXPECT_EQ(done.parts_split > 0, n % 2 == 1);
  EXPECT_EQ(rig.pieces(), 2);
  EXPECT_TRUE(rig.advance());
  return endDeflection(rig, [&](int c) { return ownCopies(rig, c); });
}

TEST(Cantilever, ConvergesToTimoshenko) {
  expectConvergence(study({2, 4, 8}, BENDING + SHEAR, cantilever), 1.9, 0.06, 0.005);
}

TEST(Cantilever, FullConvergesToTimoshenko) {
  expectConvergence(study({4, 8, 16}, BENDING + SHEAR, cantilever), 1.95, 0.015, 0.002);
}

// Each half has an eighth of the second moment and half of the load, and half as many cells across.
constexpr double SPLIT = 4 * BENDING + SHEAR;

TEST(SplitCantilever, AlongFacesHasFourTimesTheBending) {
  expectConvergence(study({2, 4, 8}, SPLIT, splitCantilever), 1.9, 0.25, 0.015);
}

TEST(SplitCantilever, FullAlongFacesHasFourTimesTheBending) {
  expectConvergence(study({4, 8, 16}, SPLIT, splitCantilever), 1.95, 0.06, 0.005);
}

TEST(SplitCantilever, ThroughElementsIsAsGoodAsAlongFaces) {
  const double along = SPLIT / splitCantilever(8) - 1;
  for (const int n : {5, 9}) {
    const double through = SPLIT / splitCantilever(n) - 1;
    RecordProperty("error_" + std::to_string(n), std::to_string(through));
    // The same constant of h².
    EXPECT_NEAR(through * n * n / (along * 64), 1, 0.05);
  }
}

// A double cantilever beam whose uncracked end is held up to the crack's front, so that the arms are clamped there.
// Its arms, of height H/2, are pulled apart by the shear of their end faces. Returns the opening of one arm.
double doubleCantileverBeam(int n, double crack) {
  RigSettings settings = clamped();
  settings.conditions.clamps[0].place.box.max.x() = L - crack + 1e-9;
  RestBox upper = slab(0, L), lower = upper;
  upper.min.z() = H / 2 - 1e-9;
  lower.max.z() = H / 2 + 1e-9;
  settings.conditions.loads = {{upper, Vec3(0, 0, TRACTION), 0}, {lower, Vec3(0, 0, -TRACTION), 0}};
  Rig rig(bar(n), settings);
  const PlaneCut slit = rectangle(Vec3(L, H / 2, H / 2), Vec3::UnitZ(), Vec3::UnitX(), 2 * crack, 0);
  EXPECT_TRUE(rig.cut(slit).changed());
  EXPECT_EQ(rig.pieces(), 1);
  EXPECT_TRUE(rig.advance());
  const auto above = [&](int c) { return rig.mesh.mesh().nodes[rig.mesh.copyNode(c)].z() > H / 2 + 1e-9; };
  const auto below = [&](int c) { return rig.mesh.mesh().nodes[rig.mesh.copyNode(c)].z() < H / 2 - 1e-9; };
  const double opening = endDeflection(rig, above);
  EXPECT_NEAR(opening, -endDeflection(rig, below), 0.02 * opening);  // the mesh has no mirror plane
  return opening;
}

// P a³/3EI + P a/κGA of one arm, h = H/2, with half of P.
double armOpening(double a) {
  const double arm_P = P / 2, arm_I = I / 8, arm_A = A / 2;
  return arm_P * a * a * a / (3 * E * arm_I) + arm_P * a / (KAPPA * G * arm_A);
}

TEST(DoubleCantileverBeam, OpensAsItsArmsBend) {
  const double a = 0.8 * L;
  expectConvergence(study({2, 4, 8}, armOpening(a), [a](int n) { return doubleCantileverBeam(n, a); }), 1.9, 0.25,
                    0.015);
}

// G = (P²/B)(a²/EI + 1/κGA) is P/B times the growth of one arm's opening with the crack.
TEST(DoubleCantileverBeam, ReleasesItsEnergy) {
  const double a = 0.7 * L, arm_P = P / 2;
  const double answer = arm_P * arm_P / H * (a * a / (E * I / 8) + 1 / (KAPPA * G * A / 2));
  const auto released = [&](int n) {
    return arm_P / H * (doubleCantileverBeam(n, 0.8 * L) - doubleCantileverBeam(n, 0.6 * L)) / (0.2 * L);
  };
  expectConvergence(study({2, 4, 8}, answer, released), 1.9, 0.25, 0.015);
}

}  // namespace
}  // namespace incision

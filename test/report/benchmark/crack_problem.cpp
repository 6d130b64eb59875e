#include "report/benchmark/crack_problem.h"

#include <cmath>

#include "report/mean_edge.h"
#include "support/penny_crack.h"

namespace incision::report {
namespace {

constexpr double PI = 3.14159265358979323846;
constexpr double STRESS = 1e6;  // [Pa]

/// A disc of 2 m with this normal, under a tension of 1 MPa along z. The answers are those of Tada, Paris, Irwin, The
/// Stress Analysis of Cracks Handbook; code_aster's manual quotes them for SSLV159.
CrackProblem penny(const char* name, const char* published, const Vec3& normal) {
  constexpr double RADIUS = 2, E = 200e9, NU = 0.3;
  CrackProblem problem{name, published, RoundCrack(RADIUS, 0, normal, Vec3::Zero()), Mat3::Zero(), E, NU, {}, true};
  problem.stress(2, 2) = STRESS;
  const Mat3 axes = problem.crack.axes(0, 0);
  const Vec3 traction = problem.stress * axes.col(1);
  const double tension = traction.dot(axes.col(1)), shear = traction.dot(axes.col(0));
  const double root = std::sqrt(RADIUS / PI);
  const Intensities K = {2 * tension * root, 4 / (2 - NU) * shear * root, 4 * (1 - NU) / (2 - NU) * shear * root};
  problem.answer = K;
  problem.rate = (1 - NU * NU) / E * (K[0] * K[0] + K[1] * K[1] / 2) + (1 + NU) / E * K[2] * K[2] / 2;
  // The jump is 8 (1 − ν²)/(π E) (tension, 2 shear/(2 − ν)) √(a² − ρ²).
  const double volume = 16 * (1 - NU * NU) * std::pow(RADIUS, 3) / (3 * E);
  const Vec3 jump = volume * (tension * axes.col(1) + 2 / (2 - NU) * shear * axes.col(0));
  problem.moment = jump * axes.col(1).transpose();
  return problem;
}

}  // namespace

CrackProblem CrackProblem::scaled(double by) const {
  CrackProblem other = *this;
  other.crack = crack.scaled(by);
  if (moment) other.moment = std::pow(by, 3) * *moment;
  return other;
}

CrackProblem straightPenny() { return penny("penny", "SSLV134", Vec3::UnitZ()); }

// The normal makes 45° with the tension; seen from above it points between the directions of the grid.
CrackProblem inclinedPenny() {
  constexpr double ASIDE = 25 * PI / 180;
  return penny("inclined penny", "SSLV159", Vec3(std::cos(ASIDE), std::sin(ASIDE), 1));
}

// The answer is that of Pereira and others, Int. J. Numer. Meth. Engng 77:601–633, 2009, as code_aster's manual quotes
// it.
CrackProblem lens() {
  constexpr double SPHERE = 2, ANGLE = PI / 4, E = 210e9, NU = 0.22;
  const double radius = SPHERE * std::sin(ANGLE), rise = SPHERE * (1 - std::cos(ANGLE));
  const double unit = 2 * STRESS * std::sqrt(radius / PI);
  return {"lens",
          "SSLV155",
          RoundCrack(radius, ANGLE, Vec3::UnitZ(), Vec3(0, 0, rise / 2)),
          STRESS * Mat3::Identity(),
          E,
          NU,
          {0.877 * unit, 0.235 * unit, 0},
          false};
}

Block blockRound(const RoundCrack& crack, int cells) {
  const double radius = crack.radius();
  Block block{gradedBlock(cells), BLOCK_HALF * radius, 0};
  for (Vec3& X : block.mesh.nodes) X *= radius;
  block.edge = meanEdge(block.mesh, {Vec3::Constant(-FINE_HALF * radius), Vec3::Constant(FINE_HALF * radius)});
  return block;
}

Vec3 uniformField(const CrackProblem& problem, const Vec3& X) {
  const double nu = problem.poisson_ratio;
  return ((1 + nu) * problem.stress * X - nu * problem.stress.trace() * X) / problem.young_modulus;
}

Vec3 farField(const CrackProblem& problem, const Mat3& moment, const Vec3& X) {
  const double nu = problem.poisson_ratio, mu = problem.young_modulus / (2 * (1 + nu)), r = X.norm();
  const Mat3 strain = (moment + moment.transpose()) / 2;
  const Mat3 M = 2 * mu * (strain + nu / (1 - 2 * nu) * strain.trace() * Mat3::Identity());
  const Vec3 n = X / r;
  const Vec3 turned = (2 - 4 * nu) * M * n - M.trace() * n + 3 * n.dot(M * n) * n;
  return turned / (16 * PI * mu * (1 - nu) * r * r);
}

}  // namespace incision::report

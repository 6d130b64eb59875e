#include "report/dynamic/oscillation.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>

#include "report/dynamic/schemes.h"
#include "support/rig.h"

namespace incision::report {
namespace {

using Complex = std::complex<double>;

/// What a step multiplies y = q − i q'/ω by, of the equation y' = i ω y with z = i ω Δt.
Complex formula(const std::string& scheme, Complex z) {
  const double gamma = 1 - std::sqrt(0.5);
  if (scheme == "BDF2") return (2.0 + std::sqrt(1.0 + 2.0 * z)) / (3.0 - 2.0 * z);
  if (scheme == "implicit midpoint") return (1.0 + z / 2.0) / (1.0 - z / 2.0);
  if (scheme == "SDIRK2") return (1.0 + (1 - 2 * gamma) * z) / ((1.0 - gamma * z) * (1.0 - gamma * z));
  return 1.0 / (1.0 - z);
}

/// A clamped bar of linear elements and the first of its modes K φ = ω² M φ.
struct SwingingMode {
  SwingingMode() : rig(makeRig(0.01)), copies(rig.freeCopies()), M(matrix({1, 0})) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(matrix({0, 1}), M);
    omega = std::sqrt(modes.eigenvalues()[0]);
    shape = modes.eigenvectors().col(0);
  }

  static RigSettings settings(double time_step) {
    RigSettings result;
    result.warping = false;
    result.solver.time_step = time_step;
    result.conditions.clamps = {{slab(0, 0), Vec3::Zero()}};
    return result;
  }
  static Rig makeRig(double time_step) { return Rig(block({8, 2, 2}, Vec3(1, 0.25, 0.25)), settings(time_step)); }

  Eigen::MatrixXd matrix(const SystemFactors& factors) const {
    return systemMatrix(rig.step.assembly(), factors, copies);
  }

  /// y of a rig.
  Complex amplitude(const Rig& moving) const {
    const std::vector<Vec3> u = moving.displacements();
    Eigen::VectorXd x(3 * copies.size()), v(3 * copies.size());
    for (std::size_t i = 0; i < copies.size(); ++i) {
      x.segment<3>(3 * i) = u[copies[i]];
      v.segment<3>(3 * i) = moving.motion.v[copies[i]];
    }
    return {shape.dot(M * x), -shape.dot(M * v) / omega};
  }

  Rig rig;
  std::vector<int> copies;
  Eigen::MatrixXd M;
  double omega = 0;
  Eigen::VectorXd shape;
};

/// What a step multiplies y by, once the formula's other solutions have died away.
Complex measured(const SwingingMode& mode, const Scheme& scheme, double phase_step) {
  constexpr int STEPS = 30;  // BDF2's other solution falls by a factor of three or more a step
  Rig rig = SwingingMode::makeRig(phase_step / mode.omega);
  for (std::size_t i = 0; i < mode.copies.size(); ++i)
    rig.motion.x[mode.copies[i]] += 1e-3 * mode.shape.segment<3>(3 * i);
  const TakeStep advance = scheme.make();
  Complex before = 0, now = mode.amplitude(rig);
  for (int k = 0; k < STEPS; ++k) {
    if (!advance(k * rig.time_step, rig.time_step, &rig.step, &rig.motion)) return 0;
    before = std::exchange(now, mode.amplitude(rig));
  }
  return now / before;
}

nlohmann::json afterAPeriod(Complex factor, double phase_step) {
  const double steps = 2 * M_PI / phase_step;
  return {{"amplitude", std::pow(std::abs(factor), steps)}, {"period", phase_step / std::arg(factor)}};
}

}  // namespace

nlohmann::json freeOscillation() {
  const SwingingMode mode;
  nlohmann::json curves = nlohmann::json::array();
  for (const Scheme& scheme : {eulerScheme(), bdf2Scheme(), midpointScheme(), sdirk2Scheme()}) {
    nlohmann::json points = nlohmann::json::array();
    for (const double share : {0.1, 0.05, 0.02, 0.01, 0.005}) {
      const double phase_step = 2 * M_PI * share;
      const Complex exact = formula(scheme.name, {0, phase_step}), found = measured(mode, scheme, phase_step);
      points.push_back({{"step_over_period", share},
                        {"off", std::abs(found / exact - 1.0)},
                        {"measured", afterAPeriod(found, phase_step)},
                        {"formula", afterAPeriod(exact, phase_step)}});
    }
    curves.push_back({{"name", scheme.name}, {"points", points}});
  }
  return curves;
}

}  // namespace incision::report

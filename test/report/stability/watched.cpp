#include "watched.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "reference.h"

namespace incision::report {
namespace {

/// Relative residual that a backward stable factorisation leaves beside the rounding of the forces.
constexpr double DIRECT_TOLERANCE = 1e-12;

}  // namespace

bool allFinite(const Motion& motion) {
  const auto finite = [](const Vec3& v) { return v.allFinite(); };
  return std::all_of(motion.x.begin(), motion.x.end(), finite) && std::all_of(motion.v.begin(), motion.v.end(), finite);
}

RigSettings freeBody(Method method) {
  RigSettings settings;
  settings.material = {1e5, 0.3, 1000, 0, 0};
  settings.solver = {0.01, method, 1e-6, 1};
  return settings;
}

void throwApart(Watched* body, double speed) {
  body->motion.v = randomVectors(body->motion.v.size(), speed, 7);
  body->startWatching();
}

Watched::Watched(TetMesh rest, const RigSettings& settings) : Rig(std::move(rest), settings), settings_(settings) {
  startWatching();
}

double Watched::mass() const {
  const std::vector<double>& masses = step.assembly().masses();
  return std::accumulate(masses.begin(), masses.end(), 0.0);
}

double Watched::totalEnergy() const {
  double fallen = 0;
  for (std::size_t c = 0; c < motion.x.size(); ++c)
    fallen += step.assembly().masses()[c] * settings_.conditions.gravity.dot(motion.x[c]);
  return energy() - fallen;
}

Vec3 Watched::angularMomentum() const {
  const std::vector<double>& masses = step.assembly().masses();
  Vec3 centre = Vec3::Zero(), sum = Vec3::Zero();
  for (std::size_t c = 0; c < masses.size(); ++c) centre += masses[c] / mass() * motion.x[c];
  for (std::size_t c = 0; c < masses.size(); ++c) sum += masses[c] * (motion.x[c] - centre).cross(motion.v[c]);
  return sum;
}

void Watched::startWatching() {
  first_energy_ = totalEnergy();
  first_kinetic_ = largest_kinetic_ = kineticEnergy();
  largest_energy_ = energy();
  largest_rise_ = largest_drift_ = 0;
  largest_speed_ = largest(motion.v);
  first_momentum_ = momentum();
  first_time_ = time;
}

void Watched::take(int steps, int reference_every, const std::function<void()>& each) {
  for (int k = 0; k < steps && watch_.finite; ++k) {
    if (each) each();
    const Motion before = motion;
    watch_.finite = advance() && allFinite(motion);
    if (!watch_.finite) return;
    ++watch_.steps;
    iterations_ += step.stats().iterations;
    watch_.iterations = iterations_ / watch_.steps;
    watchSums();
    if (reference_every > 0 && watch_.steps % reference_every == 0) compare(before);
  }
}

void Watched::watchSums() {
  const double rise = totalEnergy() - first_energy_, kinetic = kineticEnergy();
  largest_energy_ = std::max(largest_energy_, energy());
  largest_rise_ = std::max(largest_rise_, rise);
  largest_kinetic_ = std::max(largest_kinetic_, kinetic);
  if (largest_energy_ > 0) watch_.growth = largest_rise_ / largest_energy_;
  if (first_kinetic_ > 0) watch_.kinetic_growth = largest_kinetic_ / first_kinetic_ - 1;
  const Vec3 expected = first_momentum_ + (time - first_time_) * mass() * settings_.conditions.gravity;
  largest_speed_ = std::max(largest_speed_, largest(motion.v));
  largest_drift_ = std::max(largest_drift_, (momentum() - expected).norm());
  if (largest_speed_ > 0) watch_.drift = largest_drift_ / (mass() * largest_speed_);
}

void Watched::compare(const Motion& before) {
  const double tolerance = settings_.solver.method == Method::DIRECT ? DIRECT_TOLERANCE : settings_.solver.tolerance;
  const StepResidual residual = stepResidual(*this, settings_, before, tolerance);
  watch_.residual = std::max(watch_.residual, residual.relative);
  watch_.residual_share = std::max({watch_.residual_share, residual.share, residual.off_place});
}

void Flights::fly(Watched* body, int steps, int reference_every) {
  throwApart(body);
  body->take(steps, reference_every);
  Kept& kept = body->settings().solver.method == Method::DIRECT ? direct_ : iterative_;
  ++kept.flights;
  kept.residual.add(body->seen().residualIfFinite());
  kept.drift.add(body->seen().drift);
  kept.growth.add(body->seen().growth);
}

void Flights::report(Matrix* matrix, const std::string& name) const {
  for (const Method method : METHODS) {
    const bool direct = method == Method::DIRECT;
    const Kept& kept = direct ? direct_ : iterative_;
    if (kept.flights == 0) continue;
    const std::string with = name + ", " + nameOf(method);
    addResidual(matrix, with + ": residual", kept.residual.figure());
    addMomentum(matrix, with + ": momentum", kept.drift.figure());
    addGrowth(matrix, with + ": energy growth", kept.growth.figure());
  }
}

}  // namespace incision::report

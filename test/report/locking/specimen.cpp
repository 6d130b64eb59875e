#include "report/locking/specimen.h"

#include <algorithm>

#include "report/clock.h"
#include "support/loads.h"

namespace incision::report {
namespace {

constexpr int THREADS = 2;

RigSettings atRest(const Problem& problem, double poisson_ratio, Pressure pressure) {
  RigSettings settings = statics(YOUNG_MODULUS, poisson_ratio);
  settings.pressure = pressure;
  settings.conditions = {Vec3::Zero(), problem.clamps, problem.loads};
  return settings;
}

RigSettings inMotion(const Problem& problem, double poisson_ratio, Pressure pressure) {
  RigSettings settings;
  settings.material = {YOUNG_MODULUS, poisson_ratio, 1000, 0, 0};
  settings.pressure = pressure;
  settings.conditions = {Vec3::Zero(), problem.clamps, problem.loads};
  settings.solver.threads = THREADS;
  return settings;
}

}  // namespace

Specimen::Specimen(const Problem& problem, TetMesh rest, double poisson_ratio, Pressure pressure,
                   const std::vector<PlaneCut>& cuts)
    : Rig(std::move(rest), atRest(problem, poisson_ratio, pressure)), problem_(problem) {
  for (const PlaneCut& plane : cuts) cut(plane);
  if (!advance()) throw std::runtime_error("no solution");
}

double Specimen::answer() const {
  if (problem_.plate()) {
    double moved = 0;
    for (const Clamp& clamp : problem_.clamps) moved += clamp.velocity.norm();
    return 2 * step.assembly().elasticEnergy(motion.x) / moved;
  }
  const std::vector<Vec3> forces = loadForces(mesh, problem_.loads.front()), u = displacements();
  double work = 0;
  Vec3 force = Vec3::Zero();
  for (std::size_t c = 0; c < u.size(); ++c) {
    work += forces[c].dot(u[c]);
    force += forces[c];
  }
  return work / force.norm();
}

int Specimen::blocks() const {
  BlockPattern pattern;
  findPattern(step.assembly(), freeCopies(), &pattern);
  return static_cast<int>(pattern.column.size());
}

StepCost stepCost(const Problem& problem, const TetMesh& mesh, double poisson_ratio, Pressure pressure, Method method,
                  int steps) {
  constexpr int BEFORE = 3;
  RigSettings settings = inMotion(problem, poisson_ratio, pressure);
  for (Load& load : settings.conditions.loads) load.traction *= 10;
  settings.solver.method = method;
  Rig rig(mesh, settings);
  std::vector<double> milliseconds, iterations;
  for (int n = 0; n < BEFORE + steps; ++n) {
    if (!rig.advance()) throw std::runtime_error("a step has failed");
    if (n < BEFORE) continue;
    const StepTimes& times = rig.step.times();
    milliseconds.push_back(times.assembly + times.solve + times.update);
    iterations.push_back(rig.step.stats().iterations);
  }
  return {median(milliseconds), median(iterations)};
}

CutEffect cutUnderLoad(const Problem& problem, const TetMesh& mesh, double poisson_ratio, Pressure pressure,
                       const PlaneCut& cut) {
  RigSettings settings = inMotion(problem, poisson_ratio, pressure);
  settings.solver.method = Method::DIRECT;
  settings.warping = false;  // as the loaded state was found
  Rig rig(mesh, settings);
  rig.motion.x = Specimen(problem, mesh, poisson_ratio, pressure).motion.x;
  const auto elastic = [&] { return rig.step.assembly().elasticEnergy(rig.motion.x); };
  const double before = elastic();
  rig.cut(cut);
  const double added = elastic() - before;
  if (!rig.advance()) throw std::runtime_error("a step has failed");
  return {added / before, rig.kineticEnergy() / before};
}

}  // namespace incision::report

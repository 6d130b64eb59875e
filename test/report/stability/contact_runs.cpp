#include "contact_runs.h"

#include <algorithm>
#include <limits>

#include "incision/contact/body_contact.h"
#include "support/contacts.h"
#include "support/given_springs.h"
#include "support/overlap.h"

namespace incision::report {
namespace {

/// The depth of fragments in each other is measured in every so many steps.
constexpr int OVERLAP_EVERY = 10;

double energyOf(const DeformableBody& body, double springs) {
  const BodyMotion motion = body.motion();
  return motion.kinetic_energy + motion.elastic_energy + motion.potential_energy + springs;
}

void addOverlap(const Surface& surface, const std::vector<Vec3>& positions, Ensemble* seen) {
  const std::vector<Vec3> x = surfacePositions(surface, positions);
  seen->overlap.add(test::Overlap(surface, x).deepest() / test::ELEMENT);
  ++seen->overlaps;
}

/// Holds a body's momentum against the impulses of gravity, the ground and tools whose axes are the body's.
class MomentumWatch {
 public:
  explicit MomentumWatch(const DeformableBody& body) : expected_(body.motion().momentum) { watchSpeed(body); }

  void step(const DeformableBody& body, const StepResult& step, Ensemble* seen) {
    const BodyMotion motion = body.motion();
    Vec3 force = motion.mass * body.live().gravity - body.wrenches().ground.force;
    for (const ToolReport& tool : step.tools) force -= tool.force;
    expected_ += body.scene().solver.time_step * force;
    watchSpeed(body);
    const double drift = (motion.momentum - expected_).norm();
    seen->momentum.add(drift > 0 ? drift / (motion.mass * fastest_) : drift);
  }

 private:
  void watchSpeed(const DeformableBody& body) { fastest_ = std::max(fastest_, largest(body.velocities())); }

  Vec3 expected_;
  double fastest_ = 0;
};

/// One step with just the weight that gives it the speed: it moves all of the body alike.
void throwDown(DeformableBody* body, double speed) {
  const LiveSettings before = body->live();
  LiveSettings live = before;
  live.gravity = Vec3(0, 0, -speed / body->scene().solver.time_step);
  body->set(live);
  body->step();
  body->set(before);
}

}  // namespace

Ensemble runOf(const GroundRun& run) {
  Scene scene = run.scene;
  const double before = run.speed * scene.solver.time_step;
  scene.body.grid->origin.z() += before;
  if (run.speed > 0)
    for (ScheduledCut& cut : scene.cuts) cut.plane.point.z() += before;
  DeformableBody body(scene, loadMesh(scene));
  body.wantWrenches(true);
  if (run.speed > 0) throwDown(&body, run.speed);
  Ensemble seen;
  seen.runs = 1;
  EnergyWatch energy(energyOf(body, 0), &seen);
  MomentumWatch momentum(body);
  try {
    for (int k = 1; k <= run.steps; ++k) {
      const StepResult step = body.step();
      energy.step(energyOf(body, step.contact.energy), step.settled, step.solves);
      momentum.step(body, step, &seen);
      if (run.measures_overlap && k % OVERLAP_EVERY == 0) addOverlap(body.surface(), body.positions(), &seen);
    }
  } catch (const StepFailed&) {
    ++seen.failed;
  }
  return seen;
}

namespace {

/// Sets a piece of a body spinning about a random axis: of those that are no crumbs the one nearest to the middle.
void spinMiddle(Watched* body, double spin, unsigned seed) {
  const std::vector<double>& masses = body->step.assembly().masses();
  const std::vector<int>& piece_of = body->step.pieceOf();
  const double crumb = 0.05 * body->mass();
  std::vector<double> mass(body->step.pieces(), 0);
  std::vector<Vec3> centre(mass.size(), Vec3::Zero());
  Vec3 middle = Vec3::Zero();
  for (std::size_t c = 0; c < masses.size(); ++c) {
    mass[piece_of[c]] += masses[c];
    centre[piece_of[c]] += masses[c] * body->motion.x[c];
    middle += masses[c] / body->mass() * body->motion.x[c];
  }
  for (std::size_t p = 0; p < mass.size(); ++p) centre[p] /= mass[p];
  const auto off = [&](std::size_t p) {
    return mass[p] > crumb ? (centre[p] - middle).norm() : std::numeric_limits<double>::infinity();
  };
  std::size_t chosen = 0;
  for (std::size_t p = 1; p < mass.size(); ++p)
    if (off(p) < off(chosen)) chosen = p;
  const Vec3 axis = spin * randomVectors(1, 1, seed + 200)[0].normalized();
  for (std::size_t c = 0; c < masses.size(); ++c)
    if (piece_of[c] == static_cast<int>(chosen)) body->motion.v[c] = axis.cross(body->motion.x[c] - centre[chosen]);
}

}  // namespace

Ensemble spinningPiece(const Touching& touching, double spin, int steps, unsigned seed) {
  const Scene scene = fallingBlock(touching, 0, seed);
  RigSettings settings = freeBody(scene.solver.method);
  settings.material = scene.body.material;
  settings.solver = scene.solver;
  Watched body(loadMesh(scene), settings);
  for (const ScheduledCut& cut : scene.cuts) body.cut(cut.plane);
  spinMiddle(&body, spin, seed);

  ContactSettings alone = *scene.contact;
  alone.ground.reset();
  const CurrentSurface surface(body.mesh);
  ContactSkin skin(surface, body.materials, 1);
  const Obstacles obstacles = loadObstacles(alone, "", "");
  const std::vector<RigidMotion> none;
  BodyContact contact(alone, obstacles, none, &skin);
  Couplers couplers({&contact});
  couplers.changed(body.mesh);

  Ensemble seen;
  seen.runs = 1;
  EnergyWatch energy(body.energy(), &seen);
  const Vec3 momentum = body.momentum(), turning = body.angularMomentum();
  for (int k = 1; k <= steps; ++k) {
    SolveStats solved;
    if (!advanceWith(&body, &couplers, &solved) || !allFinite(body.motion)) {
      ++seen.failed;
      break;
    }
    energy.step(body.energy() + contact.report().energy, solved.settled, solved.solves);
    seen.momentum.add((body.momentum() - momentum).norm() / (body.mass() * largest(body.motion.v)));
    seen.spin.add((body.angularMomentum() - turning).norm() / turning.norm());
    if (k % OVERLAP_EVERY == 0) addOverlap(surface.get(), body.motion.x, &seen);
  }
  return seen;
}

}  // namespace incision::report

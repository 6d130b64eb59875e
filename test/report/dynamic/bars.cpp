#include "report/dynamic/bars.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "report/clock.h"

namespace incision::report {
namespace {

const Vec3 SIZE(1, 0.25, 0.25);

/// Farther than this from the origin a body has flown off [m].
constexpr double FLOWN_OFF = 100;

/// Places of a grid's nodes in a grid `every` times as fine.
std::vector<int> coarseNodes(int cells, int every) {
  const int across = cells * every + 1, along = 4 * cells * every + 1;
  std::vector<int> nodes;
  for (int k = 0; k < across; k += every)
    for (int j = 0; j < across; j += every)
      for (int i = 0; i < along; i += every) nodes.push_back(i + along * (j + across * k));
  return nodes;
}

std::vector<Vec3> nodePositions(const Rig& rig) {
  std::vector<Vec3> x;
  for (int n = 0; n < static_cast<int>(rig.mesh.mesh().nodes.size()); ++n)
    x.push_back(rig.motion.x[rig.mesh.ownCopy(n)]);
  return x;
}

}  // namespace

Bar swingingBar(double young_modulus) { return {"swinging", young_modulus, true, 9.81}; }

Bar twistingBar() {
  return {"twisting", 1e6, true, 0,
          [](const Vec3& X) -> Vec3 { return 20 * X.x() * Vec3::UnitX().cross(X - SIZE / 2); }};
}

Bar spinningBar(double young_modulus) {
  return {"spinning", young_modulus, false, 0,
          [](const Vec3& X) -> Vec3 { return Vec3(10, 0, 5).cross(X - SIZE / 2); }};
}

Run simulate(const Bar& bar, const Scheme& scheme, const Choice& choice) {
  RigSettings settings;
  settings.material = {bar.young_modulus, 0.45, 1000, 0, 0};
  settings.mass = choice.mass;
  settings.warping = choice.warping;
  settings.solver = {choice.time_step, choice.method, choice.tolerance, 2};
  settings.conditions.gravity = Vec3(0, 0, -bar.gravity);
  if (bar.clamped) settings.conditions.clamps = {{slab(0, 0), Vec3::Zero()}};
  Rig rig(block({4 * choice.cells, choice.cells, choice.cells}, SIZE), settings);
  for (std::size_t c = 0; c < rig.motion.x.size(); ++c)
    if (rig.step.held()[c] < 0) rig.motion.v[c] = bar.velocity(rig.motion.x[c]);

  const int steps = static_cast<int>(std::lround(DURATION / choice.time_step));
  const int every = static_cast<int>(std::lround(SAMPLE / choice.time_step));
  const double first = rig.energy();
  Run run;
  run.rest = rig.mesh.mesh().nodes;
  const TakeStep advance = scheme.make();
  for (int k = 0; k < steps && run.done; ++k) {
    const Clock clock;
    run.done = advance(k * choice.time_step, choice.time_step, &rig.step, &rig.motion);
    run.ms += clock.ms();
    run.iterations += static_cast<double>(rig.step.stats().iterations) / steps;
    for (const Vec3& x : rig.motion.x) run.done = run.done && x.norm() < FLOWN_OFF;
    if (bar.gravity == 0) run.energy_growth = std::max(run.energy_growth, rig.energy() / first - 1);
    if ((k + 1) % every == 0) run.samples.push_back(nodePositions(rig));
  }
  return run;
}

double errorAgainst(const Run& reference, int reference_cells, const Run& run, int run_cells, int cells) {
  if (!run.done) return std::numeric_limits<double>::infinity();
  const std::vector<int> theirs = coarseNodes(cells, reference_cells / cells),
                         ours = coarseNodes(cells, run_cells / cells);
  double error = 0, displacement = 0;
  for (std::size_t s = 0; s < reference.samples.size(); ++s) {
    double difference = 0, moved = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
      const Vec3& x = reference.samples[s][theirs[i]];
      difference += (run.samples[s][ours[i]] - x).squaredNorm();
      moved += (x - reference.rest[theirs[i]]).squaredNorm();
    }
    error = std::max(error, difference);
    displacement = std::max(displacement, moved);
  }
  return std::sqrt(error / displacement);
}

}  // namespace incision::report

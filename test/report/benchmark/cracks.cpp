// Round cracks that end in the body: K_I, K_II and K_III by the jump behind the front, and the energy release rate.
#include "report/benchmark/cracks.h"

#include <cmath>

#include "report/benchmark/crack_problem.h"
#include "report/benchmark/jumps.h"
#include "report/clock.h"
#include "report/mean_edge.h"

namespace incision::report {
namespace {

using nlohmann::json;

constexpr double PI = 3.14159265358979323846;
/// The energy release rate is a mean over the growth of a crack between these shares of its radius.
constexpr double SMALLER = 0.8, LARGER = 1.2;
constexpr const char* MODES[] = {"K_I", "K_II", "K_III"};

struct Solution {
  double ms = 0;  ///< wall time
  int freedoms = 0;
  json rays;                   ///< jumps along them
  Mat3 moment = Mat3::Zero();  ///< ∫ [u] ⊗ n dA [m³]
};

/// The body starts strained as it is far away; on the block's surface, which is held, it also has what the crack adds.
void strain(const CrackProblem& problem, const Block& block, const Mat3& moment, Rig* rig) {
  for (Vec3& x : rig->motion.x) {
    const Vec3 X = x;
    x += uniformField(problem, X);
    if (X.cwiseAbs().maxCoeff() > block.half * (1 - 1e-9)) x += farField(problem, moment, X);
  }
}

Solution solveOnce(const CrackProblem& problem, const Block& block, double longer, const Mat3& moment) {
  RigSettings settings = statics(problem.young_modulus, problem.poisson_ratio);
  settings.solver.method = Method::AUTO;
  settings.solver.threads = 2;
  for (int axis = 0; axis < 3; ++axis)
    for (double side : {-1, 1}) settings.conditions.clamps.push_back({slab(axis, side * block.half), Vec3::Zero()});
  Solution solution;
  const Clock clock;
  Rig rig(block.mesh, settings);
  const std::vector<Vec3> rest = rig.motion.x;
  strain(problem, block, moment, &rig);
  const Insertion done = rig.cut(problem.crack.field(rig.mesh, rest, longer));
  if (!rig.advance()) throw InputError(problem.name + ": could not be solved");
  solution.ms = clock.ms();
  solution.freedoms = 3 * rig.mesh.numCopies();
  const Jumps jumps(rig, done, problem.crack);
  solution.moment = jumps.moment();
  solution.rays = alongRays(jumps, problem.crack);
  return solution;
}

/// Where the crack's moment is not known, it is that of a first solve.
Solution solve(const CrackProblem& problem, const Block& block, double longer) {
  if (problem.moment) return solveOnce(problem, block, longer, *problem.moment);
  const Solution first = solveOnce(problem, block, longer, Mat3::Zero());
  Solution solution = solveOnce(problem, block, longer, first.moment);
  solution.ms += first.ms;
  return solution;
}

/// The energy [J] that the crack releases, half the work of the stress far away on its opening.
double released(const CrackProblem& problem, const Solution& solution) {
  return problem.stress.cwiseProduct(solution.moment).sum() / 2;
}

/// Error of the energy release rate, by the growth of the crack; it rises in proportion to the radius.
json errorOfRate(const CrackProblem& problem, const Block& block, double longer) {
  const CrackProblem small = problem.scaled(SMALLER), large = problem.scaled(LARGER);
  const Solution before = solve(small, block, longer), after = solve(large, block, longer);
  const double grown = PI * (std::pow(large.crack.radius(), 2) - std::pow(small.crack.radius(), 2));
  const double mean = 2.0 / 3 * (std::pow(LARGER, 3) - std::pow(SMALLER, 3)) /
                      (std::pow(LARGER, 2) - std::pow(SMALLER, 2));  // of the rates, over that at the radius
  const double rate = (released(large, after) - released(small, before)) / grown / mean;
  return {{"value", rate}, {"error", rate / *problem.rate - 1}, {"ms", before.ms + after.ms}};
}

json point(const CrackProblem& problem, int cells, bool longer) {
  const Block block = blockRound(problem.crack, cells);
  const double by = longer ? MISSING_EDGES * block.edge : 0;
  const Solution solution = solve(problem, block, by);
  json found = {{"cells", cells},
                {"edge", block.edge / problem.crack.radius()},
                {"freedoms", solution.freedoms},
                {"ms", solution.ms},
                {"rays", solution.rays}};
  if (problem.rate) found["G"] = errorOfRate(problem, block, by);
  return found;
}

/// Jumps of the straight penny where the block's surface is held as the uniform stress alone would have it.
json withoutFarField(int cells) {
  const CrackProblem problem = straightPenny();
  return {{"cells", cells}, {"rays", solveOnce(problem, blockRound(problem.crack, cells), 0, Mat3::Zero()).rays}};
}

json describe(const CrackProblem& problem) {
  const auto rows = [](const Mat3& of) {
    json found;
    for (int i = 0; i < 3; ++i) found.push_back({of(i, 0), of(i, 1), of(i, 2)});
    return found;
  };
  json of = {{"name", problem.name},
             {"published", problem.published},
             {"radius", problem.crack.radius()},
             {"flat", problem.crack.isFlat()},
             {"young_modulus", problem.young_modulus},
             {"poisson_ratio", problem.poisson_ratio},
             {"sheared", problem.sheared},
             {"stress", rows(problem.stress)}};
  for (int mode = 0; mode < 3; ++mode) of["answers"][MODES[mode]] = problem.answer[mode];
  if (problem.rate) of["answers"]["G"] = *problem.rate;
  if (!problem.crack.isFlat()) return of;
  const Vec3 first = problem.crack.axes(0, 0).col(0), across = problem.crack.axes(0, 0).col(1);
  Mat3 axes;  // two in the crack's plan, and its own
  axes << first, across.cross(first), across;
  of["axes"] = rows(axes);
  of["moment"] = rows(*problem.moment);
  return of;
}

}  // namespace

json roundCracks(bool quick) {
  const std::vector<int> sizes = quick ? std::vector<int>{13, 19, 27} : std::vector<int>{13, 19, 27, 39, 55};
  json problems;
  for (const CrackProblem& problem : {straightPenny(), inclinedPenny(), lens()}) {
    json curves;
    for (const bool longer : {false, true}) {
      json points;
      for (const int cells : sizes) points.push_back(point(problem, cells, longer));
      curves.push_back({{"code", "incision"}, {"longer", longer}, {"points", points}});
    }
    json of = describe(problem);
    of["curves"] = curves;
    problems.push_back(of);
  }
  return {{"problems", problems},
          {"uniform", withoutFarField(sizes.back())},
          {"rays", RAYS},
          {"places", RAY_PLACES},
          {"length", RAY_LENGTH}};
}

}  // namespace incision::report

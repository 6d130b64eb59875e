#include "report/dynamic/schemes.h"

#include <cmath>
#include <memory>
#include <optional>

#include "incision/solver/backward_difference.h"

namespace incision::report {
namespace {

using Values = std::vector<Vec3>;

/// a + s b.
Values sum(const Values& a, double s, const Values& b) {
  Values result = a;
  for (std::size_t c = 0; c < a.size(); ++c) result[c] += s * b[c];
  return result;
}

/// a + s (b − a).
Values beyond(const Values& a, double s, const Values& b) {
  Values result = a;
  for (std::size_t c = 0; c < a.size(); ++c) result[c] += s * (b[c] - a[c]);
  return result;
}

Motion beyond(const Motion& a, double s, const Motion& b) { return {beyond(a.x, s, b.x), beyond(a.v, s, b.v)}; }

/// A step of implicit Euler with the rotations at these positions.
bool advanceTurned(double time, double time_step, const Values& turned, ImplicitStep* step, Motion* motion) {
  step->begin(time_step, *motion);
  step->rotate(turned);
  return step->advance(time, motion);
}

}  // namespace

Scheme eulerScheme() {
  return {"implicit Euler", [] {
            return [](double time, double time_step, ImplicitStep* step, Motion* motion) {
              step->begin(time_step, *motion);
              return step->advance(time, motion);
            };
          }};
}

Scheme bdf2Scheme() {
  return {"BDF2", [] {
            const auto past = std::make_shared<BackwardDifference>();
            return [past](double time, double time_step, ImplicitStep* step, Motion* motion) {
              return past->advance(time, time_step, step, motion);
            };
          }};
}

Scheme newtonScheme(int iterations) {
  return {"Euler, " + std::to_string(iterations) + " Newton iterations", [iterations] {
            return [iterations](double time, double time_step, ImplicitStep* step, Motion* motion) {
              const Motion start = *motion;
              step->begin(time_step, *motion);
              if (!step->advance(time, motion)) return false;
              for (int k = 1; k < iterations; ++k) {
                const Values end = motion->x;
                *motion = start;
                if (!advanceTurned(time, time_step, end, step, motion)) return false;
              }
              return true;
            };
          }};
}

Scheme midpointScheme() {
  return {"implicit midpoint", [] {
            return [](double time, double time_step, ImplicitStep* step, Motion* motion) {
              const Motion start = *motion;
              const Values middle = sum(start.x, time_step / 2, start.v);
              if (!advanceTurned(time, time_step / 2, middle, step, motion)) return false;
              *motion = beyond(start, 2, *motion);
              return true;
            };
          }};
}

Scheme sdirk2Scheme() {
  return {"SDIRK2", [] {
            return [](double time, double time_step, ImplicitStep* step, Motion* motion) {
              const double gamma = 1 - std::sqrt(0.5), h = gamma * time_step;
              const Motion start = *motion;
              const Values first = sum(start.x, h, start.v);
              if (!advanceTurned(time, h, first, step, motion)) return false;
              const Values v = beyond(start.v, 1 / gamma, motion->v);
              *motion = beyond(start, (1 - gamma) / gamma, *motion);
              const Values second = sum(motion->x, h, v);
              return advanceTurned(time + time_step - h, h, second, step, motion);
            };
          }};
}

Scheme verletScheme() {
  return {"Verlet", [] {
            const auto assembly = std::make_shared<std::optional<Assembly>>();
            return [assembly](double /*time*/, double time_step, ImplicitStep* step, Motion* motion) {
              const std::vector<double>& masses = step->assembly().masses();
              Values forces;
              const auto kick = [&] {
                (*assembly)->rotate(motion->x);
                (*assembly)->elasticForces(motion->x, &forces);
                for (std::size_t c = 0; c < forces.size(); ++c) motion->v[c] -= time_step / 2 / masses[c] * forces[c];
              };
              if (!*assembly) {
                const Assembly& given = step->assembly();
                assembly->emplace(given.mesh(), given.materials(), Mass::LUMPED, Pressure::ELEMENT, true, 1);
                (*assembly)->topologyChanged(motion->x);
              }
              kick();
              motion->x = sum(motion->x, time_step, motion->v);
              kick();
              return true;
            };
          }};
}

std::vector<Scheme> schemesOf(bool held) {
  std::vector<Scheme> schemes = {eulerScheme(), bdf2Scheme(), newtonScheme(2)};
  if (held) schemes.insert(schemes.end(), {midpointScheme(), sdirk2Scheme()});
  return schemes;
}

}  // namespace incision::report

#include "incision/solver/settings.h"

#include "incision/base/yaml_reader.h"

namespace incision {

SolverSettings parseSolver(const YamlValue& value) {
  const YamlMap map = value.map({"time_step", "method", "tolerance", "threads", "integrator", "iterations", "tension"});
  SolverSettings solver;
  solver.time_step = map.number("time_step", solver.time_step, SolverSettings::TIME_STEP);
  if (const auto method = map.find("method")) {
    solver.method =
        method->choice<Method>({{"auto", Method::AUTO}, {"direct", Method::DIRECT}, {"iterative", Method::ITERATIVE}});
  }
  solver.tolerance = map.number("tolerance", solver.tolerance, SolverSettings::TOLERANCE);
  if (const auto threads = map.find("threads")) solver.threads = threads->integer(1, SolverSettings::MAX_THREADS);
  if (const auto integrator = map.find("integrator"))
    solver.integrator = integrator->choice<Integrator>({{"euler", Integrator::EULER}, {"bdf2", Integrator::BDF2}});
  if (const auto iterations = map.find("iterations"))
    solver.iterations = iterations->integer(1, SolverSettings::MAX_ITERATIONS);
  if (const auto tension = map.find("tension")) {
    solver.tension = tension->choice<TensionScheme>(
        {{"auto", TensionScheme::AUTO}, {"implicit", TensionScheme::IMPLICIT}, {"explicit", TensionScheme::EXPLICIT}});
  }
  return solver;
}

}  // namespace incision

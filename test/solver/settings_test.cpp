#include "incision/solver/settings.h"

#include <gtest/gtest.h>

#include "support/section.h"

namespace incision {
namespace {

TEST(SolverSettings, ArriveFromTheirSection) {
  const SolverSettings solver = parseSolver(test::section(
      "solver",
      "{time_step: 0.005, method: iterative, tolerance: 1.0e-8, threads: 3, integrator: bdf2, iterations: 7}"));
  EXPECT_EQ(solver.time_step, 0.005);
  EXPECT_EQ(solver.method, Method::ITERATIVE);
  EXPECT_EQ(solver.tolerance, 1e-8);
  EXPECT_EQ(solver.threads, 3);
  EXPECT_EQ(solver.integrator, Integrator::BDF2);
  EXPECT_EQ(solver.iterations, 7);
  EXPECT_FALSE(parseSolver(test::section("solver", "{time_step: 0.005}")).iterations);
}

TEST(SolverSettings, BadValuesAreRefused) {
  test::expectRefused(
      parseSolver, "solver",
      {{"5", ": '5' (allowed: a map with time_step, method, tolerance, threads, integrator, iterations, tension)"},
       {"{time_step: 0}", ".time_step"},
       {"{time_step: 2}", ".time_step"},
       {"{tolerance: 1}", ".tolerance"},
       {"{threads: 65}", ".threads: '65' (allowed: a whole number, 1 to 64)"},
       {"{method: fast}", ".method: 'fast' (allowed: auto, direct, iterative)"},
       {"{iterations: 0}", ".iterations: '0' (allowed: a whole number, 1 to 1000000)"},
       {"{integrator: fast}", ".integrator: 'fast' (allowed: bdf2, euler)"},
       {"{methd: auto}",
        ".methd: unknown key, did you mean method? (allowed: time_step, method, tolerance, threads, integrator, "
        "iterations, tension)"},
       {"{tension: none}", ".tension: 'none' (allowed: auto, explicit, implicit)"}});
}

}  // namespace
}  // namespace incision

// The pieces of a step, one by one, on bent bars of 12,288 and 98,304 tetrahedra and two threads.
//
// Each reports its time, ns an element, GB/s and the share of the memory's bandwidth, which STREAM's triad measures at
// the start of the same run. The bytes are those that must move whatever the layout: every input read once, every
// result written once. So GB/s is a lower bound of what a kernel moved, and a small body that stays in the caches may
// pass the triad. What the core's headers inline is compiled for any x86-64 here, the library for this processor.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <iostream>

#include "benchmark/bent_bar.h"
#include "benchmark/triad.h"
#include "incision/base/parallel.h"
#include "incision/contact/fragments.h"
#include "incision/fem/rotation.h"
#include "incision/solver/coarse_space.h"
#include "incision/solver/direct_solver.h"
#include "incision/solver/implicit_step.h"
#include "incision/surface/surface.h"

namespace {

using namespace incision;
using bench::Bar;
using bench::bent;
using bench::Matrix;
using bench::THREADS;
using bench::TIME_STEP;
using ::benchmark::State;

constexpr std::array<std::array<int, 3>, 2> GRIDS = {{{32, 8, 8}, {64, 16, 16}}};

/// What must move of each element: its copies; the gradients and the volume at rest; its rotation. And of each vector
/// at a copy, and of each block of the float matrix with its column.
constexpr double COPIES = 4 * sizeof(int), REST = 13 * sizeof(double), ROTATION = 9 * sizeof(double),
                 VECTOR = 3 * sizeof(double), FLOAT_VECTOR = 3 * sizeof(float), BLOCK = 9 * sizeof(float) + sizeof(int);

double triad = 0;  // [B/s]

double bytesOf(const Matrix& matrix) { return BLOCK * static_cast<double>(matrix.pattern.column.size()); }

Motion atRest(const std::vector<Vec3>& x) { return {x, std::vector<Vec3>(x.size(), Vec3::Zero())}; }

ImplicitStep makeStep(const Bar& bar, const CutMesh& mesh) {
  return ImplicitStep(mesh, bar.materials, Mass::LUMPED, Pressure::ELEMENT, true, bar.conditions,
                      {TIME_STEP, Method::ITERATIVE, 1e-4, THREADS});
}

using Clock = std::chrono::steady_clock;

/// Time [s] of one call.
template <typename Function>
double secondsOf(const Function& f) {
  const auto start = Clock::now();
  f();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Calls `kernel`, which returns the time [s] it took, until it is known well. `bytes` are those of one call.
template <typename Kernel>
void measure(State& state, const Bar& bar, double bytes, const Kernel& kernel) {
  double seconds = 0;
  for (auto _ : state) {
    const double call = kernel();
    state.SetIterationTime(call);
    seconds += call;
  }
  seconds /= static_cast<double>(state.iterations());
  state.counters["ns/element"] = 1e9 * seconds / bar.elements();
  state.counters["GB/s"] = 1e-9 * bytes / seconds;
  state.counters["of triad"] = bytes / seconds / triad;
}

/// F and the last rotation in, the new rotation out.
void rotations(State& state) {
  const Bar bar(GRIDS[state.range(0)]);
  const auto gradients = [&](double angle) {
    std::vector<Mat3> F;
    const std::vector<Vec3> y = bent(bar.mesh.mesh(), angle);
    const std::vector<RestElement> rest = restElements(bar.mesh.mesh());
    for (std::size_t e = 0; e < rest.size(); ++e) {
      const auto& n = bar.mesh.mesh().elements[e];
      F.push_back(gradient(y[n[0]], y[n[1]], y[n[2]], y[n[3]], rest[e]));
    }
    return F;
  };
  const std::vector<Mat3> F = gradients(0.5), last_F = gradients(0.48);
  std::vector<Mat3> last(F.size(), Mat3::Identity()), R(F.size());
  const int groups = static_cast<int>(F.size()) / LANES;
  for (int g = 0; g < groups; ++g) polarRotations(&last_F[LANES * g], &last[LANES * g]);
  measure(state, bar, 3 * ROTATION * bar.elements(), [&] {
    return secondsOf([&] {
      parallelFor(groups, THREADS, [&](int g) {
        std::copy_n(&last[LANES * g], LANES, &R[LANES * g]);
        polarRotations(&F[LANES * g], &R[LANES * g]);
      });
    });
  });
}

/// Elements and positions in, forces out.
void elasticForces(State& state) {
  const Bar bar(GRIDS[state.range(0)]);
  std::vector<Vec3> forces;
  const double bytes = (COPIES + REST + ROTATION) * bar.elements() + 2 * VECTOR * bar.copies();
  measure(state, bar, bytes, [&] { return secondsOf([&] { bar.assembly.elasticForces(bar.x, &forces); }); });
}

/// Elements in, blocks out.
void blockAssembly(State& state) {
  const Bar bar(GRIDS[state.range(0)]);
  Matrix matrix(bar);
  const double bytes = (COPIES + REST + ROTATION) * bar.elements() + bytesOf(matrix);
  measure(state, bar, bytes, [&] {
    return secondsOf(
        [&] { matrix.assembler.assemble(bar.assembly, matrix.pattern, bar.factors, matrix.scale, &matrix.blocks); });
  });
}

/// Blocks and positions in; the factor is counted as nothing, since its size is the solver's own.
void coarseMatrix(State& state) {
  const Bar bar(GRIDS[state.range(0)]);
  const Matrix matrix(bar);
  CoarseSpace coarse;
  coarse.topologyChanged(matrix.pattern, matrix.aggregates, matrix.scale);
  measure(state, bar, bytesOf(matrix) + VECTOR * bar.copies(), [&] {
    return secondsOf([&] {
      coarse.matrixChanged(bar.x, matrix.blocks, THREADS);
      coarse.springsChanged(CoupledRows(), THREADS);
    });
  });
}

/// Residual in, correction out.
void coarseSolve(State& state) {
  const Bar bar(GRIDS[state.range(0)]);
  const Matrix matrix(bar);
  CoarseSpace coarse;
  coarse.topologyChanged(matrix.pattern, matrix.aggregates, matrix.scale);
  coarse.matrixChanged(bar.x, matrix.blocks, THREADS);
  coarse.springsChanged(CoupledRows(), THREADS);
  const std::vector<Vec4f> r(matrix.pattern.rows(), Vec4f(1, -2, 3, 0));
  std::vector<Vec4f> z(r.size());
  measure(state, bar, 2 * FLOAT_VECTOR * static_cast<double>(r.size()), [&] {
    return secondsOf([&] {
      parallelFor(matrix.aggregates.count(), THREADS, [&](int a) { coarse.restrictAggregate(a, r); });
      coarse.solve();
      parallelFor(matrix.pattern.rows(), THREADS, [&](int i) { z[i] = coarse.prolong(i); });
    });
  });
}

/// Blocks and a vector in, a vector out.
void matrixProduct(State& state) {
  const Bar bar(GRIDS[state.range(0)]);
  const Matrix matrix(bar);
  const std::vector<Vec4f> p(matrix.pattern.rows(), Vec4f(1, -2, 3, 0));
  std::vector<Vec4f> Ap(p.size());
  measure(state, bar, bytesOf(matrix) + 2 * FLOAT_VECTOR * static_cast<double>(p.size()), [&] {
    return secondsOf([&] {
      parallelFor(matrix.pattern.rows(), THREADS,
                  [&](int i) { Ap[i] = multiplyRow(matrix.pattern, matrix.blocks, i, p); });
    });
  });
}

/// One iteration of the solver, a product among it: blocks, and four vectors of conjugate gradients in and out. The
/// time is that of a whole solve by its count of iterations, the residuals in double included.
void iteration(State& state) {
  const Bar bar(GRIDS[state.range(0)]);
  const Matrix matrix(bar);
  measure(state, bar, bytesOf(matrix) + 8 * FLOAT_VECTOR * bar.copies(), [&] {
    Motion motion = atRest(bar.x);
    ImplicitStep step = makeStep(bar, bar.mesh);
    step.topologyChanged(motion);
    step.begin(TIME_STEP, motion);
    step.advance(0, &motion);
    return 1e-3 * step.times().solve / step.stats().iterations;
  });
}

/// Elements in, blocks in double out; the factor is counted as nothing.
void choleskyFactor(State& state) {
  const Bar bar(GRIDS[state.range(0)]);
  const Matrix matrix(bar);
  DirectSolver solver;
  const std::vector<int> nothing;
  solver.systemChanged(bar.assembly, {bar.held, bar.piece, bar.piece, nothing}, bar.factors);
  const double bytes = (COPIES + REST + ROTATION) * bar.elements() + 2 * bytesOf(matrix);
  measure(state, bar, bytes, [&] {
    return secondsOf([&] {
      solver.matrixChanged(bar.x);
      solver.springsChanged({}, TIME_STEP);
    });
  });
}

/// Positions in; vertices out.
void surfaceUpdate(State& state) {
  const Bar bar(GRIDS[state.range(0)]);
  const Surface surface = buildSurface(bar.mesh);
  const auto vertices = static_cast<double>(surface.vertices.size());
  measure(state, bar, (sizeof(SurfaceVertex) + 2 * VECTOR) * vertices,
          [&] { return secondsOf([&] { ::benchmark::DoNotOptimize(surfacePositions(surface, bar.x)); }); });
}

PlaneCut plane() {
  PlaneCut cut;
  cut.point = Vec3(0.507, 0.125, 0);
  cut.normal = Vec3(1, 0.05, 0.03);
  return cut;
}

/// The plane's distances and all elements in.
void cutInsert(State& state) {
  const Bar bar(GRIDS[state.range(0)]);
  measure(state, bar, COPIES * bar.elements() + sizeof(double) * bar.copies(), [&] {
    CutMesh mesh = bar.mesh;
    return secondsOf([&] { mesh.insert(planeField(plane(), mesh, bar.x)); });
  });
}

/// Where a cut bar may touch itself while it grows and shrinks, so that all is looked for anew each time: the surface's
/// vertices and triangles in.
void fragmentSearch(State& state) {
  const Bar bar(GRIDS[state.range(0)]);
  CutMesh mesh = bar.mesh;
  mesh.insert(planeField(plane(), mesh, bar.x));
  std::vector<Vec3> x = bar.x;
  for (int c = static_cast<int>(x.size()); c < mesh.numCopies(); ++c) x.push_back(x[mesh.copyParent(c)]);
  int pieces = 0;
  const Surface surface = buildSurface(mesh);
  const ContactSurface contact = makeContactSurface(surface, mesh, bar.materials, mesh.copyPieces(&pieces));
  const std::vector<Vec3> vertices = surfacePositions(surface, x), still(vertices.size(), Vec3::Zero());
  std::vector<Vec3> grown = vertices;
  for (Vec3& vertex : grown) vertex *= 1.1;
  bool is_grown = false;
  FragmentFinder finder;
  std::vector<Candidate> candidates;
  const auto triangles = static_cast<double>(surface.triangles.size());
  double seconds = 0;
  measure(state, bar, 2 * VECTOR * static_cast<double>(vertices.size()) + 3 * sizeof(int) * triangles, [&] {
    candidates.clear();
    is_grown = !is_grown;
    return seconds =
               secondsOf([&] { finder.find(contact, is_grown ? grown : vertices, still, {}, THREADS, &candidates); });
  });
  state.counters["ns/triangle"] = 1e9 * seconds / triangles;
}

/// All that is edited or found anew after a cut, pattern and aggregates among it, and the matrix of the first step that
/// has them: elements in, blocks out.
void cutTopology(State& state) {
  const Bar bar(GRIDS[state.range(0)]);
  const Matrix matrix(bar);
  const double bytes = (COPIES + REST + ROTATION) * bar.elements() + bytesOf(matrix);
  measure(state, bar, bytes, [&] {
    CutMesh mesh = bar.mesh;
    Motion motion = atRest(bar.x);
    ImplicitStep step = makeStep(bar, mesh);
    step.topologyChanged(motion);
    step.begin(TIME_STEP, motion);
    step.advance(0, &motion);
    const Insertion done = mesh.insert(planeField(plane(), mesh, motion.x));
    for (int c = static_cast<int>(motion.x.size()); c < mesh.numCopies(); ++c) {
      motion.x.push_back(motion.x[mesh.copyParent(c)]);
      motion.v.push_back(motion.v[mesh.copyParent(c)]);
    }
    const double seconds = secondsOf([&] { step.topologyChanged(motion, done.touched); });
    step.begin(TIME_STEP, motion);
    step.advance(TIME_STEP, &motion);
    return seconds + 1e-3 * step.times().assembly;
  });
}

/// The slow preparation of a call is not timed, so the number of calls is given where it would last.
void sizes(::benchmark::internal::Benchmark* kernel) {
  kernel->ArgName("size")->Arg(0)->Arg(1)->Unit(::benchmark::kMillisecond)->UseManualTime();
}
void fewCalls(::benchmark::internal::Benchmark* kernel) {
  sizes(kernel);
  kernel->Iterations(5);
}

BENCHMARK(rotations)->Apply(sizes);
BENCHMARK(elasticForces)->Apply(sizes);
BENCHMARK(blockAssembly)->Apply(sizes);
BENCHMARK(coarseMatrix)->Apply(sizes);
BENCHMARK(coarseSolve)->Apply(sizes);
BENCHMARK(matrixProduct)->Apply(sizes);
BENCHMARK(iteration)->Apply(fewCalls);
BENCHMARK(choleskyFactor)->Apply(fewCalls);
BENCHMARK(surfaceUpdate)->Apply(sizes);
BENCHMARK(fragmentSearch)->Apply(sizes);
BENCHMARK(cutInsert)->Apply(fewCalls);
BENCHMARK(cutTopology)->Apply(fewCalls);

}  // namespace

int main(int argc, char** argv) {
  ::benchmark::Initialize(&argc, argv);
  if (::benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  triad = bench::triadBandwidth(THREADS);
  std::cout << "size 0: 12,288 tetrahedra, size 1: 98,304; triad " << 1e-9 * triad << " GB/s" << std::endl;
  ::benchmark::RunSpecifiedBenchmarks();
}

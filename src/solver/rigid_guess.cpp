#include "incision/solver/rigid_guess.h"

#include <Eigen/Geometry>
#include <utility>

#include "incision/base/parallel.h"
#include "incision/solver/line_search.h"
#include "rigid_guess_work.h"

namespace incision {
namespace {

/// Newton steps at most, and how good the guess need be: a spring's force may still change by this share of the
/// largest.
constexpr int MAX_STEPS = 100;
constexpr double GOOD_ENOUGH = 1e-2;

}  // namespace

RigidGuess::RigidGuess() : work_(std::make_unique<Work>()) {}
RigidGuess::~RigidGuess() = default;

void RigidGuess::find(const RigidPieces& rigid, double time_step, int threads, const std::vector<Vec3>& x,
                      const std::vector<Vec3>& driving, Couplers* couplers, std::vector<Vec3>* moved) {
  Work& w = *work_;
  couplers->takeBounds(*moved);
  couplers->update(*moved);
  if (!w.begin(rigid, threads, x, driving, couplers->springs())) return;
  for (int k = 0; k < MAX_STEPS; ++k) {
    if (!w.findStep(time_step, couplers->springs(), *moved)) break;
    const double share = w.searchLine(couplers, *moved);
    w.equations->q += share * w.equations->step;
    for (std::size_t i = 0; i < moved->size(); ++i) (*moved)[i] += share * w.way[i];
    couplers->takeBounds(*moved);
    couplers->update(*moved);
    if (share == 1 && w.isGood(couplers->springs(), *moved)) break;
  }
}

void RigidGuess::step(const RigidPieces& rigid, double time_step, int threads, const std::vector<Vec3>& x,
                      const std::vector<Vec3>& driving, const std::vector<Spring>& springs, std::vector<Vec3>* moved) {
  Work& w = *work_;
  if (!w.begin(rigid, threads, x, driving, springs) || !w.findStep(time_step, springs, *moved)) return;
  w.equations->q = w.equations->step;
  for (std::size_t i = 0; i < moved->size(); ++i) (*moved)[i] += w.way[i];
}

void RigidGuess::addTo(const RigidPieces& rigid, const std::vector<Vec3>& x, std::vector<Vec3>* dv) const {
  const Work& w = *work_;
  if (w.piece.empty()) return;
  for (std::size_t c = 0; c < x.size(); ++c) {
    const int piece = rigid.pieceOf(c), number = w.number[static_cast<std::size_t>(piece)];
    if (number >= 0) (*dv)[c] += Work::End{number, {1, x[c] - rigid.centreOf(piece)}}.wayOf(w.equations->q);
  }
}

/// Returns whether springs act on a free piece.
bool RigidGuess::Work::begin(const RigidPieces& rigid, int of_threads, const std::vector<Vec3>& x,
                             const std::vector<Vec3>& on_copies, const std::vector<Spring>& springs) {
  threads = of_threads;
  findEnds(rigid, x, springs);
  if (piece.empty()) return false;
  findPattern();
  drive(rigid, x, on_copies);
  return true;
}

void RigidGuess::Work::drive(const RigidPieces& rigid, const std::vector<Vec3>& x, const std::vector<Vec3>& on_copies) {
  mass.assign(piece.size(), Block::Zero());
  for (std::size_t n = 0; n < piece.size(); ++n) {
    mass[n].topLeftCorner<3, 3>() = rigid.massOf(piece[n]) * Mat3::Identity();
    mass[n].bottomRightCorner<3, 3>() = rigid.inertiaOf(piece[n]);
  }
  Motions& driving = equations->driving;
  driving = equations->q = Motions::Zero(static_cast<int>(MODES * piece.size()));
  for (std::size_t c = 0; c < x.size(); ++c) {
    const int of_copy = rigid.pieceOf(c), n = number[static_cast<std::size_t>(of_copy)];
    if (n < 0) continue;
    driving.segment<3>(MODES * n) += on_copies[c];
    driving.segment<3>(MODES * n + 3) += (x[c] - rigid.centreOf(of_copy)).cross(on_copies[c]);
  }
}

RigidGuess::Work::Motions RigidGuess::Work::momentum(const Motions& of) const {
  Motions p(of.size());
  for (std::size_t n = 0; n < mass.size(); ++n) {
    const int at = MODES * static_cast<int>(n);
    p.segment<MODES>(at) = mass[n] * of.segment<MODES>(at);
  }
  return p;
}

/// The blocks, and what is on the right but for what the pieces' motions take of it. Each is summed by the springs in
/// their order, whatever thread does it.
void RigidGuess::Work::sumSprings(double time_step, const std::vector<Spring>& springs,
                                  const std::vector<Vec3>& moved) {
  const auto& all = std::as_const(ends);
  parallelFor(static_cast<int>(pairs.size()), threads, [&](int b) {
    const auto& [column, row] = pairs[static_cast<std::size_t>(b)];
    Block& block = blocks[static_cast<std::size_t>(b)];
    block = column == row ? mass[static_cast<std::size_t>(row)] : Block::Zero();
    for (const Use& use : std::as_const(uses)[b]) {
      const Spring& spring = springs[static_cast<std::size_t>(use.spring)];
      if (!spring.isStiff()) continue;
      const Mat3 K = time_step * time_step * spring.stiffness;
      addModes(K, all[use.spring][use.row].seen, all[use.spring][use.column].seen, &block);
    }
  });
  Motions& right = equations->right;
  parallelFor(static_cast<int>(piece.size()), threads, [&](int n) {
    for (const Use& use : std::as_const(drives)[n]) {
      const auto i = static_cast<std::size_t>(use.spring);
      const Vec3 impulse = time_step * springs[i].at(moved[i]);
      const ModesSeen& seen = all[use.spring][use.row].seen;
      right.segment<3>(MODES * n) += seen.a * impulse;
      right.segment<3>(MODES * n + 3) += seen.b.cross(impulse);
    }
  });
}

/// The Newton step from q, and how far the springs' points go in it. Returns false where there is none.
bool RigidGuess::Work::findStep(double time_step, const std::vector<Spring>& springs, const std::vector<Vec3>& moved) {
  auto& [matrix, solver, driving, q, right, step] = *equations;
  right = driving - momentum(q);
  sumSprings(time_step, springs, moved);
  // The blocks of a column lie one below the other in each of its six columns.
  for (std::size_t k = 0, end = 0; k < pairs.size(); k = end) {
    while (end < pairs.size() && pairs[end].first == pairs[k].first) ++end;
    double* values = matrix.valuePtr() + matrix.outerIndexPtr()[MODES * pairs[k].first];
    for (int j = 0; j < MODES; ++j)
      for (std::size_t b = k; b < end; ++b)
        for (int i = 0; i < MODES; ++i) *values++ = blocks[b](i, j);
  }
  solver.factorize(matrix);
  if (solver.info() != Eigen::Success) return false;
  step = solver.solve(right);
  way.resize(springs.size());
  expected.resize(springs.size());
  const Motions& found = step;
  parallelFor(static_cast<int>(springs.size()), threads, [&](int i) {
    way[i].setZero();
    for (const End& end : std::as_const(ends)[i]) way[i] += time_step * end.wayOf(found);
    expected[i] = springs[i].at(moved[i] + way[i]);
  });
  return step.allFinite();
}

/// Where the springs at the step's end drive the pieces back, the share of it at which they drive them nowhere along
/// it.
double RigidGuess::Work::searchLine(Couplers* couplers, const std::vector<Vec3>& moved) {
  const std::vector<Spring>& springs = couplers->springs();
  const auto& [matrix, solver, driving, q, right, step] = *equations;
  const double slope = step.dot(driving - momentum(q)), curvature = step.dot(momentum(step));
  double bend = 0;
  const auto slopeAt = [&](double share) {
    tried.resize(moved.size());
    terms.resize(moved.size());
    for (std::size_t i = 0; i < moved.size(); ++i) tried[i] = moved[i] + share * way[i];
    couplers->update(tried);
    parallelFor(static_cast<int>(moved.size()), threads, [&](int i) {
      terms[i] = {way[i].dot(springs[i].at(tried[i])), way[i].dot(springs[i].stiffness * way[i])};
    });
    double here = slope - share * curvature;
    bend = curvature;
    for (const Eigen::Vector2d& term : terms) {
      here += term[0];
      bend += term[1];
    }
    return here;
  };
  const double at_start = slopeAt(0);
  double here = slopeAt(1);
  if (!(here < 0)) return 1;
  LineSearch search;
  for (int k = 0; k < LineSearch::MOST && !LineSearch::isNear(here, at_start); ++k) {
    search.goOn(here, bend);
    here = slopeAt(search.share());
  }
  return search.share();
}

bool RigidGuess::Work::isGood(const std::vector<Spring>& springs, const std::vector<Vec3>& moved) {
  terms.resize(springs.size());
  parallelFor(static_cast<int>(springs.size()), threads, [&](int i) {
    const Vec3 force = springs[i].at(moved[i]);
    terms[i] = {std::max(force.squaredNorm(), expected[i].squaredNorm()), (force - expected[i]).squaredNorm()};
  });
  Eigen::Vector2d most = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& term : terms) most = most.cwiseMax(term);
  return most[1] <= GOOD_ENOUGH * GOOD_ENOUGH * most[0];
}

}  // namespace incision

#include "incision/solver/linear_solver.h"

#include <algorithm>
#include <cmath>

#include "incision/solver/piecewise_solver.h"

namespace incision {
namespace {

/// Up to this many free copies in a piece a factorisation is as quick as the iteration.
constexpr int DIRECT_UP_TO = 300;

/// With `method: iterative`, pieces no larger than one aggregate: the coarse space would solve them anyway.
constexpr int ONE_AGGREGATE = 64;

}  // namespace

void PieceNorms::topologyChanged(const Assembly& assembly, const std::vector<int>& rows, const std::vector<int>& piece,
                                 const std::vector<double>& diagonal) {
  rows_ = rows;
  piece_.clear();
  inverse_diagonal_.clear();
  mass_.assign(piece.empty() ? 0 : 1 + *std::max_element(piece.begin(), piece.end()), 0);
  for (int copy : rows) {
    piece_.push_back(piece[copy]);
    inverse_diagonal_.push_back(1 / diagonal[copy]);
    mass_[piece[copy]] += assembly.masses()[copy];
  }
}

void PieceNorms::setRightHandSide(const std::vector<Vec3>& b, const std::vector<double>& rounding, double tolerance) {
  measure_.assign(mass_.size(), 0);
  sum_.assign(mass_.size(), 0);  // here: of the rounding
  double whole = 0, mass = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    measure_[piece_[i]] += b[i].squaredNorm();
    sum_[piece_[i]] += inverse_diagonal_[i] * rounding[rows_[i]] * rounding[rows_[i]];
  }
  for (std::size_t s = 0; s < mass_.size(); ++s) {
    whole += measure_[s];
    mass += mass_[s];
  }
  total_ = 0;
  for (std::size_t s = 0; s < mass_.size(); ++s) {
    measure_[s] = std::max({measure_[s], mass_[s] / mass * whole, sum_[s] / (tolerance * tolerance)});
    total_ += measure_[s];
  }
  total_ = std::sqrt(total_);
}

double PieceNorms::worstRatio(const std::vector<Vec3>& r) {
  sum_.assign(mass_.size(), 0);
  for (std::size_t i = 0; i < rows_.size(); ++i) sum_[piece_[i]] += r[i].squaredNorm();
  double worst = 0;
  for (std::size_t s = 0; s < mass_.size(); ++s) {
    if (sum_[s] <= worst * measure_[s]) continue;
    worst = sum_[s] / measure_[s];
    if (!std::isfinite(worst)) break;
  }
  return std::sqrt(worst);
}

std::unique_ptr<LinearSolver> makeLinearSolver(const SolverSettings& settings) {
  if (settings.method == Method::DIRECT) return std::make_unique<DirectSolver>();
  return std::make_unique<PiecewiseSolver>(settings.tolerance,
                                           settings.method == Method::AUTO ? DIRECT_UP_TO : ONE_AGGREGATE);
}

}  // namespace incision

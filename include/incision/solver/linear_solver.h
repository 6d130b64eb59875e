#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "incision/fem/block_matrix.h"
#include "incision/solver/first_guess.h"
#include "incision/solver/settings.h"
#include "incision/solver/spring.h"

namespace incision {

/// What has changed since a solver last looked.
struct SystemChange {
  /// Of each copy, whether its Δv is no unknown of this solver: it is held, or another solver finds it.
  const std::vector<bool>& left_out;
  const std::vector<int>& piece;    ///< of each copy
  const std::vector<int>& group;    ///< of each copy; springs act on pieces of one group only
  const std::vector<int>& touched;  ///< nodes round which parts or copies have changed; without meaning the first time
};

/// What of a linear solver outlasts a step: where it has made room for springs. It decides on the order in which the
/// solver eliminates, and so on last digits.
struct SolverMemory {
  std::vector<std::pair<int, int>> blocks;         ///< of the matrix that is factorised
  int idle = 0;                                    ///< factorisations in which most of these were not used
  std::vector<std::pair<int, int>> coarse_blocks;  ///< of the coarse level of an iteration
};

template <class Archive>
void serialize(Archive& archive, SolverMemory& memory) {
  auto& [blocks, idle, coarse_blocks] = memory;
  archive(blocks, idle, coarse_blocks);
}

/// How far a solve is asked to go.
struct SolveDemand {
  const std::vector<double>& limit;  ///< of each piece's |left|² in the norm scaled by the diagonal of A
  int most;                          ///< iterations, however far they have come
  /// Whether what is left may drive no piece on which springs act as a whole: neither straight on nor round.
  bool balanced;
};

/// Solves A Δv = b for the copies that are not left out; A = mass M + stiffness K and Δt² times the springs'
/// stiffness.
class LinearSolver {
 public:
  virtual ~LinearSolver() = default;

  /// Before anything else, after a cut and when the factors change; `assembly` must outlive the solver.
  virtual void systemChanged(const Assembly& assembly, const SystemChange& change, const SystemFactors& factors) = 0;

  /// After the rotations changed; `x` are the copies' positions [m]. springsChanged must follow.
  virtual void matrixChanged(const std::vector<Vec3>& x) = 0;

  /// After the springs changed, those of a step of `time_step` [s]. Those that are not stiff are left out. Returns
  /// false when A is not positive definite.
  virtual bool springsChanged(const std::vector<Spring>& springs, double time_step) = 0;

  /// A copy of the memory, in place of what `memory` holds.
  virtual void keep(SolverMemory* memory) const = 0;

  /// Puts a memory back that was kept of this system. Between systemChanged and matrixChanged.
  virtual void recall(const SolverMemory& memory) = 0;

  /// Finds d with A d near r, for the copies that are not left out, and what is left of r: r − A d. It is then within
  /// the limits, or as near to them as the solver gets; pieces that are there to begin with have d = 0, or what
  /// balances them. The solution is likely near a sum of multiples of the vectors in `basis`, where there is one. An
  /// iteration that is ended has a d that is never worse than d = 0 in the energy |d|²_A / 2 − d·r. Returns how many
  /// iterations that took.
  virtual int correct(const std::vector<Vec3>& r, const SolveDemand& demand, const Basis* basis, std::vector<Vec3>* d,
                      std::vector<Vec3>* left) = 0;

  /// Whether what `correct` finds is as near as numbers in double allow, whatever the limit.
  virtual bool isDirect() const = 0;
};

std::unique_ptr<LinearSolver> makeLinearSolver(const SolverSettings& settings, bool warping);

/// What makes the solvers of a body.
using MakeLinearSolver = std::function<std::unique_ptr<LinearSolver>(const SolverSettings& settings, bool warping)>;

}  // namespace incision

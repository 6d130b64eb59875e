#pragma once

#include <Eigen/SparseCholesky>
#include <optional>
#include <utility>
#include <vector>

#include "incision/base/lists.h"
#include "incision/solver/rigid_guess.h"
#include "incision/solver/rigid_modes.h"

namespace incision {

/// The pieces that springs act on as rigid bodies, and what is reckoned of them.
struct RigidGuess::Work {
  using Block = Eigen::Matrix<double, MODES, MODES>;
  using Motions = Eigen::VectorXd;  // of each piece its velocity [m/s], and its rate of turning [1/s]

  /// What a spring sees of a piece's rigid motions.
  struct End {
    int piece;  // among those that springs act on
    ModesSeen seen;

    Vec3 wayOf(const Motions& q) const {
      return seen.a * q.segment<3>(MODES * piece) + q.segment<3>(MODES * piece + 3).cross(seen.b);
    }
  };

  /// What is solved for the pieces' motions. It is made anew for every guess: vectors of Eigen do not survive a change
  /// of their size for which there is no memory, as they then free what they had a second time.
  struct Equations {
    Eigen::SparseMatrix<double> matrix;
    Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> solver;
    Motions driving, q, right, step;
  };

  /// A spring that adds to a block by two of its ends, of which the row's piece does not come before the column's; or
  /// to what drives a piece, by one.
  struct Use {
    int spring, row, column;
  };

  int threads = 1;
  std::vector<int> number;                 // of each piece among those that springs act on; −1: none does
  std::vector<int> piece;                  // of each number
  Lists<End> ends;                         // of each spring
  std::vector<std::pair<int, int>> pairs;  // column and row of each block, ascending
  std::vector<int> block_of;               // of two ends k ≥ l of a spring, of each in turn
  Lists<Use> uses, drives;                 // of each block, and of each piece, by springs
  std::vector<Block> mass, blocks;         // of each piece; of each pair
  std::optional<Equations> equations;
  std::vector<Vec3> way, tried, expected;  // of each spring
  std::vector<Eigen::Vector2d> terms;      // of each spring, to be added up or compared

  bool begin(const RigidPieces& rigid, int of_threads, const std::vector<Vec3>& x, const std::vector<Vec3>& on_copies,
             const std::vector<Spring>& springs);
  void findEnds(const RigidPieces& rigid, const std::vector<Vec3>& x, const std::vector<Spring>& springs);
  void findPattern();
  void findUses();
  void sumSprings(double time_step, const std::vector<Spring>& springs, const std::vector<Vec3>& moved);
  void drive(const RigidPieces& rigid, const std::vector<Vec3>& x, const std::vector<Vec3>& on_copies);
  bool findStep(double time_step, const std::vector<Spring>& springs, const std::vector<Vec3>& moved);
  double searchLine(Couplers* couplers, const std::vector<Vec3>& moved);
  bool isGood(const std::vector<Spring>& springs, const std::vector<Vec3>& moved);
  Motions momentum(const Motions& of) const;
};

}  // namespace incision

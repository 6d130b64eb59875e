#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "incision/solver/couplers.h"
#include "incision/solver/first_guess.h"
#include "incision/solver/line_search.h"
#include "incision/solver/linear_solver.h"
#include "incision/solver/piece_norms.h"
#include "incision/solver/rigid_guess.h"

namespace incision {

/// What the solution of a step took.
struct SolveStats {
  int iterations = 0;  ///< of all linear solves; 0 for direct ones
  int solves = 0;      ///< Newton steps; 0 where there was nothing to solve
  /// What is left over what acts, as PieceNorms measures it, reckoned in double from the forces. More than the
  /// tolerance where a solve was ended before, or where what acts is so small that rounding hides it.
  double residual = 0;
  /// One more Newton step would change no spring's force by more than 1e-3 of the largest in its group of pieces, and
  /// no solve was ended before its tolerance.
  bool settled = true;
  bool cut_short = false;  ///< ended by StepProblem::most_iterations

  /// Adds a part of the step, or one that was tried in vain.
  void add(const SolveStats& part, bool taken) {
    iterations += part.iterations;
    solves += part.solves;
    if (!taken) return;
    residual = std::max(residual, part.residual);
    settled = settled && part.settled;
    cut_short = cut_short || part.cut_short;
  }
};

/// The equations of a step: those of the body alone, which are affine in Δv, and the solver of their matrix.
class StepEquations {
 public:
  virtual ~StepEquations() = default;

  /// The right-hand side less A Δv at every copy [N s], without springs; at held copies what their clamps take up.
  virtual void residual(const std::vector<Vec3>& dv, std::vector<Vec3>* r) = 0;

  /// Takes over the springs that act, into the matrix and into the groups of pieces between which they do. Returns
  /// false when the matrix is not positive definite.
  virtual bool setSprings(const std::vector<Spring>& springs) = 0;

  /// LinearSolver::correct and isDirect.
  virtual int correct(const std::vector<Vec3>& r, const SolveDemand& demand, const Basis* basis, std::vector<Vec3>* d,
                      std::vector<Vec3>* left) = 0;
  virtual bool isDirect() const = 0;

  /// Takes these impulses of springs on copies [N s] into the base: the step then starts from the rigid motion that
  /// they leave, and `ahead` and the residual are those from there. Returns false where such a step is not wanted.
  virtual bool rebase(const std::vector<Vec3>& impulses) = 0;

  /// Shares out what Δv leaves of each free piece's momentum among all its copies, where no springs act.
  virtual void balance(std::vector<Vec3>* dv) = 0;

  /// Goes over to a direct solver with these springs. Returns false where that cannot be.
  virtual bool fallBack(const std::vector<Spring>& springs) = 0;
};

/// What is given in a step.
struct StepProblem {
  StepEquations* equations;
  Couplers* couplers;                   ///< null: none takes part
  double time_step;                     ///< [s]
  double tolerance;                     ///< of linear solves
  int threads;                          ///< up to so many share the guess by rigid pieces
  std::optional<int> most_iterations;   ///< of all linear solves together; they then end with what they have
  const std::vector<Vec3>& ahead;       ///< how far each copy goes where Δv = 0 [m]
  const std::vector<Vec3>& loads;       ///< impulse of weight and loads on each copy [N s]
  double reach;                         ///< Δt times the largest coordinate [m s]
  const Basis& basis;                   ///< the solution is likely near a sum of its vectors
  const std::vector<int>&piece, &held;  ///< the piece of each copy, and its clamp or −1
  const std::vector<int>& group;        ///< of each copy; springs join groups as they are taken over
  const RigidPieces& rigid;             ///< the pieces as rigid bodies, and
  const std::vector<Vec3>& x;           ///< where their motion alone takes the copies [m]
};

/// Finds the Δv at which the forces of the body and of its couplers balance: the minimum of a convex function of Δv as
/// long as the bounds stay, by Newton's method with a line search in each group of pieces. Solves before the last one
/// are loose. The bounds, those of the guess at first, are taken anew where a group has gone the whole way: on the way
/// there the forces may be far from what they come to.
class Newton {
 public:
  /// Limit of the Newton steps in a step.
  static constexpr int MAX_SOLVES = 50;

  /// `dv` comes with the values of the held copies. Returns false where a matrix is not positive definite, a linear
  /// solve does not converge or the step is not wanted.
  bool solve(const StepProblem& problem, PieceNorms* norms, std::vector<Vec3>* dv);

  const SolveStats& stats() const { return stats_; }
  /// Of each spring, what it has done to the body [N s], and how far its point has gone [m].
  const std::vector<Vec3>& impulses() const { return impulses_; }
  const std::vector<Vec3>& moved() const { return moved_; }
  /// What the equations without springs leave at each copy where Δv has its value in the end [N s]. At free copies
  /// whose momentum has been balanced since it is that before.
  const std::vector<Vec3>& residual() const { return alone_; }
  /// What all springs have done to each copy [N s].
  const std::vector<Vec3>& impulsesOnCopies() const { return on_copies_; }

 private:
  /// Springs act within groups, so each goes its own share of the way.
  struct Group {
    double slope = 0, curvature = 0;  // of the body alone, along the direction from its start
    double share = 1;
    LineSearch search;
    double at_start = 0, here = 0, bend = 0;  // slopes of all, at the start and at the share; and how it bends there
    bool searches = false;
    double largest = 0, off = 0;  // squares [N²]: of the largest force, of the largest difference
    bool settled = false;
  };

  void start(const StepProblem& p, PieceNorms* norms, std::vector<Vec3>* dv);
  void startAt(const StepProblem& p, const std::vector<Vec3>& guess, std::vector<Vec3>* dv);
  void place(const StepProblem& p, const std::vector<Vec3>& dv);
  bool isNearRest(const StepProblem& p) const;
  bool driveFreePieces(const StepProblem& p) const;
  bool guessRigidly(const StepProblem& p, std::vector<Vec3>* dv);
  void balanceRigidly(const StepProblem& p, std::vector<Vec3>* dv);
  bool takeSprings(const StepProblem& p);
  bool findDirection(const StepProblem& p, const PieceNorms& norms, const Basis* basis, bool tight);
  void loosen(const PieceNorms& norms, double looseness);
  void searchLines(const StepProblem& p);
  void trySprings(const StepProblem& p, bool on_the_way);
  void takeStep(const StepProblem& p, std::vector<Vec3>* dv);
  bool isSettled(const StepProblem& p, const PieceNorms& norms);
  void takeBounds(const StepProblem& p);
  bool isSettledAnew(const StepProblem& p, const PieceNorms& norms);
  void findImpulses(const StepProblem& p);
  void shareImpulses();
  void measureLeft(PieceNorms* norms);
  void takeRatio(const PieceNorms::Ratio& ratio);
  bool hasRunOut(const StepProblem& p) const;
  bool endShort();
  static int groupOf(const StepProblem& p, const Spring& spring);

  SolveStats stats_;
  double left_over_ = 0;  // what is left, over what the tolerance is of
  RigidGuess rigid_guess_;
  std::vector<Spring> used_;            // what the matrix has of the springs
  std::vector<Vec3> moved_, impulses_;  // of each spring
  std::vector<Vec3> way_, tried_;       // of each spring: Δt times the direction of its point, a displacement on it
  std::vector<Vec3> alone_;             // the residual without springs at Δv, by copy
  std::vector<Vec3> direction_, pull_;  // by copy: d, and A d without springs
  std::vector<Vec3> right_, left_;      // of a linear solve, by copy
  std::vector<Vec3> on_copies_;
  std::vector<double> bounds_go_;       // of each spring, the share of the way that its bound goes
  std::vector<double> limit_, square_;  // of each piece
  std::vector<int> group_of_piece_;
  std::vector<double> group_square_;
  std::vector<Group> groups_;  // by the number of their lowest piece
};

}  // namespace incision

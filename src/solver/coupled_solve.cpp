// How a step finds the springs that act in it.
#include <algorithm>
#include <cmath>

#include "incision/solver/implicit_step.h"

namespace incision {
namespace {

/// Solves in a step at most. Contacts that close and part mostly settle after one or two.
constexpr int MAX_SOLVES = 8;

/// A line search ends where less than this share of the slope at its start is left, or after so many trials.
constexpr double SEARCH_TOLERANCE = 0.1;
constexpr int MAX_SEARCH = 12;

}  // namespace

const std::vector<Spring>& ImplicitStep::springs() const {
  static const std::vector<Spring> none;
  return springs_ ? *springs_ : none;
}

/// Solves, and again as long as that changes the springs, with the last solution as a guess. What else acts on the body
/// is affine in Δv; so between two solutions the impulses that bring it there are between theirs, whatever springs
/// there may be at that point.
bool ImplicitStep::solveCoupled(double time_step, const Motion& motion, Couplers* couplers) {
  springs_ = couplers ? &couplers->springs() : nullptr;
  felt_.clear();
  if (couplers) updateSprings(motion, couplers);
  stats_ = SolveStats();
  int iterations = 0;
  for (int k = 0; k < MAX_SOLVES; ++k) {
    const bool joined = joinGroups();
    if (joined) prepare(current(), true, time_step, motion);
    if (joined || !matrix_known_ || had_springs_ || !springs().empty())
      matrix_known_ = current()->springsChanged(springs(), time_step);
    had_springs_ = !springs().empty();
    if (!matrix_known_) return false;
    if (k > 0) {
      again_basis_ = memory_.basis;
      again_basis_[0] = search_start_ = dv_;
    }
    stats_ = solve(time_step, motion, k > 0 ? again_basis_ : memory_.basis);
    iterations += stats_.iterations;
    stats_.iterations = iterations;
    if (!stats_.converged) return false;
    if (!couplers) return true;
    findEnd(motion);
    felt_at_start_.swap(felt_);
    couplers->findWrenches(motion.x, v_end_, &felt_);
    if (!updateSprings(motion, couplers)) return true;
    if (k == 0) continue;
    const double share = searchLine(time_step, motion, couplers);
    for (std::size_t i = 0; i < felt_.size(); ++i) felt_[i] = between(felt_at_start_[i], felt_[i], share);
  }
  return true;
}

/// Where the springs at the new Δv drive it back, it has gone too far from the last one: takes the point between at
/// which they drive it nowhere along that line. The forces of springs descend from a convex potential, so this ends
/// circles in which contacts close and part in turn, and what the last solve leaves is no worse than what it began
/// with. Returns the share of the way to the new Δv.
double ImplicitStep::searchLine(double time_step, const Motion& motion, Couplers* couplers) {
  search_direction_ = dv_;
  for (std::size_t c = 0; c < dv_.size(); ++c) search_direction_[c] -= search_start_[c];
  const auto slopeAt = [&](double share) {
    for (std::size_t c = 0; c < dv_.size(); ++c) dv_[c] = search_start_[c] + share * search_direction_[c];
    updateSprings(motion, couplers);
    return slopeAlongSearch(time_step, motion);
  };
  if (!(slopeAlongSearch(time_step, motion) < 0)) return 1;
  const double at_start = slopeAt(0);
  double near = 0, far = 1, share = 1;
  for (int k = 0; k < MAX_SEARCH; ++k) {
    share = (near + far) / 2;
    const double here = slopeAt(share);
    if (std::abs(here) < SEARCH_TOLERANCE * at_start) break;
    (here > 0 ? near : far) = share;
  }
  return share;
}

/// How the forces at Δv drive it on along the line search.
double ImplicitStep::slopeAlongSearch(double time_step, const Motion& motion) {
  residual(time_step, motion, dv_, &search_residual_);
  double sum = 0;
  for (std::size_t c = 0; c < dv_.size(); ++c) sum += search_residual_[c].dot(search_direction_[c]);
  return sum;
}

/// The velocities at the end of the step, for Δv as it is.
void ImplicitStep::findEnd(const Motion& motion) {
  v_end_.resize(motion.v.size());
  for (std::size_t c = 0; c < v_end_.size(); ++c) v_end_[c] = motion.v[c] + dv_[c];
}

bool ImplicitStep::updateSprings(const Motion& motion, Couplers* couplers) {
  findEnd(motion);
  return couplers->update(v_end_);
}

/// Joins the groups of pieces that a spring lies between; returns whether that changed any. Groups only grow until the
/// topology changes: pieces that lie on each other often come and go, and a solver takes time to turn.
bool ImplicitStep::joinGroups() {
  if (springs().empty()) return false;
  group_sets_.reset(pieces_);
  bool joined = false;
  for (const Spring& spring : springs()) {
    int last = -1;  // the group of the free copy before; −1: there was none
    for (int i = 0; i < spring.count; ++i) {
      if (held_[spring.copies[i]] >= 0) continue;
      const int group = memory_.group[spring.copies[i]];
      if (last >= 0 && group_sets_.join(last, group)) joined = true;
      last = group;
    }
  }
  if (!joined) return false;
  if (group_at_start_.empty()) group_at_start_ = memory_.group;
  for (int& group : memory_.group) group = group_sets_.lowest(group);
  return true;
}

}  // namespace incision

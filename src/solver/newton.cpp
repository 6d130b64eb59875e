#include "incision/solver/newton.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace incision {
namespace {

/// A spring's force may still change by this share of the largest one in its group.
constexpr double SETTLED = 1e-3;

/// A solve must leave less than this of the residual to be followed by another with the same springs.
constexpr double MIN_PROGRESS = 0.3;

/// A solve may miss the tolerance by what balancing the momentum adds, which is less than so many times. The next one
/// then leaves this share of it.
constexpr double NEARLY = 10, AGAIN = 0.3;

/// Where what is left at Δv = 0 is less than this share of what acts, Δv is so small that a guess by rigid pieces gains
/// less than it costs.
constexpr double NEAR_REST = 1e-2;

/// Bounds are taken anew after so many Newton steps, and go half of the way after the first ones. Where they go round
/// in circles even so the last ones stay: with these there is a minimum, at which no energy comes in.
constexpr int FAST_BOUNDS = 8, MAX_BOUNDS = 25;

}  // namespace

bool Newton::solve(const StepProblem& p, PieceNorms* norms, std::vector<Vec3>* dv) {
  const bool coupled = p.couplers != nullptr;
  start(p, norms, dv);
  if (left_over_ <= p.tolerance) {
    if (!coupled) p.equations->balance(dv);
    if (coupled) balanceRigidly(p, dv);
    return true;
  }
  if (!coupled && !p.equations->isDirect() && norms->floatIsTooCoarse(p.basis[0], p.tolerance))
    startAt(p, p.basis[0], dv);
  const bool drives_free = coupled && !isNearRest(p) && driveFreePieces(p);
  if (drives_free && !guessRigidly(p, dv)) return false;
  bool tight = !coupled, same_springs = false;
  double before = std::numeric_limits<double>::infinity();  // what the last solve with these springs left
  for (bool first = true;; first = false) {
    if (!same_springs && !takeSprings(p)) return false;
    if (!findDirection(p, *norms, first && !drives_free ? &p.basis : nullptr, tight)) {
      if (!p.equations->fallBack(used_)) return false;
      startAt(p, std::vector<Vec3>(dv->size(), Vec3::Zero()), dv);
      same_springs = true;
      continue;
    }
    if (coupled && !same_springs) searchLines(p);
    takeStep(p, dv);
    stats_.settled = !coupled || isSettled(p, *norms);
    const bool last_springs = stats_.settled || stats_.solves >= MAX_SOLVES;
    if (!coupled) p.equations->balance(dv);
    // Before the first tight solve too: what float has lost in the loose ones would take another to find.
    if (tight || last_springs || hasRunOut(p)) p.equations->residual(*dv, &alone_);
    measureLeft(norms);
    const bool finite = std::isfinite(left_over_);
    if (tight) {
      const bool done = left_over_ <= p.tolerance || p.equations->isDirect();
      if (done && last_springs) {
        stats_.settled = stats_.settled && (stats_.solves <= MAX_BOUNDS || isSettledAnew(p, *norms));
        return true;
      }
      // What float has lost, a fresh residual finds; where it does not, a direct solver may.
      if (!done && (same_springs || !finite) && !(left_over_ < MIN_PROGRESS * before)) {
        if (p.most_iterations && finite) return endShort();
        if (!p.equations->fallBack(used_)) return false;
        if (!finite) startAt(p, std::vector<Vec3>(dv->size(), Vec3::Zero()), dv);
      }
      before = left_over_;
    }
    if (finite && hasRunOut(p)) return endShort();
    if (!last_springs) before = std::numeric_limits<double>::infinity();
    same_springs = tight = last_springs;
  }
}

bool Newton::hasRunOut(const StepProblem& p) const {
  return p.most_iterations && stats_.iterations >= *p.most_iterations;
}

/// The step is what it is now.
bool Newton::endShort() {
  stats_.cut_short = true;
  stats_.settled = false;
  return true;
}

/// Where nothing drives the body on from Δv = 0 there is nothing to solve.
void Newton::start(const StepProblem& p, PieceNorms* norms, std::vector<Vec3>* dv) {
  stats_ = SolveStats();
  used_.clear();
  if (p.couplers) used_ = p.couplers->springs();
  impulses_.assign(used_.size(), Vec3::Zero());
  way_ = tried_ = impulses_;
  for (std::size_t c = 0; c < dv->size(); ++c)
    if (p.held[c] < 0) (*dv)[c].setZero();
  p.equations->residual(*dv, &alone_);
  norms->measure(alone_, p.loads, p.reach, p.tolerance);
  groups_.assign(norms->measures().size(), Group());
  if (p.couplers) {
    place(p, *dv);
    p.couplers->takeBounds(moved_);
    p.couplers->update(moved_);
    findImpulses(p);
    shareImpulses();
  }
  right_ = alone_;
  for (std::size_t i = 0; i < used_.size(); ++i) addShares(used_[i], impulses_[i], &right_);
  takeRatio(norms->worstRatio(right_));
}

void Newton::startAt(const StepProblem& p, const std::vector<Vec3>& guess, std::vector<Vec3>* dv) {
  for (std::size_t c = 0; c < dv->size(); ++c)
    if (p.held[c] < 0) (*dv)[c] = guess[c];
  p.equations->residual(*dv, &alone_);
  place(p, *dv);
}

/// Where the springs' points go with these Δv.
void Newton::place(const StepProblem& p, const std::vector<Vec3>& dv) {
  moved_.resize(used_.size());
  for (std::size_t i = 0; i < used_.size(); ++i)
    moved_[i] = weightedSum(used_[i], p.ahead) + p.time_step * weightedSum(used_[i], dv);
}

/// Whether a spring acts on a free piece. Where none does there is no rigid motion to guess, and Δv is likely near what
/// it was.
bool Newton::driveFreePieces(const StepProblem& p) const {
  return std::any_of(used_.begin(), used_.end(), [&](const Spring& spring) {
    return std::any_of(spring.copies.begin(), spring.copies.begin() + spring.count,
                       [&](int copy) { return p.rigid.isFree(static_cast<std::size_t>(copy)); });
  });
}

/// A direct solver makes its guess all the same: it knows no tolerance.
bool Newton::isNearRest(const StepProblem& p) const { return left_over_ <= NEAR_REST && !p.equations->isDirect(); }

/// Goes on from where the free pieces would be if they were rigid, and takes the springs that there would be. Returns
/// false where that step is not wanted.
bool Newton::guessRigidly(const StepProblem& p, std::vector<Vec3>* dv) {
  rigid_guess_.find(p.rigid, p.time_step, p.threads, p.x, alone_, p.couplers, &moved_);
  findImpulses(p);
  shareImpulses();
  if (!p.equations->rebase(on_copies_)) return false;
  p.equations->residual(*dv, &alone_);
  place(p, *dv);
  // What the turn of the pieces has changed.
  rigid_guess_.find(p.rigid, p.time_step, p.threads, p.x, alone_, p.couplers, &moved_);
  rigid_guess_.addTo(p.rigid, p.x, dv);
  p.equations->residual(*dv, &alone_);
  return true;
}

/// The momentum of each free piece changes by what acts on it, also by what is below the tolerance. Its share is not a
/// motion of the piece alone: springs would resist that, and drive it by more.
void Newton::balanceRigidly(const StepProblem& p, std::vector<Vec3>* dv) {
  if (!driveFreePieces(p)) return;
  rigid_guess_.step(p.rigid, p.time_step, p.threads, p.x, alone_, p.couplers->springs(), &moved_);
  rigid_guess_.addTo(p.rigid, p.x, dv);
  p.couplers->update(moved_);
  findImpulses(p);
  shareImpulses();
}

/// Those of groups that have settled stay as they are.
bool Newton::takeSprings(const StepProblem& p) {
  if (p.couplers) {
    ++stats_.solves;
    for (std::size_t i = 0; i < used_.size(); ++i)
      if (stats_.solves == 1 || !groups_[groupOf(p, used_[i])].settled) used_[i] = p.couplers->springs()[i];
  }
  return p.equations->setSprings(used_);
}

/// The Newton direction from Δv, likely near a sum of the `basis` if there is one, and what the body alone does along
/// it where springs ask for that. Returns false where a value is not finite.
bool Newton::findDirection(const StepProblem& p, const PieceNorms& norms, const Basis* basis, bool tight) {
  const std::size_t copies = alone_.size();
  limit_ = norms.measures();
  const bool again = tight && !basis && left_over_ < NEARLY * p.tolerance;
  const double asked = (again ? AGAIN : 1) * p.tolerance;
  for (double& limit : limit_) limit *= asked * asked;
  right_ = alone_;
  if (p.couplers) {
    group_of_piece_.resize(limit_.size());
    for (std::size_t c = 0; c < copies; ++c) group_of_piece_[p.piece[c]] = p.group[c];
    for (std::size_t i = 0; i < used_.size(); ++i) addShares(used_[i], p.time_step * used_[i].at(moved_[i]), &right_);
    if (!tight) loosen(norms, p.couplers->looseness());
  }
  direction_.assign(copies, Vec3::Zero());
  left_.resize(copies);
  const int most = p.most_iterations ? *p.most_iterations - stats_.iterations : std::numeric_limits<int>::max();
  stats_.iterations += p.equations->correct(right_, {limit_, most, tight}, basis, &direction_, &left_);
  for (Group& group : groups_) group.share = 1;
  if (!p.couplers) return true;
  pull_.resize(copies);
  double length = 0;
  for (std::size_t c = 0; c < copies; ++c) {
    if (p.held[c] >= 0) continue;
    pull_[c] = right_[c] - left_[c];
    length += direction_[c].squaredNorm();
  }
  for (std::size_t i = 0; i < used_.size(); ++i) {
    way_[i] = p.time_step * weightedSum(used_[i], direction_);
    addShares(used_[i], -p.time_step * (used_[i].stiffness * way_[i]), &pull_);
  }
  return std::isfinite(length);
}

/// Lets each piece have the larger limit of its group's loose solve, since the springs are not yet the right ones;
/// those of groups that have settled wait.
void Newton::loosen(const PieceNorms& norms, double looseness) {
  norms.squares(right_, &square_);
  group_square_.assign(groups_.size(), 0);
  for (std::size_t s = 0; s < square_.size(); ++s) group_square_[group_of_piece_[s]] += square_[s];
  for (std::size_t s = 0; s < square_.size(); ++s) {
    const int group = group_of_piece_[s];
    limit_[s] = std::max(limit_[s], (groups_[group].settled ? 1 : looseness * looseness) * group_square_[group]);
  }
}

/// Where the springs at the end of the direction drive a group back, it has gone too far: finds the point between at
/// which they drive it nowhere along the line.
void Newton::searchLines(const StepProblem& p) {
  for (Group& group : groups_) {
    const bool settled = group.settled;
    group = Group();
    group.settled = settled;
  }
  for (std::size_t c = 0; c < alone_.size(); ++c) {
    if (p.held[c] >= 0) continue;
    Group& group = groups_[p.group[c]];
    group.slope += direction_[c].dot(alone_[c]);
    group.curvature += direction_[c].dot(pull_[c]);
  }
  trySprings(p, false);
  for (Group& group : groups_) group.at_start = group.here;
  trySprings(p, true);
  bool any = false;
  for (Group& group : groups_) {
    // What is left to a group that has settled is rounding.
    group.searches =
        !group.settled && group.here < 0 && group.at_start > 0 && !LineSearch::isNear(group.here, group.at_start);
    any = any || group.searches;
  }
  for (int k = 0; any && k < LineSearch::MOST; ++k) {
    any = false;
    for (Group& group : groups_) {
      if (!group.searches) continue;
      group.search.goOn(group.here, group.bend);
      group.share = group.search.share();
    }
    trySprings(p, true);
    for (Group& group : groups_) {
      group.searches = group.searches && !LineSearch::isNear(group.here, group.at_start);
      any = any || group.searches;
    }
  }
}

/// The slopes at each group's share of its way, or where it starts, and how they bend.
void Newton::trySprings(const StepProblem& p, bool on_the_way) {
  for (std::size_t i = 0; i < used_.size(); ++i)
    tried_[i] = moved_[i] + (on_the_way ? groups_[groupOf(p, used_[i])].share : 0) * way_[i];
  p.couplers->update(tried_);
  for (Group& group : groups_) {
    group.here = group.slope - (on_the_way ? group.share : 0) * group.curvature;
    group.bend = group.curvature;
  }
  for (std::size_t i = 0; i < used_.size(); ++i) {
    Group& group = groups_[groupOf(p, used_[i])];
    const Spring& spring = p.couplers->springs()[i];
    group.here += way_[i].dot(spring.at(tried_[i]));
    group.bend += way_[i].dot(spring.stiffness * way_[i]);
  }
}

/// Goes each group's share of its way.
void Newton::takeStep(const StepProblem& p, std::vector<Vec3>* dv) {
  if (!p.couplers) {
    for (std::size_t c = 0; c < dv->size(); ++c) (*dv)[c] += direction_[c];
    return;
  }
  for (std::size_t c = 0; c < alone_.size(); ++c) {
    if (p.held[c] >= 0) continue;
    const double share = groups_[p.group[c]].share;
    (*dv)[c] += share * direction_[c];
    alone_[c] -= share * pull_[c];
  }
  for (std::size_t i = 0; i < used_.size(); ++i) {
    const double share = groups_[groupOf(p, used_[i])].share;
    impulses_[i] += share * (p.time_step * used_[i].at(moved_[i] + way_[i]) - impulses_[i]);
    moved_[i] += share * way_[i];
  }
}

void Newton::takeBounds(const StepProblem& p) {
  const double share = stats_.solves > MAX_BOUNDS ? 0 : stats_.solves > FAST_BOUNDS ? 0.5 : 1;
  bounds_go_.resize(used_.size());
  for (std::size_t i = 0; i < used_.size(); ++i) bounds_go_[i] = groups_[groupOf(p, used_[i])].share == 1 ? share : 0;
  p.couplers->takeBounds(moved_, bounds_go_);
}

/// Takes the bounds and the springs where the points are now, and compares them with what has acted.
bool Newton::isSettled(const StepProblem& p, const PieceNorms& norms) {
  takeBounds(p);
  p.couplers->update(moved_);
  for (Group& group : groups_) group.largest = group.off = 0;
  for (std::size_t i = 0; i < used_.size(); ++i) {
    Group& group = groups_[groupOf(p, used_[i])];
    const Vec3 force = p.couplers->springs()[i].at(moved_[i]), acted = impulses_[i] / p.time_step;
    group.largest = std::max({group.largest, force.squaredNorm(), acted.squaredNorm()});
    group.off = std::max(group.off, (force - acted).squaredNorm());
  }
  for (Group& group : groups_) group.settled = true;
  right_ = alone_;
  for (std::size_t i = 0; i < used_.size(); ++i)
    addShares(used_[i], p.time_step * p.couplers->springs()[i].at(moved_[i]), &right_);
  norms.squares(right_, &square_);
  bool all = true;
  for (std::size_t s = 0; s < square_.size(); ++s) {
    Group& group = groups_[group_of_piece_[s]];
    const bool no_change = group.off <= SETTLED * SETTLED * group.largest;
    const bool nothing_left = square_[s] <= p.tolerance * p.tolerance * norms.measures()[s];
    if (group.share == 1 && (no_change || nothing_left)) continue;
    group.settled = all = false;
  }
  return all;
}

/// Whether it is so under bounds as they are now.
bool Newton::isSettledAnew(const StepProblem& p, const PieceNorms& norms) {
  p.couplers->takeBounds(moved_);
  return isSettled(p, norms);
}

/// What the springs do where they are now.
void Newton::findImpulses(const StepProblem& p) {
  for (std::size_t i = 0; i < used_.size(); ++i) impulses_[i] = p.time_step * p.couplers->springs()[i].at(moved_[i]);
}

void Newton::shareImpulses() {
  on_copies_.assign(alone_.size(), Vec3::Zero());
  for (std::size_t i = 0; i < used_.size(); ++i) addShares(used_[i], impulses_[i], &on_copies_);
}

void Newton::takeRatio(const PieceNorms::Ratio& ratio) {
  left_over_ = ratio.of_measure;
  stats_.residual = ratio.of_loads;
}

void Newton::measureLeft(PieceNorms* norms) {
  if (used_.empty()) return takeRatio(norms->worstRatio(alone_));
  shareImpulses();
  norms->raise(on_copies_);
  right_.resize(alone_.size());
  for (std::size_t c = 0; c < right_.size(); ++c) right_[c] = alone_[c] + on_copies_[c];
  takeRatio(norms->worstRatio(right_));
}

/// That of its first copy which is not held; where all are, it moves nothing.
int Newton::groupOf(const StepProblem& p, const Spring& spring) {
  for (int k = 0; k < spring.count; ++k)
    if (p.held[spring.copies[k]] < 0) return p.group[spring.copies[k]];
  return p.group[spring.copies[0]];
}

}  // namespace incision

#pragma once

#include <algorithm>
#include <any>
#include <vector>

#include "incision/solver/coupler.h"

namespace incision {

/// The couplers of a body, in the order in which their springs are listed. They must outlive the list.
class Couplers {
 public:
  Couplers() = default;
  explicit Couplers(std::vector<Coupler*> list);

  bool areNone() const { return list_.empty(); }

  void changed(const CutMesh& mesh);

  /// A step starts. Returns whether any coupler takes part in it.
  bool begin(const StepStart& start);

  /// The points of the springs are displaced by `moved` [m], and the bounds become what they are here; or each goes
  /// that share of the way.
  void takeBounds(const std::vector<Vec3>& moved);
  void takeBounds(const std::vector<Vec3>& moved, const std::vector<double>& share);
  /// Gives the springs their forces and stiffnesses at these displacements [m].
  void update(const std::vector<Vec3>& moved);
  /// The least of those that take part.
  double looseness() const;

  /// All that may act in the step, each with the index of its coupler. Those that do not press have neither force nor
  /// stiffness.
  const std::vector<Spring>& springs() const { return springs_; }

  /// What the springs do to the other end of each coupler by these impulses [N s] in the step, `y` [m] being the lever
  /// of each; zero for couplers that have no other end.
  void findWrenches(const std::vector<Vec3>& impulses, const std::vector<Vec3>& y, std::vector<Wrench>* wrenches) const;

  /// Whether all are as they were reckoned.
  bool hold(const std::vector<Vec3>& moved, const Motion& end);

  /// Whether springs without another end, by these impulses [N s], do far more for the body on the ways of its copies
  /// from `start` to `end` [m] than on the straight ones by `moved` [m] on which they were reckoned. Where a piece
  /// turns that brings energy, and more with each step.
  bool driveOn(const std::vector<Vec3>& impulses, const std::vector<Vec3>& moved, const std::vector<Vec3>& start,
               const std::vector<Vec3>& end) const;

  /// The step has been taken. `felt` is the wrench on each coupler's other end.
  void accept(const std::vector<Vec3>& moved, const Motion& end, const std::vector<Wrench>& felt);

  /// The step that has begun has failed.
  void stepFailed();

  /// Of values of all springs, those of a coupler.
  Span<const Vec3> ofCoupler(const Coupler& coupler, const std::vector<Vec3>& values) const {
    return ofCoupler(static_cast<std::size_t>(std::find(list_.begin(), list_.end(), &coupler) - list_.begin()), values);
  }

  /// Joins the pieces that couplers tie together: they are numbered anew, in the order in which they were. `piece` is
  /// that of each copy. Returns how many pieces there are.
  int joinPieces(const CutMesh& mesh, int pieces, std::vector<int>* piece) const;

  std::vector<std::any> keep() const;
  void keepIn(std::vector<std::any>* kept) const;
  void recall(const std::vector<std::any>& kept);
  void write(const std::vector<std::any>& kept, ArchiveWriter* archive) const;
  std::vector<std::any> read(ArchiveReader* archive) const;

 private:
  template <class Value>
  Span<const Value> ofCoupler(std::size_t i, const std::vector<Value>& values) const {
    return {values.data() + first_[i], values.data() + first_[i + 1]};
  }

  std::vector<Coupler*> list_;
  std::vector<char> takes_part_;    // in this step, of each coupler
  std::vector<std::size_t> first_;  // spring of each coupler; then how many there are
  StepSpan span_ = {};
  std::vector<Spring> springs_;
  std::vector<double> whole_way_;  // of each spring: 1
};

}  // namespace incision

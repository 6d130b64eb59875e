#pragma once

#include <any>
#include <vector>

#include "incision/solver/coupler.h"

namespace incision {

/// The couplers of a body, in the order in which their springs are listed. They must outlive the list.
class Couplers {
 public:
  Couplers() = default;
  explicit Couplers(std::vector<Coupler*> list);

  void changed(const CutMesh& mesh);

  /// A step starts. Returns whether any coupler may act in it.
  bool begin(const StepStart& start);

  /// Finds the springs for these velocities at the step's end [m/s]. Returns whether they differ from the last ones by
  /// enough for another solve.
  bool update(const std::vector<Vec3>& v_end);

  /// Those found last, each with the index of its coupler.
  const std::vector<Spring>& springs() const { return springs_; }

  /// What the springs do to the other end of each coupler, as wrenchOf says, for the copies' positions `x` [m] at the
  /// step's start; zero for couplers that have no other end.
  void findWrenches(const std::vector<Vec3>& x, const std::vector<Vec3>& v_end, std::vector<Wrench>* wrenches) const;

  /// The step has been taken. `felt` is the wrench on each coupler's other end.
  void accept(const Motion& end, const std::vector<Wrench>& felt);

  /// The step that has begun has failed.
  void stepFailed();

  /// Joins the pieces that couplers tie together: they are numbered anew, in the order in which they were. `piece` is
  /// that of each copy. Returns how many pieces there are.
  int joinPieces(const CutMesh& mesh, int pieces, std::vector<int>* piece) const;

  std::vector<std::any> keep() const;
  void recall(const std::vector<std::any>& kept);
  void write(const std::vector<std::any>& kept, ArchiveWriter* archive) const;
  std::vector<std::any> read(ArchiveReader* archive) const;

 private:
  std::vector<Coupler*> list_;
  std::vector<char> may_act_;  // in this step, of each coupler
  StepSpan span_ = {};
  std::vector<Spring> springs_;
};

}  // namespace incision

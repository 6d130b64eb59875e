#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "incision/base/disjoint_sets.h"
#include "incision/base/lists.h"
#include "incision/base/memory.h"
#include "incision/cut/cut_mesh.h"
#include "incision/rigid/wrench.h"
#include "incision/solver/motion.h"
#include "incision/solver/spring.h"

namespace incision {

/// The time that a step takes.
struct StepSpan {
  double time_step;  ///< [s]
  /// The share of the body's whole step that this one is: all of it, or one half after the other when the whole has
  /// failed. What moves in a given way in the whole step goes from the first share of its way to the second.
  double from = 0, to = 1;

  /// Whether the whole step ends with this one.
  bool isLast() const { return to == 1; }
  bool isWhole() const { return from == 0 && to == 1; }
};

/// A number that it has never returned before.
inline std::uint64_t newSerial() {
  static std::atomic<std::uint64_t> last = 0;
  return ++last;
}

/// The body as couplers find it when a step starts.
struct StepStart {
  StepSpan span;
  const CutMesh& mesh;
  const std::vector<int>& piece;  ///< of each copy
  const Motion& motion;
  const std::vector<Vec3>& ahead;         ///< how far each copy goes in the step if nothing new acts on it [m]
  const std::vector<double>& inertia;     ///< what each copy resists with in the step: a third of trace(A_cc) [kg]
  const std::vector<double>& piece_mass;  ///< of each piece, infinite where it is held [kg]
  std::uint64_t serial = newSerial();     ///< no other start has it: what several couplers need is found once for it
};

/// Something that acts on copies in a step by springs between them, or to something outside: contact, cohesion, ties, a
/// blade's edge. The forces descend from a convex potential of the displacements in the step, as long as the bounds
/// stay: what of a force depends on another force, as friction's limit on the pressure.
///
/// Its memory changes in `changed` and `accept` alone: a step that fails leaves no trace in it. What it changes in
/// `begin` it takes back in `stepFailed`.
class Coupler : public Remembers {
 public:
  /// The mesh has changed, or is another one.
  virtual void changed(const CutMesh& mesh) = 0;

  /// A step starts. Appends the springs that may act in it; what they do is for `update` to say. Returns whether the
  /// coupler takes part in the step; if not, it has no springs and the functions below are not called.
  virtual bool begin(const StepStart& start, std::vector<Spring>* springs) = 0;

  /// The points of its springs have come to displacements of `moved` [m] in the search for the solution. The bound of
  /// each goes that share of the way to what it is here.
  virtual void takeBounds(Span<const Vec3> /*moved*/, Span<const double> /*share*/) {}

  /// Gives each of its springs the force and the stiffness at these displacements [m] under the bounds taken last.
  virtual void update(Span<const Vec3> moved, Span<Spring> springs) = 0;

  /// What a solve before the last may leave of the residual. Where springs come and go from solve to solve, as contacts
  /// do, a loose one finds wrong ones.
  virtual double looseness() const { return 1e-2; }

  /// Whether it is as it was reckoned where the step ends, with these displacements [m] of its springs' points: what is
  /// reckoned along straight ways may not be where pieces turn. If not, the step is better taken in shorter ones.
  virtual bool holds(const StepSpan& /*span*/, Span<const Vec3> /*moved*/, const Motion& /*end*/) { return true; }

  /// The step has been taken, to these displacements [m] of its springs' points. `felt` is what the springs have done
  /// to their other end, as wrenchOf says; without another end it is zero.
  virtual void accept(const StepSpan& span, Span<const Vec3> moved, const Motion& end, const Wrench& felt) = 0;

  /// The step that has begun has failed.
  virtual void stepFailed() {}

  /// Whether the springs have another end, outside the body, whose wrench is asked for.
  virtual bool hasOtherEnd() const { return false; }

  /// Joins pieces, given by the mesh's number of each copy's piece, that count as one because the coupler ties them.
  virtual void joinPieces(const CutMesh& /*mesh*/, const std::vector<int>& /*piece*/, DisjointSets* /*sets*/) const {}
};

}  // namespace incision

#pragma once

#include <memory>
#include <vector>

#include "incision/solver/couplers.h"
#include "incision/solver/rigid_pieces.h"

namespace incision {

/// What couplers would do in a step if the free pieces were rigid: a guess from which the body's own Newton steps
/// begin. In a stiff contact, where each spring that closes stops a Newton step short, it takes the many steps that it
/// needs in six unknowns a piece.
class RigidGuess {
 public:
  RigidGuess();
  ~RigidGuess();

  /// Finds the rigid motions of free pieces beside their base at which the couplers' forces and `driving` [N s], what
  /// drives each copy on where Δv = 0, balance; leaves the springs as they are there. `moved` [m], the displacements of
  /// their points where Δv = 0, goes along. `x` are the places of the base [m].
  void find(const RigidPieces& rigid, double time_step, int threads, const std::vector<Vec3>& x,
            const std::vector<Vec3>& driving, Couplers* couplers, std::vector<Vec3>* moved);

  /// Finds the motions at which `driving` and the springs balance if these stay linear, as they are at `moved`, which
  /// goes along: one Newton step from no motion beside the base.
  void step(const RigidPieces& rigid, double time_step, int threads, const std::vector<Vec3>& x,
            const std::vector<Vec3>& driving, const std::vector<Spring>& springs, std::vector<Vec3>* moved);

  /// Adds these motions to `dv` [m/s].
  void addTo(const RigidPieces& rigid, const std::vector<Vec3>& x, std::vector<Vec3>* dv) const;

 private:
  struct Work;  // Eigen's own memory: it must come and go on one side of the library's border
  std::unique_ptr<Work> work_;
};

}  // namespace incision

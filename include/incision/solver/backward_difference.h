#pragma once

#include "incision/base/memory_limits.h"
#include "incision/solver/implicit_step.h"

namespace incision {

/// Steps of second order in time, by the backward difference formula of two steps (BDF2; Curtiss and Hirschfelder
/// 1952),
///   x = x̂ + h v,  M (v − v̂) = h f(x, v),  h = 2/3 Δt,  x̂ = x_n + (x_n − x_{n−1})/3,  v̂ = v_n + (v_n − v_{n−1})/3,
/// free pieces in the frame of their rigid motion: that is an implicit Euler step of length h from (x̂, v̂), so it costs
/// no more and damps what is stiff as well. The rotations are always those where the body goes if nothing new acts,
/// which is as near to the step's end as second order asks for.
class BackwardDifference {
 public:
  /// What outlasts a step.
  struct Memory {
    bool known = false;  ///< whether there is a step to look back to
    Motion before;       ///< x_{n−1}, v_{n−1}
  };
  const Memory& keep() const { return memory_; }
  /// Copies what counts of it into the room that `kept` has.
  void keepIn(Memory* kept) const {
    kept->known = memory_.known;
    if (memory_.known) kept->before = memory_.before;
  }
  void recall(const Memory& memory) { memory_ = memory; }

  /// Forgets the past, so that the next step is one of implicit Euler: after what the past does not foresee, a cut or
  /// an impact, from which the formula would rebound.
  void forget() { memory_.known = false; }

  /// Advances from `time` by `time_step` [s], always the same while the past is known. Returns false, with the motion
  /// and the memory as they were, where ImplicitStep::advance does.
  bool advance(double time, double time_step, ImplicitStep* step, Motion* motion);

 private:
  Memory memory_;
  Motion start_;
};

/// What it looks back to counts only where it is known.
template <class Archive>
void serialize(Archive& archive, BackwardDifference::Memory& memory) {
  auto& [known, before] = memory;
  archive(known);
  if (known) archive(before);
}

void check(const BackwardDifference::Memory& memory, const MemoryLimits& limits);

}  // namespace incision

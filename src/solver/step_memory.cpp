// What memories of a step must be.
#include <algorithm>

#include "incision/base/limits.h"
#include "incision/solver/backward_difference.h"
#include "incision/solver/implicit_step.h"

namespace incision {
namespace {

/// How far a rotation may be off one by rounding.
constexpr double ROUNDING = 1e-6;

/// More steps than a fallback, and factorisations than a list of blocks, ever last.
constexpr int LONGEST = 1 << 20;

/// Pairs of the numbers of copies, or of less of something.
void checkBlocks(const std::vector<std::pair<int, int>>& blocks, int copies) {
  for (const auto& [row, column] : blocks)
    require(isOneOf(row, copies) && isOneOf(column, copies), "a block of its matrix is of no copy");
  require(std::adjacent_find(blocks.begin(), blocks.end(), std::greater_equal<>()) == blocks.end(),
          "the blocks of its matrix are not in order");
}

}  // namespace

void check(const Motion& motion, const MemoryLimits& limits) {
  const auto copies = static_cast<std::size_t>(limits.copies);
  require(motion.x.size() == copies && motion.v.size() == copies, "its motion is not that of its copies");
  for (const Vec3& x : motion.x) require(x.cwiseAbs().maxCoeff() <= MAX_COORDINATE, "a copy is too far away");
}

void check(const ImplicitStep::Memory& memory, const MemoryLimits& limits) {
  const auto copies = static_cast<std::size_t>(limits.copies);
  for (const std::vector<Vec3>& differences : memory.basis)
    require(differences.empty() || differences.size() == copies, "its first guess is not that of its copies");
  require(memory.group.size() == copies, "its groups are not those of its copies");
  for (const int group : memory.group) require(isOneOf(group, limits.pieces), "a group is of no piece");
  require(isOneOf(memory.fallback_steps, LONGEST), "its solver stands in for too long");
  require(isOneOf(memory.solver.idle, LONGEST), "its matrix is idle for too long");
  checkBlocks(memory.solver.blocks, limits.copies);
  checkBlocks(memory.solver.coarse_blocks, limits.copies);
  require(memory.solver_time_step >= 0, "its time step is below 0");
  require(memory.rotations.empty() || memory.rotations.size() == limits.element_of_part.size(),
          "its rotations are not those of its parts");
  for (const Mat3& R : memory.rotations)
    require((R.transpose() * R - Mat3::Identity()).cwiseAbs().maxCoeff() <= ROUNDING, "a rotation is none");
}

void check(const BackwardDifference::Memory& memory, const MemoryLimits& limits) {
  if (memory.known) check(memory.before, limits);
}

}  // namespace incision

#pragma once

#include <cstdint>
#include <memory>

#include "incision/body/deformable_body.h"
#include "incision/fem/assembly.h"
#include "incision/solver/motion.h"

namespace incision {

/// As DeformableBody::motion and ::stateHash have them, for the rotations that the assembly knows.
BodyMotion motionOf(const Assembly& assembly, const Motion& motion, const Vec3& gravity);
std::uint64_t hashOf(std::int64_t steps, const CutMesh& mesh, const Motion& motion);

/// Reckons what takes all of a body from a copy of its mesh, on any thread. Energies may differ from those that the
/// body tells by their last digits.
class StateView {
 public:
  /// `materials`, which must outlive this, and `settings` are the body's; `x` is where the copies are [m].
  StateView(std::shared_ptr<const CutMesh> mesh, const Materials& materials, const BodySettings& settings,
            const std::vector<Vec3>& x);

  const CutMesh& mesh() const { return *mesh_; }

  BodyMotion motion(const Motion& motion, const Vec3& gravity);
  std::uint64_t hash(std::int64_t steps, const Motion& motion) const { return hashOf(steps, *mesh_, motion); }

 private:
  std::shared_ptr<const CutMesh> mesh_;
  Assembly assembly_;
};

}  // namespace incision

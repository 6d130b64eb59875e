#pragma once

#include <optional>
#include <vector>

#include "incision/cut/mesh_door.h"
#include "incision/fracture/growth.h"
#include "incision/solver/backward_difference.h"
#include "incision/solver/couplers.h"
#include "incision/solver/implicit_step.h"
#include "incision/surface/current_surface.h"
#include "incision/tool/near_parts.h"

namespace incision {

/// The door of a body's mesh: it alone changes the mesh. Copies and couplers follow each change at once; what costs in
/// proportion to the mesh follows in `finish`, once for all changes since the last call.
class BodyDoor : public MeshDoor {
 public:
  /// Those who depend on the mesh; all must outlive this.
  BodyDoor(CutMesh* mesh, Motion* motion, ImplicitStep* step, BackwardDifference* last_steps,
           std::optional<CrackGrowth>* growth, Couplers* couplers, NearParts* near_parts, CurrentSurface* surface);

  const CutMesh& mesh() const override { return *mesh_; }
  Insertion insert(const CrackField& crack) override;

  /// Must be called after changes, before anything but the door is used.
  void finish();

  /// Changes since the last `finish` have been undone.
  void forgetChanges() noexcept;

  /// Another mesh has taken the place of the one there was, for which the motion holds already, or nobody who depends
  /// on it can be relied on: all is found anew.
  void meshReplaced();

 private:
  void tellAll();

  CutMesh* mesh_;
  Motion* motion_;
  ImplicitStep* step_;
  BackwardDifference* last_steps_;
  std::optional<CrackGrowth>* growth_;
  Couplers* couplers_;
  NearParts* near_parts_;
  CurrentSurface* surface_;
  std::vector<int> touched_;  // nodes, since the last finish
  bool is_changed_ = false;
};

}  // namespace incision

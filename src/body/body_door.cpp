#include "body_door.h"

namespace incision {

BodyDoor::BodyDoor(CutMesh* mesh, Motion* motion, ImplicitStep* step, BackwardDifference* last_steps,
                   std::optional<CrackGrowth>* growth, Couplers* couplers, NearParts* near_parts,
                   CurrentSurface* surface)
    : mesh_(mesh),
      motion_(motion),
      step_(step),
      last_steps_(last_steps),
      growth_(growth),
      couplers_(couplers),
      near_parts_(near_parts),
      surface_(surface) {}

/// New copies start where their parent is, and move as it does.
Insertion BodyDoor::insert(const CrackField& crack) {
  Insertion done = mesh_->insert(crack);
  if (!done.changed()) return done;
  for (int c = static_cast<int>(motion_->x.size()); c < mesh_->numCopies(); ++c) {
    motion_->x.push_back(motion_->x[mesh_->copyParent(c)]);
    motion_->v.push_back(motion_->v[mesh_->copyParent(c)]);
  }
  couplers_->changed(*mesh_);
  touched_.insert(touched_.end(), done.touched.begin(), done.touched.end());
  is_changed_ = true;
  return done;
}

void BodyDoor::finish() {
  if (!is_changed_) return;
  tellAll();
}

void BodyDoor::forgetChanges() noexcept {
  touched_.clear();
  is_changed_ = false;
}

void BodyDoor::meshReplaced() {
  near_parts_->forget();
  step_->reset();
  couplers_->changed(*mesh_);
  tellAll();
}

void BodyDoor::tellAll() {
  step_->topologyChanged(*motion_, touched_);
  last_steps_->forget();
  if (*growth_) (*growth_)->topologyChanged(step_->assembly(), touched_);
  surface_->changed();
  touched_.clear();
  is_changed_ = false;
}

}  // namespace incision

#pragma once

#include "incision/cut/cut_mesh.h"

namespace incision {

/// The one door through which a body's mesh changes. What must follow a change follows by itself: new copies get their
/// place, and everybody who depends on the mesh is told.
class MeshDoor {
 public:
  virtual ~MeshDoor() = default;

  virtual const CutMesh& mesh() const = 0;

  /// Does what CutMesh::insert does, and throws what it throws.
  virtual Insertion insert(const CrackField& crack) = 0;
};

}  // namespace incision

#pragma once

#include <optional>
#include <vector>

#include "incision/cut/cut_mesh.h"

namespace incision {

/// A place in a part, and how a cut must lie to be there. All of it is reckoned at rest, where cuts are closed.
struct CutSought {
  Vec3 point = Vec3::Zero();   ///< [m]
  Vec3 normal = Vec3::Zero();  ///< of a surface through the point, of any length; zero: none, cuts at any angle count
  double distance = 0;         ///< of the cut from the point, across the cut [m]
  double cosine = 0;           ///< least |cosine| of the angle between the surface and the cut
  /// A crack that is still growing. It counts in the part itself alone: what lies beside a part it has cut is what it
  /// comes to next.
  std::optional<int> growing;
};

/// Whether there is a cut at a place in a part. Cuts are the faces that cracks have cut into parts, and the faces of
/// the mesh that they have severed, of this part and of the parts whose elements share a node with its own.
///
/// A cut into the part itself is there when the point is near the plane of its face. A cut of another part, or one
/// along a face of the mesh, is there when the point moreover is not beyond the rim of what is cut: it is no farther
/// from that along the cut than across. So a part has the cuts that it touches with an edge or a node alone, what comes
/// after a cut's end has none, and neither has what of a face of the mesh is not severed yet.
bool isCutHere(const CutMesh& mesh, int part, const CutSought& sought);

/// Whether the crack φ = 0, φ being given at the nodes of the part's element [m], would be an earlier cut again: its
/// section through the part lies everywhere within `distance` [m] of the plane of a face cut into the same part, and
/// that face within the distance of the crack. A small section near an edge of the part is close to a face that it
/// crosses at any angle. No other part is asked, so neighbours decide alike.
bool isCutHere(const CutMesh& mesh, int part, const std::vector<Barycentric>& section, const Eigen::Vector4d& phi,
               double distance);

}  // namespace incision

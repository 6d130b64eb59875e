#pragma once

#include <vector>

#include "incision/contact/candidate.h"
#include "incision/contact/contact_skin.h"
#include "incision/contact/obstacles.h"
#include "incision/rigid/rigid_motion.h"

namespace incision {

/// Solids in a step, on links that move.
struct SolidsInStep {
  const Obstacles& solids;
  const std::vector<RigidMotion>& motions;  ///< of each link, in the body's whole step

  /// Whether the solids may stand in a slit, as those of a blade do. A vertex that comes to lie in one then goes to the
  /// side of its own material, each face of the slit to its own:
  ///
  ///     material  | solid |  material
  ///      normal → |←     →| ← normal       each face is pushed against its normal
  ///
  bool in_slits = false;

  /// A cutting edge in its link's frame, or null. Where a solid is nearer to it than the solid is thick, the edge cuts
  /// instead of pushing, and nothing is touched.
  const Edge* cutting_edge = nullptr;
};

/// Appends the candidates of the surface's vertices against each solid, for a step from where the skin is now, in the
/// order of the solids and then of the vertices. The plane of a candidate is the solid's at the point of it that is
/// nearest when the step starts, carried along with it: a body that starts on one side stays there, however fast it is
/// and however thin the solid. `touches`, the contacts of the last step, tell on which side points are that have been
/// pressed in.
void findSolidContacts(const ContactSkin& skin, const StepSpan& span, const SolidsInStep& solids,
                       const std::vector<Touch>& touches, std::vector<Candidate>* candidates);

/// Whether no vertex is deeper in a solid at the end of the step, where the vertices are at `x` [m], than was reckoned
/// with the displacements `moved` of the candidates [m], by more than is allowed; nor one that is no candidate, since
/// an impact may turn a piece so that it goes where nothing was foreseen.
bool areSolidsAsReckoned(const ContactSkin& skin, const StepSpan& span, const SolidsInStep& solids,
                         const std::vector<Candidate>& candidates, Span<const Vec3> moved, const std::vector<Vec3>& x);

}  // namespace incision

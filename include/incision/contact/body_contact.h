#pragma once

#include "incision/contact/contact.h"
#include "incision/contact/fragments.h"
#include "incision/contact/obstacles.h"
#include "incision/contact/settings.h"
#include "incision/rigid/rigid_motion.h"

namespace incision {

/// Contact of a body with obstacles and with itself.
class BodyContact : public Contact {
 public:
  /// `motions`: of the obstacles' links in the body's whole step. `obstacles`, `motions` and `skin` must outlive this.
  BodyContact(const ContactSettings& settings, const Obstacles& obstacles, const std::vector<RigidMotion>& motions,
              ContactSkin* skin);

  void changed(const CutMesh& /*mesh*/) override { fragments_.surfaceChanged(); }
  bool holds(const StepSpan& span, Span<const Vec3> moved, const Motion& end) override;

  /// Adds what the springs did to the ground and to each obstacle's link by these impulses [N s] on the body in the
  /// step that has been taken, as the mean over `time` [s]: about the origin of the body's frame, by these levers [m].
  void addWrenches(Span<const Vec3> impulses, Span<const Vec3> levers, double time, Wrench* ground,
                   std::vector<Wrench>* links) const;

 protected:
  void find(const ContactSkin& skin, const StepStart& start, const std::vector<Touch>& touches,
            std::vector<Candidate>* candidates) override;

 private:
  bool self_;
  const Obstacles& obstacles_;
  const std::vector<RigidMotion>& motions_;
  FragmentFinder fragments_;
  std::vector<Vec3> ends_;  // of the skin's vertices, where a step ends [m]
};

}  // namespace incision

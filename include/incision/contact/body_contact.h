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

 protected:
  void find(const ContactSkin& skin, const StepStart& start, const std::vector<Touch>& touches,
            std::vector<Candidate>* candidates) override;

 private:
  bool self_;
  const Obstacles& obstacles_;
  const std::vector<RigidMotion>& motions_;
  FragmentFinder fragments_;
};

}  // namespace incision

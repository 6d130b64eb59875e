#pragma once

#include "incision/contact/contact.h"
#include "incision/contact/fragments.h"
#include "incision/contact/obstacles.h"
#include "incision/contact/settings.h"
#include "incision/rigid/rigid_motion.h"

namespace incision {

/// What of a body's contacts outlasts a step.
struct BodyContactMemory {
  std::vector<Touch> touches;
  FragmentFinder::Memory fragments;
};

template <class Archive>
void serialize(Archive& archive, BodyContactMemory& memory) {
  auto& [touches, fragments] = memory;
  archive(touches, fragments);
}

/// Contact of a body with obstacles and with itself.
class BodyContact : public Contact {
 public:
  /// `motions`: of the obstacles' links in the body's whole step. `obstacles`, `motions` and `skin` must outlive this.
  BodyContact(const ContactSettings& settings, const Obstacles& obstacles, const std::vector<RigidMotion>& motions,
              ContactSkin* skin);

  void changed(const CutMesh& /*mesh*/) override { fragments_.surfaceChanged(); }
  void stepFailed() override { fragments_.stepFailed(); }

  std::any keep() const override { return BodyContactMemory{memory_, fragments_.keep()}; }
  void recall(const std::any& kept) override;
  void write(const std::any& kept, ArchiveWriter* archive) const override {
    writeKept<BodyContactMemory>(kept, archive);
  }
  std::any read(ArchiveReader* archive) const override { return readKept<BodyContactMemory>(archive); }

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

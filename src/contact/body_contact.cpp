#include "incision/contact/body_contact.h"

#include "incision/contact/solid_contacts.h"

namespace incision {

BodyContact::BodyContact(const ContactSettings& settings, const Obstacles& obstacles,
                         const std::vector<RigidMotion>& motions, ContactSkin* skin)
    : Contact(settings.friction, skin), self_(settings.self), obstacles_(obstacles), motions_(motions) {}

void BodyContact::find(const ContactSkin& skin, const StepStart& start, const std::vector<Touch>& touches,
                       std::vector<Candidate>* candidates) {
  if (self_) fragments_.find(skin.surface(), skin.x(), skin.ahead(), touches, skin.threads(), candidates);
  findSolidContacts(skin, start.span, {obstacles_, motions_}, touches, candidates);
}

}  // namespace incision

#include "incision/contact/body_contact.h"

#include "incision/contact/solid_contacts.h"

namespace incision {

BodyContact::BodyContact(const ContactSettings& settings, const Obstacles& obstacles,
                         const std::vector<RigidMotion>& motions, ContactSkin* skin)
    : Contact(settings.friction, skin), self_(settings.self), obstacles_(obstacles), motions_(motions) {}

bool BodyContact::holds(const StepSpan& span, Span<const Vec3> moved, const Motion& end) {
  interpolate(*skin().surface().surface, end.x, skin().threads(), &ends_);
  return areSolidsAsReckoned(skin(), span, {obstacles_, motions_}, candidates(), moved, ends_) &&
         fragments_.isAsReckoned(skin().surface(), candidates(), moved, span.to - span.from, ends_, skin().threads());
}

void BodyContact::addWrenches(Span<const Vec3> impulses, Span<const Vec3> levers, double time, Wrench* ground,
                              std::vector<Wrench>* links) const {
  for (int i = 0; i < impulses.size(); ++i) {
    const Candidate& candidate = candidates()[static_cast<std::size_t>(i)];
    if (candidate.isOfBody()) continue;
    const int link = obstacles_.shapes[static_cast<std::size_t>(candidate.partner)].link;
    Wrench& sum = link == GROUND_LINK ? *ground : (*links)[static_cast<std::size_t>(link)];
    sum += wrenchOf(impulses[i] / time, levers[i]);
  }
}

void BodyContact::find(const ContactSkin& skin, const StepStart& start, const std::vector<Touch>& touches,
                       std::vector<Candidate>* candidates) {
  if (self_) fragments_.find(skin.surface(), skin.x(), skin.ahead(), touches, skin.threads(), candidates);
  findSolidContacts(skin, start.span, {obstacles_, motions_}, touches, candidates);
}

}  // namespace incision

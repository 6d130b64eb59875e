#include "incision/tool/tool_contact.h"

#include <utility>

#include "incision/contact/solid_contacts.h"

namespace incision {

ToolContact::ToolContact(int group, Obstacles shapes, double friction, const std::optional<Edge>& edge,
                         ContactSkin* skin)
    : Contact(friction, skin), group_(group), shapes_(std::move(shapes)), edge_(edge), motions_(1) {}

void ToolContact::accept(const StepSpan& span, Span<const Vec3> moved, const Motion& end, const Wrench& felt) {
  Contact::accept(span, moved, end, felt);
  tool_->feel(group_, span, felt);
}

void ToolContact::find(const ContactSkin& skin, const StepStart& start, const std::vector<Touch>& touches,
                       std::vector<Candidate>* candidates) {
  motions_[0] = tool_->groups[static_cast<std::size_t>(group_)];
  SolidsInStep solids{shapes_, motions_};
  solids.in_slits = true;
  if (edge_ && tool_->active) solids.cutting_edge = &*edge_;
  findSolidContacts(skin, start.span, solids, touches, candidates);
}

}  // namespace incision

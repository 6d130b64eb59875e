#include "incision/pace/link_lookup.h"

#include <utility>

#include "incision/pace/validation.h"

namespace incision {

LinkLookup::LinkLookup(const Frames& frames, Complain complain) : frames_(frames), complain_(std::move(complain)) {}

std::optional<StampedPose> LinkLookup::find(const std::string& link, Nanoseconds end) {
  if (link == frames_.body() || !frames_.knows(link)) return std::nullopt;
  std::string why_not;
  std::optional<StampedPose> found;
  if (end > 0) found = frames_.find(link, end, nullptr);
  if (!found) found = frames_.find(link, 0, &why_not);
  if (!found) {
    ignore(link, "tf knows it, but not where it is in \"" + frames_.body() + "\" " + why_not);
  } else if (const auto refused = whyRefused(found->pose)) {
    ignore(link, refused->reason);
    found.reset();
  }
  return found;
}

void LinkLookup::ignore(const std::string& link, const std::string& why) {
  ++ignored_;
  complain_(link, why);
}

LinkLookup::Complain warnOfLinks(const std::string& owner, Answers& answers) {
  return [owner, &answers](const std::string& link, const std::string& why) {
    const std::string whose = "link \"" + link + "\" of " + owner;
    answers.warn(whose, whose + " stays where it is: " + why);
  };
}

}  // namespace incision

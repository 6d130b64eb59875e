#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "incision/pace/answers.h"
#include "incision/pace/frames.h"

namespace incision {

/// Looks up where links are, each by the frame of its name, and counts what is of no use.
class LinkLookup {
 public:
  /// Says why a link stays where it is.
  using Complain = std::function<void(const std::string& link, const std::string& why)>;

  LinkLookup(const Frames& frames, Complain complain);

  /// Where the link is at the time `end`; where that is not known yet, or `end` is 0, where it was at last. Nothing for
  /// a frame of which nobody has heard, and for a pose of no use.
  std::optional<StampedPose> find(const std::string& link, Nanoseconds end);

  /// Poses of no use, so far.
  std::uint64_t ignored() const { return ignored_; }

 private:
  void ignore(const std::string& link, const std::string& why);

  const Frames& frames_;
  Complain complain_;
  std::uint64_t ignored_ = 0;
};

/// Warns of links that stay where they are. `owner`: whose they are.
LinkLookup::Complain warnOfLinks(const std::string& owner, Answers& answers);

}  // namespace incision

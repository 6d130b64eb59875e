#pragma once

#include <tf2/buffer_core.h>

#include <optional>
#include <string>

#include "incision/pace/command.h"
#include "incision/rigid/pose.h"

namespace incision {

/// Looks up in tf where links are, and never waits. What is of no use is counted and logged.
class LinkLookup {
 public:
  struct Found {
    Pose pose;  ///< in the body's frame
    Nanoseconds stamp;
  };

  /// `whose`: the links, for the log.
  LinkLookup(const tf2::BufferCore& buffer, std::string body_frame, std::string whose);

  /// Where the link is at `end`; where tf does not know that yet, or `end` is 0, where it was at last. Nothing for a
  /// frame that tf has never heard of, and for a transform of no use.
  std::optional<Found> find(const std::string& link, Nanoseconds end);

  /// Transforms of no use, so far.
  std::uint64_t ignored() const { return ignored_; }

 private:
  void ignore(const std::string& link, const std::string& why);

  const tf2::BufferCore& buffer_;
  const std::string body_frame_, whose_;
  std::uint64_t ignored_ = 0;
};

}  // namespace incision

#pragma once

#include <vector>

#include "incision/contact/candidate.h"

namespace incision {

/// What contacts between two pieces that end leave to those that begin there: where a vertex slides from a face, an
/// edge takes over, and the next one from that. One that begins deep without any energy would leave that depth alone,
/// and so the pieces would creep into each other from contact to contact.
class Legacy {
 public:
  /// A step starts, after which `touches` were left: none of them goes on yet.
  void begin(const std::vector<Touch>& touches);

  /// The touch, one of those, goes on.
  void goesOn(const Touch& touch) { ended_[&touch - touches_->data()] = false; }

  /// Presses candidates of the body that leave a depth alone with the energy of the touches between their pieces that
  /// ended, in their order until it is used up.
  void share(const ContactSurface& surface, std::vector<Candidate>* candidates);

 private:
  /// Two pieces and what their touches have left.
  struct Left {
    int one, other;
    double energy;  // [J]
  };

  const std::vector<Touch>* touches_ = nullptr;
  std::vector<char> ended_;
  std::vector<Left> left_;  // by pieces
};

}  // namespace incision

#pragma once

namespace incision {

/// What touched in a step.
struct ContactReport {
  int count = 0;       ///< points that were pressed
  double deepest = 0;  ///< largest depth of one of them at the end of the step [m]
  double energy = 0;   ///< in the springs that press and drag [J]

  void add(const ContactReport& other);
};

}  // namespace incision

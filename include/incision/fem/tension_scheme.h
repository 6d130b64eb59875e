#pragma once

namespace incision {

/// Whether the pull of what is under tension turns with the body in the same step.
enum class TensionScheme {
  EXPLICIT,  ///< only in the next one
  IMPLICIT,  ///< in all held pieces
  AUTO,      ///< in held pieces that may sway up otherwise, as Tension says
};

}  // namespace incision

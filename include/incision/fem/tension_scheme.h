#pragma once

namespace incision {

/// Whether the pull of what is under tension turns with the body in the same step.
enum class TensionScheme {
  EXPLICIT,  ///< only in the next one
  IMPLICIT,  ///< in all held pieces
  AUTO,      ///< in held pieces where it outweighs the mass at some copy
};

}  // namespace incision

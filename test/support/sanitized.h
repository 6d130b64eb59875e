#pragma once

namespace incision::test {

/// Whether this build looks for faults with the sanitizers, which take their own memory and much time.
#ifdef INCISION_SANITIZE
inline constexpr bool SANITIZED = true;
#else
inline constexpr bool SANITIZED = false;
#endif

}  // namespace incision::test

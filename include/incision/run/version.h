#pragma once

#include <string>

namespace incision {

/// What runs: git's description of the sources when this was built, or the package's version where git does not know
/// them, and for what processors the library is: `x86-64-v3` (AVX2 and FMA), `plain`, or `native` where it was compiled
/// for the machine that built it.
std::string version();

}  // namespace incision

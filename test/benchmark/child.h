#pragma once

#include <functional>

#include "benchmark/table.h"

namespace incision::bench {

/// Runs `work` in a forked process and returns its row, to which it adds what memory the run took. "peak_mb" is the
/// largest resident set [MB] of the whole process, libraries and mesh reading included; with "elements" in the row,
/// "kb_per_element" [kB] is its share of each. The caller must have started no threads. Throws std::runtime_error with
/// the child's reason.
Json inChild(const std::function<Json()>& work);

}  // namespace incision::bench

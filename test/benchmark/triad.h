#pragma once

namespace incision::bench {

/// What memory gives [B/s]: the best of several runs of STREAM's triad a = b + s c on `threads` threads, over arrays
/// that no cache holds, counted as STREAM does: 24 bytes an entry.
double triadBandwidth(int threads);

}  // namespace incision::bench

#pragma once

#include "benchmark/table.h"

namespace incision::bench {

/// What the program is asked to do.
struct Options {
  bool quick = false, large = false;
  std::string only, json;
};

/// Each measures scenes of one kind, prints its table and appends its rows. Returns false when what must hold does not;
/// a time never fails.

/// Ours, the plain reference and Bullet solve the same problem: the bar's tip after 200 steps.
bool tips(const Options& options, Json* rows);
/// The three bars, soft and stiff, with each method; on the soft ones the plain reference and Bullet too.
bool grids(const Options& options, Json* rows);
/// The bar on one to eight threads.
bool threads(const Options& options, Json* rows);
/// The bar from a thousand to three million elements; without `large` to three hundred thousand.
bool sizes(const Options& options, Json* rows);
/// The bar without warping.
bool linear(const Options& options, Json* rows);
/// What a cut through at most 5 % of the elements costs.
bool cuts(const Options& options, Json* rows);
/// A plate like that of the paper's figure 8.
bool plate(const Options& options, Json* rows);
/// The demo's organ in real time.
bool organ(const Options& options, Json* rows);
/// What contact adds to a step: eight pieces at rest on each other.
bool contact(const Options& options, Json* rows);
/// A million tetrahedra.
bool large(const Options& options, Json* rows);

}  // namespace incision::bench

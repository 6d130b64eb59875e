#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace incision {

/// What the batch program is asked to do.
struct BatchOptions {
  std::string scene;
  std::int64_t steps = 100;                                 ///< to take; 0: none; at most 10,000,000
  std::vector<std::string> overrides;                       ///< "solver.time_step=0.005", in the order given
  std::string record, positions, snapshot, volume, series;  ///< output files; empty: none
  std::string restore;                                      ///< file that a body was saved in; empty: none
  std::string save;                                         ///< file to save the body in at the end; empty: none
  std::int64_t every = 10;  ///< steps between snapshots of the series; as many as `steps` may be
  bool help = false;
};

/// Exit statuses of the batch program.
enum class BatchStatus { DONE = 0, FAILED = 1, BAD_INPUT = 2 };

/// Reads the program's arguments, without its name. Throws InputError for anything it does not know.
BatchOptions parseBatchArguments(const std::vector<std::string>& arguments);

/// Runs a scene without ROS and ends with one line of JSON on `out`; every error is one line on `err`. The run stops
/// early, outputs included, once stopBatch has been called. Returns FAILED when a step failed or an output could not be
/// written; what was reached is written all the same.
BatchStatus runBatch(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err);

/// Ends the run under way after its current step. May be called by a signal handler.
void stopBatch();

}  // namespace incision

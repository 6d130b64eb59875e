#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "incision/run/step_source.h"

namespace incision {

/// Most steps of a run: more would outgrow memory with the times of the steps alone.
inline constexpr std::int64_t MAX_STEPS = 10'000'000;

/// What a program that runs a scene is asked to do.
struct BatchOptions {
  std::string bag;                 ///< file of messages to run; of the batch program empty
  std::string node = "/incision";  ///< the node that the bag's messages are for
  std::string scene;
  std::int64_t steps = 100;            ///< to take; 0: none; at most MAX_STEPS, as of bags by default
  std::vector<std::string> overrides;  ///< "solver.time_step=0.005", in the order given
  std::string record, positions, snapshot, volume, series;  ///< output files; empty: none
  std::string summary;                                      ///< file that also gets the line of JSON; empty: none
  std::string restore;                                      ///< file that a body was saved in; empty: none
  std::string save;                                         ///< file to save the body in at the end; empty: none
  std::int64_t every = 10;  ///< steps between snapshots of the series; as many as `steps` may be
  bool keep_going = false;  ///< a step that fails is no failure of the program
  bool strict = false;      ///< a cut that is missed or rejected is
  bool help = false;
};

/// Exit statuses of the batch program; the last two by the signal that ended the run, as shells have it.
enum class BatchStatus {
  DONE = 0,
  FAILED = 1,
  BAD_INPUT = 2,
  STEP_FAILED = 3,
  CUT_MISSED = 4,
  INTERRUPTED = 130,
  TERMINATED = 143
};

/// A program that runs a scene: the batch program, or one that takes its steps from elsewhere.
struct BatchProgram {
  const char* name;
  const char* usage;  ///< first lines of its help, before the options that all have
  bool runs_bag;      ///< its first argument is a bag
  std::function<Scene(const BatchOptions&)> load;
  /// Opens what the steps come from. Null for the batch program.
  std::function<std::unique_ptr<StepSource>(const BatchOptions&, DeformableBody*)> open;
};

/// The batch program.
extern const BatchProgram BATCH;

/// Reads a program's arguments, without its name. Throws InputError for anything it does not know.
BatchOptions parseArguments(const BatchProgram& program, const std::vector<std::string>& arguments);
BatchOptions parseBatchArguments(const std::vector<std::string>& arguments);

std::string helpOf(const BatchProgram& program);

/// Runs a scene without ROS and ends with one line of JSON on `out`; every error is one line on `err`. The run stops
/// early, outputs included, after a signal, see stopAtSignals, and when a step fails. Returns, the first that holds:
/// that a signal has ended it, FAILED when an output could not be written or memory is short, STEP_FAILED, CUT_MISSED
/// where the options ask for it. What was reached is written all the same.
BatchStatus runProgram(const BatchProgram& program, const std::vector<std::string>& arguments, std::ostream& out,
                       std::ostream& err);
BatchStatus runBatch(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err);

/// What a program says of a cut that was not made, at this simulated time [s].
std::string remarkOn(const CutResult& cut, double time);

/// From now on SIGINT and SIGTERM end the run under way after its current step. A second one does not wait for that.
void stopAtSignals();

}  // namespace incision

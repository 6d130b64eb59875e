#include "incision/ros/diagnosis.h"

#include <algorithm>
#include <fstream>
#include <numeric>

#include "incision/base/yaml_reader.h"
#include "incision/pace/agenda.h"
#include "incision/pace/transform_queue.h"

namespace incision {
namespace {

using Level = diagnostic_msgs::DiagnosticStatus;

/// Least real-time factor of a body that keeps pace: three seconds lost in a minute are more than what the scheduling
/// of a busy machine takes.
constexpr double IN_REAL_TIME = 0.95;

/// A lag behind /clock [s] that is no longer that of messages on their way: ten times what the clock waits for these.
constexpr double LAGS = 0.5;

/// Share of steps that may be taken in halves: beyond it the body would be better off with a shorter time step.
constexpr double OFTEN = 0.5;

/// A residual so many times the tolerance is missed, not rounded: balancing the momentum adds less.
constexpr double MISSED = 10;

/// Share of a bounded queue beyond which it is about to lose something.
constexpr double FULL = 0.5;

/// Least share of the machine's memory that is to be left: with less, the system starts to give up its caches of files
/// and then to end programs.
constexpr double LEFT_OVER = 0.1;

constexpr double MEGABYTE = 1024.0 * 1024.0;

const std::array<const char*, NUM_REFUSALS> REFUSALS = {"not finite",    "out of range", "no transform",
                                                        "too many wait", "by the body",  "by a reset"};

/// Adds a reason to those there are, and raises the level to this one.
void complain(Status* status, const std::string& reason, int level = Level::WARN) {
  status->mergeSummary(static_cast<unsigned char>(level), reason);
}

std::string text(double value, const char* format = "%.3g") {
  char words[32];
  std::snprintf(words, sizeof words, format, value);
  return words;
}

void tellSteps(const StepTally& tally, Status* status) {
  status->add("steps since the last diagnosis", tally.steps);
  if (tally.steps == 0) return;
  status->add("step [ms], mean", text(tally.step_ms / tally.steps));
  status->add("step [ms], longest", text(tally.longest_ms));
  status->add("what takes the time", describe(sharesOf(tally)));
}

/// A line of /proc that begins with a word and a number of kB, in bytes; 0 where there is none.
double kilobytesIn(const char* file, const std::string& word) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);)
    if (line.compare(0, word.size(), word) == 0) return 1024 * std::strtod(line.c_str() + word.size(), nullptr);
  return 0;
}

}  // namespace

MemoryUse memoryUse() {
  return {kilobytesIn("/proc/self/status", "VmRSS:"), kilobytesIn("/proc/self/status", "VmHWM:"),
          kilobytesIn("/proc/meminfo", "MemAvailable:"), kilobytesIn("/proc/meminfo", "MemTotal:")};
}

void tellPace(const Condition& condition, const StepTally& tally, double period, Status* status) {
  const double factor = condition.real_time_factor;
  if (condition.paused) {
    status->summary(Level::OK, "paused at step " + std::to_string(condition.steps));
  } else {
    status->summary(Level::OK, condition.by_clock ? "keeps up with /clock" : "in real time");
    if (tally.steps == 0)
      complain(status,
               "no step for " + text(period) + " s: " +
                   (condition.by_clock ? "/clock stands still, or does not come" : "one takes longer than that"));
    if (!condition.by_clock && factor > 0 && factor < IN_REAL_TIME)
      complain(status, "slower than real time, at " + text(factor) + " of it");
    if (condition.clock_lag > LAGS) complain(status, text(condition.clock_lag) + " s behind /clock");
  }
  status->add("real-time factor", text(factor));
  if (condition.by_clock) status->add("behind /clock [s]", text(condition.clock_lag));
  tellSteps(tally, status);
}

void tellNumerics(const Condition& condition, const StepTally& tally, Status* status) {
  status->summary(Level::OK, "sound");
  if (!condition.error.empty()) complain(status, "paused, because a step failed: " + condition.error, Level::ERROR);
  if (tally.unsettled > 0) complain(status, std::to_string(tally.unsettled) + " steps did not settle");
  if (tally.divided > OFTEN * tally.steps)
    complain(status,
             std::to_string(tally.divided) + " of " + std::to_string(tally.steps) + " steps were taken in halves");
  if (tally.residual > MISSED * condition.tolerance)
    complain(status, "a residual of " + text(tally.residual) + " misses the tolerance");
  status->add("unsettled steps", tally.unsettled);
  status->add("steps taken in halves", tally.divided);
  status->add("residual, largest", text(tally.residual));
  status->add("tolerance", text(condition.tolerance));
  status->add("iterations, most", tally.iterations);
}

void tellInput(const InputCounts& counts, const InputCounts& before, const Waiting& waiting, const Condition& condition,
               const std::vector<std::string>& tools, Status* status) {
  status->summary(Level::OK, "all was followed");
  const auto sum = [](const InputCounts& of) {
    return std::accumulate(of.refused.begin(), of.refused.end(), std::uint64_t{0});
  };
  const auto complainOf = [&](std::uint64_t count, const char* what) {
    if (count > 0) complain(status, std::to_string(count) + what);
  };
  complainOf(sum(counts) - sum(before), " messages refused");
  complainOf(counts.late - before.late, " cuts and messages to tools came late");
  complainOf(counts.thinned - before.thinned, " poses left out");
  complainOf(counts.ignored_transforms - before.ignored_transforms, " transforms ignored");
  if (static_cast<double>(waiting.for_transform) > FULL * MAX_WAITING_FOR_TRANSFORM ||
      static_cast<double>(waiting.for_step) > FULL * MAX_WAITING_CUTS)
    complain(status, "so many cuts and messages to tools wait that some may be refused");
  std::vector<std::string> stale;
  for (std::size_t i = 0; i < condition.stale.size(); ++i)
    if (condition.stale[i] != 0) stale.push_back(tools[i]);
  if (!stale.empty()) complain(status, "no poses come for " + joined(stale));
  for (std::size_t i = 0; i < REFUSALS.size(); ++i)
    status->add(std::string("refused, ") + REFUSALS[i], counts.refused[i]);
  status->add("late", counts.late);
  status->add("poses left out", counts.thinned);
  status->add("transforms ignored", counts.ignored_transforms);
  status->add("waiting for a transform", waiting.for_transform);
  status->add("waiting for their step", waiting.for_step);
  status->add("stale tools", joined(stale));
}

void tellMemory(const MemoryUse& use, Status* status) {
  status->summary(Level::OK, text(use.resident / MEGABYTE, "%.0f") + " MB");
  if (use.available < LEFT_OVER * use.total)
    complain(status, "the machine has " + text(use.available / MEGABYTE, "%.0f") + " MB left of " +
                         text(use.total / MEGABYTE, "%.0f"));
  status->add("resident [MB]", text(use.resident / MEGABYTE, "%.1f"));
  status->add("peak [MB]", text(use.peak / MEGABYTE, "%.1f"));
  status->add("left on the machine [MB]", text(use.available / MEGABYTE, "%.0f"));
}

}  // namespace incision

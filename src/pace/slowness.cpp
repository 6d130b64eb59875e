#include "incision/pace/slowness.h"

#include <chrono>
#include <iomanip>
#include <sstream>

#include "incision/run/first_steps.h"

namespace incision {

void Slowness::restart(SteadyTime now) {
  start_ = now;
  tally_ = StepTally();
}

std::optional<std::string> Slowness::look(SteadyTime now, int threads, int machine_threads) {
  const double passed = std::chrono::duration<double>(now - start_).count();
  if (passed < SLOW_FOR) return std::nullopt;
  const bool is_slow = tally_.steps > 0 && tally_.steps * time_step_ < SLOW * passed;
  std::optional<std::string> said;
  if (is_slow && !told_) said = inWords(passed, threads, machine_threads);
  told_ = is_slow;
  restart(now);
  return said;
}

std::string Slowness::inWords(double passed, int threads, int machine_threads) const {
  const double simulated = tally_.steps * time_step_, step = 1e-3 * tally_.step_ms / tally_.steps;
  std::ostringstream words;
  words << std::setprecision(3) << "slower than real time, at " << simulated / passed << " of it: a step of "
        << 1e3 * time_step_ << " ms takes " << 1e3 * step << " ms";
  const std::vector<PhaseShare> shares = sharesOf(tally_);
  if (!shares.empty()) words << " (" << describe(shares) << ")";
  const double longest = 1e-3 * tally_.longest_ms;
  if (longest <= time_step_) {
    words << ", and between steps something else takes the processor";
    return words.str();
  }
  if (step <= time_step_) {
    words << " on average, the longest " << 1e3 * longest << " ms, and what one loses no other makes up for; "
          << "solver.iterations would bound what a solve takes";
    return words.str();
  }
  words << "; a coarser mesh or a longer solver.time_step would help";
  if (threads < machine_threads)
    words << ", perhaps more solver.threads (" << threads << ", the machine has " << machine_threads << ")";
  if (self_contact_ && !shares.empty() && shares[0].phase == "contact")
    words << ", and contact.self: false where pieces need not touch each other";
  return words.str();
}

}  // namespace incision

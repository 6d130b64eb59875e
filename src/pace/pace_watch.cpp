#include "incision/pace/pace_watch.h"

#include <chrono>
#include <sstream>
#include <utility>

namespace incision {
namespace {

constexpr const char* SLOWER = "play a bag slower, or run it with incision_bag";

double secondsBetween(SteadyTime from, SteadyTime to) { return std::chrono::duration<double>(to - from).count(); }

/// What a command waits for that is stamped later than the clock.
std::string waitsForStamp(Nanoseconds stamp, Nanoseconds clock) {
  std::ostringstream text;
  text.setf(std::ios::fixed);
  text.precision(3);
  text << "its stamp, " << toSeconds(stamp);
  if (clock == 0) {
    text << "; no /clock has come yet";
    return text.str();
  }
  const double ahead = toSeconds(stamp - clock);
  text << ", which is " << ahead << " s ahead of the clock";
  if (ahead > OTHER_CLOCK) text << ": is it wall time, while the clock is simulated?";
  return text.str();
}

}  // namespace

void PaceWatch::look(SteadyTime now) {
  const double passed = secondsBetween(last_look_, now);
  if (passed < WARNING_PERIOD) return;
  last_look_ = now;
  lookAtSkippedTime(passed);
  lookAtThinnedPoses();
  lookAtWaitingCommands(now);
}

/// That of wall time is Slowness' to tell.
void PaceWatch::lookAtSkippedTime(double passed) {
  if (!pacer_.goesByStamps()) return;
  const double skipped = pacer_.skipped(), more = skipped - std::exchange(skipped_, skipped);
  if (more <= SKIPPED_SHARE * passed) return;
  std::ostringstream text;
  text << "no steps are taken for " << more << " s of /clock, because they did not keep up with it or it jumped ("
       << skipped << " s so far): " << SLOWER;
  answers_.warn("skipped time", text.str());
}

void PaceWatch::lookAtThinnedPoses() {
  for (std::size_t tool = 0; tool < thinned_.size(); ++tool) {
    const std::uint64_t thinned = commands_.thinned(static_cast<int>(tool));
    if (std::exchange(thinned_[tool], thinned) == thinned) continue;
    const std::string name = "tool '" + commands_.tools()[tool] + "'";
    std::ostringstream text;
    text << name << ": " << thinned << " of its poses and jaw's angles are left out so far, since more than "
         << MAX_WAITING_POSES << " waited for a step";
    if (pacer_.goesByStamps()) text << ": " << SLOWER;
    answers_.warn("thinned poses of " + name, text.str());
  }
}

void PaceWatch::lookAtWaitingCommands(SteadyTime now) {
  const Nanoseconds clock = pacer_.clock();
  const auto command = commands_.longestWaiting(clock);
  if (!command) return;
  const double waited = secondsBetween(command->received, now);
  if (waited < LONG_WAIT) return;
  const std::size_t others = commands_.waitingForTransform() + commands_.waitingForStep() - 1;
  std::ostringstream text;
  text.precision(3);
  text << command->what << " has waited " << waited << " s for ";
  if (command->frame.empty())
    text << waitsForStamp(command->stamp, clock);
  else
    text << "the transform of its frame \"" << command->frame << "\"";
  if (others > 0) text << "; with it " << others << " more wait";
  answers_.warn("commands that wait", text.str());
}

}  // namespace incision

#include "ensemble.h"

#include <algorithm>
#include <atomic>
#include <future>

namespace incision::report {

void Ensemble::add(const Ensemble& other) {
  runs += other.runs;
  steps += other.steps;
  failed += other.failed;
  unsettled += other.unsettled;
  rises += other.rises;
  overlaps += other.overlaps;
  for (Worst Ensemble::*const worst :
       {&Ensemble::rise, &Ensemble::above, &Ensemble::overlap, &Ensemble::momentum, &Ensemble::spin})
    (this->*worst).add((other.*worst).figure());
  solves.insert(solves.end(), other.solves.begin(), other.solves.end());
}

int Ensemble::solvesOf(double share) const {
  if (solves.empty()) return 0;
  std::vector<int> sorted = solves;
  const auto at = sorted.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), at, sorted.end());
  return *at;
}

void EnergyWatch::step(double energy, bool settled, int solves) {
  ++seen_.steps;
  seen_.unsettled += !settled;
  if (solves > 0) seen_.solves.push_back(solves);
  // No number is above any other, and is to count as the worst.
  const auto over = [&](double before) { return energy <= before ? 0 : (energy - before) / first_; };
  seen_.above.add(over(first_));
  if (settled) {
    seen_.rise.add(over(last_));
    seen_.rises += !(over(last_) <= RISE_BOUND);
  }
  last_ = energy;
}

Ensemble ofSeeds(int count, const std::function<Ensemble(unsigned seed)>& run) {
  std::vector<Ensemble> found(count);
  std::atomic<int> next = 0;
  const auto work = [&] {
    for (int seed = next++; seed < count; seed = next++) found[seed] = run(static_cast<unsigned>(seed));
  };
  std::future<void> other = std::async(std::launch::async, work);
  work();
  other.get();
  Ensemble all;
  for (const Ensemble& one : found) all.add(one);
  return all;
}

nlohmann::json toJson(const std::string& name, const Ensemble& ensemble) {
  return {{"name", name},
          {"runs", ensemble.runs},
          {"steps", ensemble.steps},
          {"failed", ensemble.failed},
          {"unsettled", ensemble.unsettled},
          {"rises", ensemble.rises},
          {"rise", ensemble.rise.figure()},
          {"above", ensemble.above.figure()},
          {"overlap", ensemble.overlaps > 0 ? nlohmann::json(ensemble.overlap.figure()) : nullptr},
          {"momentum", ensemble.momentum.figure()},
          {"spin", ensemble.spin.figure()},
          {"solves", {ensemble.solvesOf(0.5), ensemble.solvesOf(0.99), ensemble.solvesOf(1)}}};
}

}  // namespace incision::report

#include "benchmark/rounds.h"

#include "benchmark/child.h"

namespace incision::bench {

std::vector<Json> bestOfRounds(const std::vector<Run>& runs, int rounds, const std::string& pointer) {
  const Json::json_pointer value(pointer);
  std::vector<Json> best(runs.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (round > 0 && runs[i].slow) continue;
      Json row = {{"name", runs[i].name}};
      row.update(inChild(runs[i].work));
      if (round == 0 || row.at(value) < best[i].at(value)) best[i] = std::move(row);
    }
  return best;
}

}  // namespace incision::bench

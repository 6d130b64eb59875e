// The cantilever by one solver or the other: the same answer, and which is faster from what size on.
#include "report/static/study.h"

namespace incision::report {

nlohmann::json compareSolvers(bool quick) {
  const Problem problem = cantilever();
  nlohmann::json sizes;
  for (const int n : quick ? std::vector<int>{4, 6, 8} : std::vector<int>{3, 4, 6, 8, 12, 16}) {
    nlohmann::json size;
    for (const auto& [name, method] :
         {std::pair("direct", Method::DIRECT), std::pair("iterative", Method::ITERATIVE)}) {
      const Solution solution = solve(problem.grid(n, true), problem.cases[0], 0, quick ? 1 : 3, method);
      size["freedoms"] = solution.freedoms;
      size[std::string(name) + "_ms"] = solution.ms;
      size[std::string(name) + "_energy"] = solution.energy;
    }
    sizes.push_back(size);
  }
  return sizes;
}

}  // namespace incision::report

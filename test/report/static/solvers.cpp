// The cantilever by one solver or the other: the same answer, and which is faster from what size on.
#include <cmath>

#include "report/static/study.h"

namespace incision::report {

void compareSolvers(Findings* findings) {
  const Problem problem = cantilever();
  const Case& loaded = problem.cases[0];
  const bool quick = findings->quick();
  double apart = 0;
  for (const int n : quick ? std::vector<int>{4, 6, 8} : std::vector<int>{3, 4, 6, 8, 12, 16}) {
    const TetMesh mesh = problem.grid(n, true);
    const Solution direct = solve(mesh, loaded, 0, quick ? 1 : 3, Method::DIRECT);
    const Solution iterative = solve(mesh, loaded, 0, quick ? 1 : 3, Method::ITERATIVE);
    apart = std::max(apart, std::abs(iterative.energy / direct.energy - 1));
    findings->data()["solvers"].push_back({{"freedoms", direct.freedoms},
                                           {"direct_ms", direct.ms},
                                           {"iterative_ms", iterative.ms},
                                           {"iterations", iterative.iterations}});
  }
  findings->claimBelow("cantilever: strain energy by the iterative against the direct solver, relative", apart, 2e-4);
}

}  // namespace incision::report

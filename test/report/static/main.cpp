// Static problems with a known answer: error against wall time on meshes of many sizes, made in several ways.
#include <cstdio>

#include "report/static/study.h"

int main(int argc, char** argv) {
  using namespace incision::report;
  Findings findings(argc, argv);
  try {
    Gmsh gmsh;
    studyBending(&gmsh, &findings);
    compareSolvers(&findings);
    for (const Problem& problem : {cantilever(), splitCantilever(), doubleCantileverBeam(), edgeCrack(), pennyCrack()})
      study(problem, &gmsh, &findings);
    claimConvergence(&findings);
    return findings.write();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

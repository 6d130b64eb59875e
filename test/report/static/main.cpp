// Static problems with a known answer: error against wall time on meshes of many sizes, made in several ways.
#include "report/static/study.h"

namespace incision::report {
namespace {

void measure(bool quick, nlohmann::json* data) {
  Gmsh gmsh;
  (*data)["bending"] = studyBending(&gmsh, quick);
  (*data)["solvers"] = compareSolvers(quick);
  for (const Problem& problem : {cantilever(), splitCantilever(), doubleCantileverBeam(), edgeCrack(), pennyCrack()})
    (*data)["problems"].push_back(study(problem, &gmsh, quick));
}

}  // namespace
}  // namespace incision::report

int main(int argc, char** argv) { return incision::report::writeSection(argc, argv, incision::report::measure); }

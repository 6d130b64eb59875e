// Bodies of several materials with known answers: error against wall time by contrast, on meshes of many sizes.
#include "report/regions/study.h"
#include "report/section.h"

namespace incision::report {
namespace {

void measure(bool quick, nlohmann::json* data) {
  (*data)["exact"] = studyExact(quick);
  (*data)["ball"] = studyBall(quick);
  (*data)["layers"] = studyLayers(quick);
}

}  // namespace
}  // namespace incision::report

int main(int argc, char** argv) { return incision::report::writeSection(argc, argv, incision::report::measure); }

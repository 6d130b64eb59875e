// Published problems of other codes' test suites; measure.py adds what GetFEM makes of the same cracks.
#include "report/benchmark/cracks.h"
#include "report/benchmark/exact.h"
#include "report/section.h"

namespace incision::report {
namespace {

void measure(bool quick, nlohmann::json* data) {
  (*data)["exact"] = rigidZones();
  data->update(roundCracks(quick));
}

}  // namespace
}  // namespace incision::report

int main(int argc, char** argv) { return incision::report::writeSection(argc, argv, incision::report::measure); }

// Problems in which bodies touch, with answers of their own: error against wall time.
#include "report/contact/problems.h"
#include "report/section.h"

namespace incision::report {
namespace {

void measure(bool quick, nlohmann::json* data) {
  for (const auto& problem : {hertz, heldLayer, slidingBlock, stack, slitBar})
    (*data)["problems"].push_back(toJson(problem(quick)));
}

}  // namespace
}  // namespace incision::report

int main(int argc, char** argv) { return incision::report::writeSection(argc, argv, incision::report::measure); }

#include <cstdio>

#include "report/cost/cost_run.h"

int main(int argc, char** argv) {
  try {
    std::printf("%s\n", incision::report::costOf(incision::report::costOptions(argc, argv)).dump().c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

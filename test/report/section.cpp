#include "report/section.h"

#include <cstdio>
#include <fstream>
#include <string>

namespace incision::report {

int writeSection(int argc, char** argv, const Measure& measure) try {
  const bool quick = argc > 1 && std::string(argv[1]) == "--quick";
  if (argc != (quick ? 3 : 2)) throw std::runtime_error("usage: " + std::string(argv[0]) + " [--quick] FILE.json");
  nlohmann::json data;
  measure(quick, &data);
  std::ofstream file(argv[argc - 1]);
  file << data.dump() << '\n';
  if (!file.flush()) throw std::runtime_error(std::string(argv[argc - 1]) + ": cannot be written");
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}

}  // namespace incision::report

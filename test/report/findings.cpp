#include "report/findings.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace incision::report {
namespace {

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", value);
  return buffer;
}

}  // namespace

Findings::Findings(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--quick") {
      quick_ = true;
    } else if (argument == "--output" && i + 1 < argc) {
      path_ = argv[++i];
    } else {
      path_.clear();
      break;
    }
  }
  if (!path_.empty()) return;
  std::fprintf(stderr, "usage: %s [--quick] --output FILE.json\n", argv[0]);
  std::exit(2);
}

void Findings::claimBelow(const std::string& what, double value, double bound) {
  add(what, text(value), "< " + text(bound), value < bound);
}

void Findings::claimAbove(const std::string& what, double value, double bound) {
  add(what, text(value), "> " + text(bound), value > bound);
}

void Findings::claim(const std::string& what, bool holds) { add(what, holds ? "yes" : "no", "yes", holds); }

void Findings::add(const std::string& what, const std::string& measured, const std::string& wanted, bool holds) {
  claims_.push_back({{"claim", what}, {"measured", measured}, {"wanted", wanted}, {"holds", holds}});
  std::printf("%s: %s (%s)%s\n", what.c_str(), measured.c_str(), wanted.c_str(), holds ? "" : "  FAILS");
  std::fflush(stdout);
}

int Findings::write() const {
  nlohmann::json all = data_;
  all["quick"] = quick_;
  all["claims"] = claims_;
  std::ofstream file(path_);
  file << all.dump(1) << '\n';
  file.close();
  if (!file) {
    std::fprintf(stderr, "%s: cannot be written\n", path_.c_str());
    return 1;
  }
  for (const nlohmann::json& claim : claims_)
    if (!claim["holds"]) return 1;
  return 0;
}

}  // namespace incision::report

#include <array>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "benchmark/groups.h"

namespace {

using namespace incision::bench;

constexpr const char* HELP =
    R"(usage: step_benchmark [options]

Times whole steps of several scenes and prints tables; times are in milliseconds.

  --quick        fewer steps, and at 98,304 elements only our own iterative solver
  --large        also a million elements and more
  --only SCENE   only these: tips, grids, sizes, threads, linear, cuts, contact, plate, organ or large
  --json FILE    also writes all rows, for plot_steps.py
  --help         this text

Exit status: 0 done, 1 a check or a run failed, 2 bad options.
)";

struct Group {
  const char* name;
  bool (*run)(const Options&, Json*);
};

constexpr std::array<Group, 10> GROUPS = {{{"tips", tips},
                                           {"grids", grids},
                                           {"sizes", sizes},
                                           {"threads", threads},
                                           {"linear", linear},
                                           {"cuts", cuts},
                                           {"contact", contact},
                                           {"plate", plate},
                                           {"organ", organ},
                                           {"large", large}}};

bool wanted(const Options& options, const std::string& group) {
  if (!options.only.empty()) return options.only == group;
  return group != "large" || options.large;
}

/// Throws std::invalid_argument.
Options parse(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    const auto value = [&] {
      if (i + 1 == argc) throw std::invalid_argument(option + " needs a value");
      return std::string(argv[++i]);
    };
    if (option == "--quick") {
      options.quick = true;
    } else if (option == "--large") {
      options.large = true;
    } else if (option == "--only") {
      options.only = value();
    } else if (option == "--json") {
      options.json = value();
    } else {
      throw std::invalid_argument(option + " is no option");
    }
  }
  const auto named = [&](const Group& group) { return options.only == group.name; };
  if (!options.only.empty() && std::none_of(GROUPS.begin(), GROUPS.end(), named))
    throw std::invalid_argument(options.only + " is no scene");
  return options;
}

bool run(const Options& options) {
  Json rows = Json::array();
  bool good = true;
  for (const Group& group : GROUPS) {
    if (!wanted(options, group.name)) continue;
    good = group.run(options, &rows) && good;
    // After each group, so that a run that is interrupted leaves what it had.
    if (!options.json.empty() && !(std::ofstream(options.json) << rows.dump(1) << '\n'))
      throw std::runtime_error(options.json + " could not be written");
  }
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::string(argv[1]) == "--help") {
    std::cout << HELP;
    return 0;
  }
  try {
    return run(parse(argc, argv)) ? 0 : 1;
  } catch (const std::invalid_argument& error) {
    std::cerr << "step_benchmark: " << error.what() << "\n" << HELP;
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "step_benchmark: " << error.what() << std::endl;
    return 1;
  }
}

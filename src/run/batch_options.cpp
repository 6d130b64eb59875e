#include <charconv>
#include <functional>
#include <map>

#include "incision/base/input_error.h"
#include "incision/base/printable.h"
#include "incision/run/batch.h"

namespace incision {

namespace {

constexpr const char* OPTIONS =
    R"(  --set KEY=VALUE    replaces or adds one value of the scene, such as
                     solver.time_step=0.005 or cuts.0.normal=[1,0,0]; may be given often
  --threads N        short for --set solver.threads=N
  --record RUN.csv   one row a step: counts, momentum, energies, solver
  --positions END.txt
                     `x y z` of every mesh node at the end, in mesh order
  --snapshot END.vtu the surface and its stress at the end, for ParaView
  --volume END.vtu   the parts, likewise, with their displacements and regions
  --series RUN.pvd   both at the start, after every so many steps, and at the end
  --every N          how many steps for --series (default 10)
  --summary END.json the line of JSON also goes there, whole or not at all
  --save END.state   all that outlasts the last step, to go on from
  --restore START.state
                     goes on where --save has left off with the same scene;
                     --steps counts from there
  --keep-going       exit status 0 where a step has failed too
  --strict           exit status 4 where a cut was missed or rejected
  --help             this text

Ctrl-C ends the run after the current step, outputs included.
Exit status: 0 done, 1 an output could not be written or memory is short, 2 bad
input, 3 a step failed, 4 see --strict, 130 Ctrl-C, 143 ended by SIGTERM.
)";

std::int64_t parseSteps(const char* option, std::int64_t least, const std::string& text) {
  std::int64_t steps = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), steps);
  if (error != std::errc() || end != text.data() + text.size() || steps < least || steps > MAX_STEPS) {
    throw InputError(option + (": '" + printable(text)) + "' (allowed: " + std::to_string(least) + " to " +
                     std::to_string(MAX_STEPS) + ")");
  }
  return steps;
}

using Taker = std::function<void(const std::string& value)>;

// What each option does with its value.
std::map<std::string, Taker> optionTakers(BatchOptions& options) {
  return {{"--steps", [&](const std::string& value) { options.steps = parseSteps("--steps", 0, value); }},
          {"--set", [&](const std::string& value) { options.overrides.push_back(value); }},
          {"--threads", [&](const std::string& value) { options.overrides.push_back("solver.threads=" + value); }},
          {"--record", [&](const std::string& value) { options.record = value; }},
          {"--positions", [&](const std::string& value) { options.positions = value; }},
          {"--snapshot", [&](const std::string& value) { options.snapshot = value; }},
          {"--volume", [&](const std::string& value) { options.volume = value; }},
          {"--summary", [&](const std::string& value) { options.summary = value; }},
          {"--restore", [&](const std::string& value) { options.restore = value; }},
          {"--save", [&](const std::string& value) { options.save = value; }},
          {"--series", [&](const std::string& value) { options.series = value; }},
          {"--every", [&](const std::string& value) { options.every = parseSteps("--every", 1, value); }}};
}

// Options without a value.
std::map<std::string, bool*> switches(BatchOptions& options) {
  return {{"--help", &options.help},
          {"-h", &options.help},
          {"--keep-going", &options.keep_going},
          {"--strict", &options.strict}};
}

// Those that come first and have no option before them, by what an error calls them.
struct Positional {
  const char* name;
  std::string* value;
};

}  // namespace

const BatchProgram BATCH = {"incision_batch",
                            R"(usage: incision_batch SCENE.yaml [options]

Runs a scene and ends with one line of JSON on standard output.

  --steps N          steps to take (default 100; 0 only loads the scene)
)",
                            false,
                            [](const BatchOptions& options) { return loadScene(options.scene, options.overrides); },
                            {}};

std::string helpOf(const BatchProgram& program) { return std::string(program.usage) + OPTIONS; }

BatchOptions parseArguments(const BatchProgram& program, const std::vector<std::string>& arguments) {
  BatchOptions options;
  std::map<std::string, Taker> takers = optionTakers(options);
  const std::map<std::string, bool*> switched = switches(options);
  std::vector<Positional> places = {{"scene file", &options.scene}};
  if (program.runs_bag) {
    options.steps = MAX_STEPS;
    takers["--node"] = [&](const std::string& value) { options.node = value; };
    places.insert(places.begin(), {"bag", &options.bag});
  }
  const std::string more = " (" + std::string(program.name) + " --help ";
  auto place = places.begin();
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    const auto taker = takers.find(argument);
    if (const auto found = switched.find(argument); found != switched.end()) {
      *found->second = true;
      if (options.help) return options;
    } else if (taker != takers.end()) {
      ++i;
      if (i == arguments.size() || arguments[i].empty()) throw InputError(argument + ": its value is missing");
      taker->second(arguments[i]);
    } else if (argument.size() > 1 && argument[0] == '-') {
      throw InputError("unknown option " + printable(argument) + more + "lists those allowed)");
    } else if (place != places.end() && !argument.empty()) {
      *place++->value = argument;
    } else {
      throw InputError("'" + printable(argument) + "' (allowed: one " +
                       (program.runs_bag ? "bag and one scene file)" : "scene file)"));
    }
  }
  if (place != places.end()) throw InputError(std::string("no ") + place->name + " given" + more + "says more)");
  return options;
}

BatchOptions parseBatchArguments(const std::vector<std::string>& arguments) { return parseArguments(BATCH, arguments); }

}  // namespace incision

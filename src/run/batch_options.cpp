#include <charconv>
#include <functional>
#include <map>

#include "incision/base/input_error.h"
#include "incision/base/printable.h"
#include "incision/run/batch.h"

namespace incision {

namespace {

// More would outgrow memory with the times of the steps alone.
constexpr std::int64_t MAX_STEPS = 10'000'000;

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
          {"--restore", [&](const std::string& value) { options.restore = value; }},
          {"--save", [&](const std::string& value) { options.save = value; }},
          {"--series", [&](const std::string& value) { options.series = value; }},
          {"--every", [&](const std::string& value) { options.every = parseSteps("--every", 1, value); }}};
}

}  // namespace

BatchOptions parseBatchArguments(const std::vector<std::string>& arguments) {
  BatchOptions options;
  const std::map<std::string, Taker> takers = optionTakers(options);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    const auto taker = takers.find(argument);
    if (argument == "--help" || argument == "-h") {
      options.help = true;
      return options;
    }
    if (taker != takers.end()) {
      ++i;
      if (i == arguments.size() || arguments[i].empty()) throw InputError(argument + ": its value is missing");
      taker->second(arguments[i]);
    } else if (argument.size() > 1 && argument[0] == '-') {
      throw InputError("unknown option " + printable(argument) + " (incision_batch --help lists those allowed)");
    } else if (options.scene.empty() && !argument.empty()) {
      options.scene = argument;
    } else {
      throw InputError("'" + printable(argument) + "' (allowed: one scene file)");
    }
  }
  if (options.scene.empty()) throw InputError("no scene file given (incision_batch --help says more)");
  return options;
}

}  // namespace incision

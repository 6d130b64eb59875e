#include "incision/scene/live_settings.h"

#include "incision/base/input_error.h"
#include "incision/base/yaml_reader.h"
#include "incision/scene/scene.h"

namespace incision {

std::string whyInvalid(const LiveSettings& settings) {
  YAML::Node said;
  said["tolerance"] = settings.tolerance;
  said["threads"] = settings.threads;
  said["gravity_x"] = settings.gravity.x();
  said["gravity_y"] = settings.gravity.y();
  said["gravity_z"] = settings.gravity.z();
  said["cutting_force_factor"] = settings.cutting_force_factor;
  try {
    parseLiveSettings(YamlValue(said, "live settings").map(liveKeys()), settings);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

/// By comparison alone: where memory runs out, a text that is taken for a number would not say so.
void check(const LiveSettings& memory, const MemoryLimits&) {
  const auto within = [](const Range& range, double value) { return value >= range.min && value <= range.max; };
  require(within(SolverSettings::TOLERANCE, memory.tolerance) && memory.gravity.allFinite() &&
              within(NOT_NEGATIVE, memory.cutting_force_factor),
          "what it was set to while it ran is out of range");
}

LiveSettings liveSettingsOf(const Scene& scene) {
  return {scene.solver.tolerance, scene.solver.threads, scene.gravity};
}

const std::vector<std::string>& liveKeys() {
  static const std::vector<std::string> keys = {"tolerance", "threads",   "gravity_x",
                                                "gravity_y", "gravity_z", "cutting_force_factor"};
  return keys;
}

LiveSettings parseLiveSettings(const YamlMap& map, const LiveSettings& now) {
  LiveSettings settings;
  settings.tolerance = map.number("tolerance", now.tolerance, SolverSettings::TOLERANCE);
  const auto threads = map.find("threads");
  settings.threads = threads ? threads->integer(1, SolverSettings::MAX_THREADS) : now.threads;
  settings.gravity = {map.number("gravity_x", now.gravity.x()), map.number("gravity_y", now.gravity.y()),
                      map.number("gravity_z", now.gravity.z())};
  settings.cutting_force_factor = map.number("cutting_force_factor", now.cutting_force_factor, NOT_NEGATIVE);
  return settings;
}

}  // namespace incision

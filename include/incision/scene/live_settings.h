#pragma once

#include <string>
#include <vector>

#include "incision/base/memory_limits.h"
#include "incision/base/vec.h"

namespace incision {

class YamlMap;
struct Scene;

/// What of a scene may be set anew while its body runs. Nothing is kept that was reckoned with them: matrices do not
/// depend on them, and forces are found in each step.
struct LiveSettings {
  double tolerance = 0;         ///< as SolverSettings::tolerance, with its range
  int threads = 1;              ///< as SolverSettings::threads; no result depends on it
  Vec3 gravity = Vec3::Zero();  ///< [m/s²]
  /// That of every tool, in every region, is so many times what the scene says; ≥ 0.
  double cutting_force_factor = 1;

  bool operator==(const LiveSettings& other) const {
    return tolerance == other.tolerance && threads == other.threads && gravity == other.gravity &&
           cutting_force_factor == other.cutting_force_factor;
  }
  bool operator!=(const LiveSettings& other) const { return !(*this == other); }
};

/// All that a step depends on.
template <class Archive>
void serialize(Archive& archive, LiveSettings& settings) {
  auto& [tolerance, threads, gravity, cutting_force_factor] = settings;
  archive(tolerance, gravity, cutting_force_factor);
}

/// What is out of range, with what is allowed; empty where nothing is.
std::string whyInvalid(const LiveSettings& settings);
void check(const LiveSettings& memory, const MemoryLimits& limits);

/// What a scene says of them.
LiveSettings liveSettingsOf(const Scene& scene);

/// The keys by which they are set: `tolerance`, `threads`, `gravity_x`, `gravity_y`, `gravity_z`,
/// `cutting_force_factor`.
const std::vector<std::string>& liveKeys();

/// Those of a map that may have these keys, and others. What it does not have stays as it is `now`. Throws InputError.
LiveSettings parseLiveSettings(const YamlMap& map, const LiveSettings& now);

}  // namespace incision

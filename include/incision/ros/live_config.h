#pragma once

#include <dynamic_reconfigure/Config.h>

#include <string>

#include "incision/base/yaml_reader.h"
#include "incision/ros/body_markers.h"
#include "incision/scene/live_settings.h"

namespace incision {

/// How the body is drawn.
struct MarkerSettings {
  double rate = 15;                       ///< `marker_rate` [Hz], 0 … 1000; 0: not at all
  MarkerField field = MarkerField::NONE;  ///< `marker_field`: what the colours of ~markers tell
};

/// Those of the entries `marker_rate` and `marker_field`; what is not given stays as it is `now`. Throws InputError.
MarkerSettings parseMarkers(const YamlMap& map, const MarkerSettings& now);

/// What may be set anew while a node runs.
struct NodeLiveSettings {
  LiveSettings body;
  MarkerSettings markers;
};

/// What a message of dynamic_reconfigure sets anew; what it does not name stays as it is `now`. Values are checked as
/// those of the scene and of the node's parameters are. Throws InputError that begins with `source`, where a value is
/// out of its range or a name is none of `Body.cfg`.
NodeLiveSettings changed(const NodeLiveSettings& now, const dynamic_reconfigure::Config& message,
                         const std::string& source);

/// All of them, so that changed() of any other gives these.
dynamic_reconfigure::Config toConfig(const NodeLiveSettings& settings);

}  // namespace incision

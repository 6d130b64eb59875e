#include "incision/ros/live_config.h"

#include <yaml-cpp/yaml.h>

#include <map>

namespace incision {
namespace {

const std::map<std::string, MarkerField>& fields() {
  static const std::map<std::string, MarkerField> all = {
      {"none", MarkerField::NONE}, {"region", MarkerField::REGION}, {"stress", MarkerField::STRESS}};
  return all;
}

std::string wordOf(MarkerField field) {
  for (const auto& [word, meaning] : fields())
    if (meaning == field) return word;
  return "";
}

template <class Parameters>
void addTo(YAML::Node* map, const Parameters& parameters) {
  for (const auto& parameter : parameters) (*map)[parameter.name] = parameter.value;
}

YAML::Node yamlOf(const dynamic_reconfigure::Config& message) {
  YAML::Node map(YAML::NodeType::Map);
  for (const auto& parameter : message.bools) map[parameter.name] = parameter.value != 0;
  addTo(&map, message.ints);
  addTo(&map, message.strs);
  addTo(&map, message.doubles);
  return map;
}

void add(dynamic_reconfigure::Config* config, const std::string& name, double value) {
  config->doubles.emplace_back();
  config->doubles.back().name = name;
  config->doubles.back().value = value;
}

}  // namespace

MarkerSettings parseMarkers(const YamlMap& map, const MarkerSettings& now) {
  MarkerSettings settings;
  settings.rate = map.number("marker_rate", now.rate, {0, 1000});
  const auto field = map.find("marker_field");
  settings.field = field ? field->choice<MarkerField>(fields()) : now.field;
  return settings;
}

NodeLiveSettings changed(const NodeLiveSettings& now, const dynamic_reconfigure::Config& message,
                         const std::string& source) {
  std::vector<std::string> keys = liveKeys();
  keys.insert(keys.end(), {"marker_rate", "marker_field"});
  const YamlMap map = YamlValue(yamlOf(message), source).map(keys);
  return {parseLiveSettings(map, now.body), parseMarkers(map, now.markers)};
}

dynamic_reconfigure::Config toConfig(const NodeLiveSettings& settings) {
  dynamic_reconfigure::Config config;
  add(&config, "marker_rate", settings.markers.rate);
  add(&config, "tolerance", settings.body.tolerance);
  add(&config, "gravity_x", settings.body.gravity.x());
  add(&config, "gravity_y", settings.body.gravity.y());
  add(&config, "gravity_z", settings.body.gravity.z());
  add(&config, "cutting_force_factor", settings.body.cutting_force_factor);
  config.ints.emplace_back();
  config.ints.back().name = "threads";
  config.ints.back().value = settings.body.threads;
  config.strs.emplace_back();
  config.strs.back().name = "marker_field";
  config.strs.back().value = wordOf(settings.markers.field);
  config.groups.emplace_back();  // the one group there is, as clients expect it
  config.groups.back().name = "Default";
  config.groups.back().state = 1;
  return config;
}

}  // namespace incision

#include "incision/cut/settings.h"

#include "incision/base/yaml_reader.h"

namespace incision {

ScheduledCut parseCut(const YamlValue& value) {
  const YamlMap map = value.map({"time", "label", "point", "normal", "tangent", "length", "width"});
  ScheduledCut cut;
  cut.time = map.number("time", cut.time, SIMULATED_TIME);
  if (const auto label = map.find("label")) cut.plane.label = label->text(MAX_LABEL);
  cut.plane.point = map.vector("point", cut.plane.point);
  cut.plane.normal = map.at("normal").vector();
  cut.plane.tangent = map.vector("tangent", cut.plane.tangent);
  cut.plane.length = map.number("length", cut.plane.length, NOT_NEGATIVE);
  cut.plane.width = map.number("width", cut.plane.width, NOT_NEGATIVE);
  const std::string why = whyInvalid(cut.plane);
  if (!why.empty()) value.fail(why);
  return cut;
}

}  // namespace incision

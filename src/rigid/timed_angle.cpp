#include "incision/rigid/timed_angle.h"

#include "timed_series.h"

namespace incision {

namespace {

TimedAngle parseAngle(const YamlValue& value) {
  const std::vector<YamlValue> entries = value.list(2);
  return {entries[0].number(SIMULATED_TIME), entries[1].number()};
}

std::vector<TimedAngle> parseAngles(const YamlValue& value) { return parseSeries<TimedAngle>(value, parseAngle); }

}  // namespace

void parseAnglesOf(const YamlMap& map, std::vector<TimedAngle>* angles, std::string* file) {
  parseSeriesOf(map, "jaw", parseAngles, angles, file);
}

std::vector<TimedAngle> readAngles(const std::string& path) {
  const std::array<const char*, 2> columns = {"t", "angle"};
  return readSeries<TimedAngle>(path, columns, [](const std::array<double, 2>& numbers, const auto&) {
    return TimedAngle{numbers[0], numbers[1]};
  });
}

double angleAt(const std::vector<TimedAngle>& angles, double time) {
  return seriesAt(angles, time, [](const TimedAngle& before, const TimedAngle& after, double share) {
    return before.angle + share * (after.angle - before.angle);
  });
}

}  // namespace incision

#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>
#include <vector>

#include "incision/base/line_reader.h"
#include "incision/base/printable.h"
#include "incision/base/read_text.h"
#include "incision/base/yaml_reader.h"

namespace incision {

/// Bytes of the largest file of a series: some ten minutes of a thousand poses a second.
inline constexpr std::size_t MAX_SERIES_FILE = std::size_t{1} << 26;

inline constexpr const char* NOT_LATER = "not later than the one before it (allowed: ascending times)";

/// The entries of a list, of which `parse` reads each. `Timed` has a `time` [s].
template <class Timed, class Parse>
std::vector<Timed> parseSeries(const YamlValue& value, const Parse& parse) {
  std::vector<Timed> series;
  for (const YamlValue& entry : value.list()) {
    const Timed timed = parse(entry);
    if (!series.empty() && timed.time <= series.back().time) entry.fail(NOT_LATER);
    series.push_back(timed);
  }
  return series;
}

/// The lines of a CSV file with these columns, the first of them the time; a first line that begins with a letter is a
/// heading. `make(numbers, fail)` makes an entry of the numbers of a line. Times beyond those that are simulated, as
/// those since 1970, count from the first. Throws InputError.
template <class Timed, std::size_t N, class Make>
std::vector<Timed> readSeries(const std::string& path, const std::array<const char*, N>& columns, const Make& make) {
  std::string text = readText(path, MAX_SERIES_FILE);
  std::replace(text.begin(), text.end(), ',', ' ');
  LineReader reader(text, printable(path));
  std::vector<Timed> series;
  while (reader.next()) {
    if (reader.line() == 1 && std::isalpha(static_cast<unsigned char>(reader.rest().front()))) continue;
    std::array<double, N> numbers;
    for (std::size_t i = 0; i < N; ++i) numbers[i] = reader.real(columns[i]);
    reader.endOfLine();
    const Timed timed = make(numbers, [&](const std::string& reason) { reader.fail(reason); });
    if (!series.empty() && timed.time <= series.back().time) reader.fail(NOT_LATER);
    if (timed.time < SIMULATED_TIME.min) reader.fail("t: " + std::to_string(timed.time) + " (allowed: 0 or more)");
    series.push_back(timed);
  }
  if (series.empty())
    reader.fail("nothing (allowed: lines of " + joined(std::vector<std::string>(columns.begin(), columns.end())) + ")");
  if (series.back().time <= SIMULATED_TIME.max) return series;
  const double first = series.front().time;
  for (Timed& timed : series) timed.time -= first;
  if (series.back().time > SIMULATED_TIME.max) reader.fail("t: more than 1e9 s after the first");
  return series;
}

/// The keys `KEY` and `KEY_file` of a map, which has one of them or none; the file is still to be read.
template <class Series, class Parse>
void parseSeriesOf(const YamlMap& map, const std::string& key, const Parse& parse, Series* series, std::string* file) {
  const std::string file_key = key + "_file";
  if (map.has(key) && map.has(file_key)) map.at(file_key).fail("beside " + key + " (allowed: one of the two)");
  if (const auto given = map.find(key)) *series = parse(*given);
  if (const auto path = map.find(file_key)) *file = path->path();
}

/// What `between(before, after, share)` has at a time [s]; before the first and after the last it is that one, of which
/// there must be one.
template <class Timed, class Between>
auto seriesAt(const std::vector<Timed>& series, double time, const Between& between) {
  const auto after =
      std::lower_bound(series.begin(), series.end(), time, [](const Timed& timed, double t) { return timed.time < t; });
  if (after == series.begin()) return between(series.front(), series.front(), 0.0);
  if (after == series.end()) return between(series.back(), series.back(), 0.0);
  const auto before = after - 1;
  return between(*before, *after, (time - before->time) / (after->time - before->time));
}

}  // namespace incision

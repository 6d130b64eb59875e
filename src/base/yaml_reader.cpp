#include "incision/base/yaml_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <utility>

#include "incision/base/foreign_words.h"
#include "incision/base/input_error.h"
#include "incision/base/printable.h"
#include "incision/base/resolve_path.h"
#include "incision/base/suggestion.h"

namespace incision {

namespace {

std::string describe(const Range& range) {
  const Range all;
  std::ostringstream words;
  if (range.min == all.min && range.max == all.max) {
    words << "a finite number";
  } else if (range.min == ABOVE_ZERO) {
    words << "above 0";
    if (range.max < all.max) words << ", up to " << range.max;
  } else if (range.max == all.max) {
    words << range.min << " or more";
  } else {
    words << range.min << " to " << range.max;
  }
  return words.str();
}

std::string describe(const YAML::Node& node) {
  if (node.IsScalar()) return "'" + printable(node.Scalar()) + "'";
  if (node.IsSequence()) return "a list of " + std::to_string(node.size());
  return node.IsMap() ? "a map" : "nothing";
}

// The whole text as a number, in YAML's notation and whatever the locale; nothing when it is none.
std::optional<double> asNumber(std::string text) {
  const double infinity = std::numeric_limits<double>::infinity();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (!text.empty() && text[0] == '+') text.erase(0, 1);
  if (text == ".inf") return infinity;
  if (text == "-.inf") return -infinity;
  if (text == ".nan") return std::numeric_limits<double>::quiet_NaN();
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
  return all;
}

YamlValue::YamlValue(const YAML::Node& node, std::string source, std::string folder, std::string key)
    : node_(node), source_(std::move(source)), folder_(std::move(folder)), key_(std::move(key)) {}

std::string YamlValue::where() const { return source_ + (key_.empty() ? "" : ": " + key_); }

void YamlValue::fail(const std::string& reason) const { throw InputError(where() + ": " + reason); }

void YamlValue::refuse(const std::string& allowed) const { fail(describe(node_) + " (allowed: " + allowed + ")"); }

double YamlValue::number(const Range& range) const {
  const std::optional<double> value = node_.IsScalar() ? asNumber(node_.Scalar()) : std::nullopt;
  if (!value || !std::isfinite(*value) || *value < range.min || *value > range.max) refuse(describe(range));
  return *value;
}

double YamlValue::numberOrInfinity(const Range& range) const {
  const std::optional<double> value = node_.IsScalar() ? asNumber(node_.Scalar()) : std::nullopt;
  if (!value || !(*value >= range.min)) refuse(describe(range) + ", or .inf");
  if (std::isinf(*value)) return *value;
  return number(range);
}

int YamlValue::integer(int min, int max) const {
  const std::string allowed = "a whole number, " + std::to_string(min) + " to " + std::to_string(max);
  const std::optional<double> value = node_.IsScalar() ? asNumber(node_.Scalar()) : std::nullopt;
  if (!value || !(*value >= min && *value <= max) || *value != std::floor(*value)) refuse(allowed);
  return static_cast<int>(*value);
}

bool YamlValue::boolean() const {
  bool value = false;
  if (!node_.IsScalar() || !YAML::convert<bool>::decode(node_, value)) refuse("true, false");
  return value;
}

std::string YamlValue::text(std::size_t max_bytes) const {
  const std::string value = node_.IsScalar() ? node_.Scalar() : "";
  const bool plain = std::none_of(value.begin(), value.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; });
  if (value.empty() || value.size() > max_bytes || !plain) {
    refuse("text of 1 to " + std::to_string(max_bytes) + " characters on one line");
  }
  return value;
}

Vec3 YamlValue::vector(const Range& range) const {
  const std::vector<YamlValue> entries = list(3);
  return {entries[0].number(range), entries[1].number(range), entries[2].number(range)};
}

std::string YamlValue::frame() const {
  const std::string frame = text(MAX_NAME);
  if (frame.front() == '/') refuse("a tf2 frame, which does not begin with /");
  return frame;
}

std::string YamlValue::path() const {
  const std::string address = text(MAX_PATH);
  try {
    return resolvePath(address, folder_);
  } catch (const InputError& error) {
    fail(error.what());
  }
}

std::vector<YamlValue> YamlValue::list(std::optional<std::size_t> count) const {
  const bool fits = node_.IsSequence() ? !count || node_.size() == *count : node_.IsNull() && !count;
  if (!fits) refuse(count ? "a list of " + std::to_string(*count) : "a list");
  std::vector<YamlValue> entries;
  for (const YAML::Node& entry : node_) {
    entries.emplace_back(entry, source_, folder_, key_ + "." + std::to_string(entries.size()));
  }
  return entries;
}

std::optional<YamlValue> YamlValue::peek(const std::string& key) const {
  if (!node_.IsMap()) return std::nullopt;
  for (const auto& entry : node_)
    if (entry.first.IsScalar() && entry.first.Scalar() == key)
      return YamlValue(entry.second, source_, folder_, (key_.empty() ? "" : key_ + ".") + key);
  return std::nullopt;
}

YamlMap YamlValue::map(const std::vector<std::string>& allowed_keys) const {
  const std::string allowed = joined(allowed_keys);
  if (!node_.IsMap() && !node_.IsNull()) refuse("a map with " + allowed);
  std::map<std::string, YamlValue> entries;
  for (const auto& entry : node_) {
    if (!entry.first.IsScalar()) fail("a key that is not text (allowed: " + allowed + ")");
    const std::string name = entry.first.Scalar();
    const YamlValue value(entry.second, source_, folder_, (key_.empty() ? "" : key_ + ".") + printable(name));
    if (std::find(allowed_keys.begin(), allowed_keys.end(), name) == allowed_keys.end()) {
      const std::string said = saidHere(name, allowed_keys);
      value.fail("unknown key" + (said.empty() ? suggestion(name, allowed_keys) : said) + " (allowed: " + allowed +
                 ")");
    }
    if (!entries.emplace(name, value).second) value.fail("given twice (allowed: once)");
  }
  return {*this, std::move(entries)};
}

std::map<std::string, YamlValue> YamlValue::named(std::size_t max_count) const {
  const std::string allowed = "a map of 1 to " + std::to_string(max_count) + " names";
  if (!node_.IsMap() || node_.size() == 0 || node_.size() > max_count) refuse(allowed);
  std::map<std::string, YamlValue> entries;
  for (const auto& entry : node_) {
    const std::string name = entry.first.IsScalar() ? entry.first.Scalar() : "";
    const bool plain = std::all_of(name.begin(), name.end(), [](unsigned char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    });
    if (name.empty() || name.size() > MAX_NAME || !plain) {
      fail("the name '" + printable(name) + "' (allowed: 1 to " + std::to_string(MAX_NAME) + " letters, digits, _, -)");
    }
    const YamlValue value(entry.second, source_, folder_, (key_.empty() ? "" : key_ + ".") + name);
    if (!entries.emplace(name, value).second) value.fail("given twice (allowed: once)");
  }
  return entries;
}

YamlMap::YamlMap(const YamlValue& whole, std::map<std::string, YamlValue> entries)
    : whole_(whole), entries_(std::move(entries)) {}

std::optional<YamlValue> YamlMap::find(const std::string& key) const {
  const auto found = entries_.find(key);
  return found == entries_.end() ? std::nullopt : std::optional<YamlValue>(found->second);
}

YamlValue YamlMap::at(const std::string& key) const {
  if (!has(key)) whole_.fail("the key " + key + " is missing");
  return entries_.at(key);
}

double YamlMap::numberOrInfinity(const std::string& key, double absent, const Range& range) const {
  const auto value = find(key);
  return value ? value->numberOrInfinity(range) : absent;
}

double YamlMap::number(const std::string& key, double absent, const Range& range) const {
  return has(key) ? at(key).number(range) : absent;
}

Vec3 YamlMap::vector(const std::string& key, const Vec3& absent) const { return has(key) ? at(key).vector() : absent; }

std::vector<YamlValue> YamlMap::list(const std::string& key) const {
  return has(key) ? at(key).list() : std::vector<YamlValue>();
}

}  // namespace incision

#pragma once

#include <yaml-cpp/yaml.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "incision/base/limits.h"
#include "incision/base/range.h"
#include "incision/base/vec.h"

namespace incision {

class YamlMap;

/// A value in a YAML tree together with its source and key. Every reader checks type and range and throws InputError
/// "source: key: value (allowed: …)".
class YamlValue {
 public:
  /// `source` is the file or parameter that errors name; relative paths in it are taken from `folder`.
  YamlValue(const YAML::Node& node, std::string source, std::string folder = "", std::string key = "");

  /// A scalar that reads as a number, quoted or not, since rosparam delivers `1e6` as text.
  double number(const Range& range = {}) const;
  /// A number in the range, or .inf.
  double numberOrInfinity(const Range& range) const;
  int integer(int min, int max) const;
  bool boolean() const;
  /// At least one byte, at most `max_bytes`, and no control characters.
  std::string text(std::size_t max_bytes) const;
  Vec3 vector(const Range& range = {}) const;

  /// A name of at most MAX_NAME bytes that tf2 takes for a frame's.
  std::string frame() const;
  /// An absolute path, from any address that resolvePath() knows.
  std::string path() const;

  /// One of a few words, each with its meaning.
  template <class Choice>
  Choice choice(const std::map<std::string, Choice>& meanings) const;

  /// The entries of a list; a key with nothing after it is an empty list. With `count`, exactly so many.
  std::vector<YamlValue> list(std::optional<std::size_t> count = {}) const;

  /// The value of a key, if this is a map that has it, for those who must know it before they know what else the map
  /// may hold.
  std::optional<YamlValue> peek(const std::string& key) const;

  /// A map with none but these keys, each at most once; a key with nothing after it is an empty map.
  YamlMap map(const std::vector<std::string>& allowed_keys) const;

  /// The entries of a map whose keys are names that the user gives: letters, digits, _ and -, at most MAX_NAME of them.
  /// By name, so that their order does not depend on who has written the map. At least one, at most `max_count`.
  std::map<std::string, YamlValue> named(std::size_t max_count) const;

  const std::string& source() const { return source_; }
  /// "source: key".
  std::string where() const;

  /// Throws "source: key: value (allowed: …)".
  [[noreturn]] void refuse(const std::string& allowed) const;
  /// Throws "source: key: reason".
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  YAML::Node node_;
  std::string source_, folder_, key_;
};

/// The entries of a YamlValue that is a map.
class YamlMap {
 public:
  YamlMap(const YamlValue& whole, std::map<std::string, YamlValue> entries);

  std::optional<YamlValue> find(const std::string& key) const;
  /// Throws InputError when the key is missing.
  YamlValue at(const std::string& key) const;
  bool has(const std::string& key) const { return entries_.count(key) > 0; }
  const YamlValue& whole() const { return whole_; }

  /// The value of a key, or `absent` where it is not given.
  double number(const std::string& key, double absent, const Range& range = {}) const;
  double numberOrInfinity(const std::string& key, double absent, const Range& range) const;
  Vec3 vector(const std::string& key, const Vec3& absent) const;

  /// The entries of the list at a key; none where it is not given.
  std::vector<YamlValue> list(const std::string& key) const;

 private:
  YamlValue whole_;
  std::map<std::string, YamlValue> entries_;
};

/// Words for a message: "a, b, c".
std::string joined(const std::vector<std::string>& words);

template <class Choice>
Choice YamlValue::choice(const std::map<std::string, Choice>& meanings) const {
  const auto found = meanings.find(node_.IsScalar() ? node_.Scalar() : "");
  if (found != meanings.end()) return found->second;
  std::vector<std::string> words;
  for (const auto& [word, meaning] : meanings) words.push_back(word);
  refuse(joined(words));
}

}  // namespace incision

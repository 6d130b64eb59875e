#pragma once

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <string>
#include <utility>
#include <vector>

#include "incision/base/input_error.h"
#include "incision/base/yaml_reader.h"

namespace incision::test {

/// A text as the section `key` of a file scene.yaml in /folder.
inline YamlValue section(const std::string& key, const std::string& text) {
  return {YAML::Load(text), "scene.yaml", "/folder", key};
}

/// What the parser says of a section; empty when it accepts it.
template <class Parser>
std::string complaint(const Parser& parse, const std::string& key, const std::string& text) {
  try {
    parse(section(key, text));
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

/// Each text of the section `key` is refused in one line, which begins with the source, the key and the word beside
/// the text.
template <class Parser>
void expectRefused(const Parser& parse, const std::string& key,
                   const std::vector<std::pair<std::string, std::string>>& bad) {
  for (const auto& [text, begin] : bad) {
    const std::string message = complaint(parse, key, text);
    EXPECT_EQ(message.find("scene.yaml: " + key + begin), 0u) << text << "\n" << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << text << "\n" << message;
  }
}

}  // namespace incision::test

// What the reader says of other simulators' words, held against the parsers.
#include "incision/base/foreign_words.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <map>
#include <sstream>
#include <string>

#include "incision/base/input_error.h"
#include "incision/scene/scene.h"

namespace incision {
namespace {

/// Of each section's own key, a scene in which a word of that section stands in the place of WORD.
const std::map<std::string, std::vector<std::string>> SECTIONS = {
    {"boundary", {"WORD: 1"}},
    {"regions", {"body: {WORD: 1}"}},
    {"material", {"body: {WORD: 1}", "body: {regions: [{box: [[0, 0, 0], [1, 1, 1]], WORD: 1}]}"}},
    {"poisson_ratio",
     {"body: {material: {WORD: 1}}", "body: {regions: [{box: [[0, 0, 0], [1, 1, 1]], material: {WORD: 1}}]}"}},
    {"cells", {"body: {grid: {WORD: 1}}"}},
    {"group", {"boundary: [{WORD: 1}]", "loads: [{WORD: 1}]", "body: {regions: [{WORD: 1}]}"}},
    {"velocity", {"boundary: [{WORD: 1}]"}},
    {"traction", {"loads: [{WORD: 1}]"}},
    {"time_step", {"solver: {WORD: 1}"}},
    {"normal", {"cuts: [{WORD: 1}]"}},
    {"crack_speed", {"fracture: {WORD: 1}"}},
    {"self", {"contact: {WORD: 1}"}},
    {"max_step", {"tools: {knife: {type: blade, WORD: 1}}"}}};

std::vector<std::string> apart(const std::string& words) {
  std::istringstream all(words);
  std::vector<std::string> each;
  for (std::string word; all >> word;) each.push_back(word);
  return each;
}

/// A part of a scene with what it needs beside it.
YAML::Node whole(const std::string& part) {
  YAML::Node scene = YAML::Load(part);
  const YAML::Node body = scene["body"];
  if (!body || !(body["mesh"] || body["meshes"] || body["grid"]))
    scene["body"]["grid"] = YAML::Load("{cells: [1, 1, 1]}");
  return scene;
}

std::string complaintOfPart(const std::string& part) {
  try {
    parseScene(whole(part), "scene.yaml", "/folder");
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(ForeignWordsInScenes, EveryExampleIsAPartOfAScene) {
  for (const ForeignWords& known : foreignWords())
    for (const std::string& example : known.examples) EXPECT_EQ(complaintOfPart(example), "") << known.how;
}

TEST(ForeignWordsInScenes, EveryWordIsAnsweredInEachOfItsSections) {
  for (const ForeignWords& known : foreignWords())
    for (const std::string& key : apart(known.beside)) {
      ASSERT_TRUE(SECTIONS.count(key)) << key;
      for (std::string scene : SECTIONS.at(key))
        for (const std::string& word : apart(known.words)) {
          std::string with = scene;
          const std::string said = complaintOfPart(with.replace(with.find("WORD"), 4, word));
          EXPECT_NE(said.find(word + ": unknown key: " + known.how), std::string::npos) << with << "\n" << said;
          EXPECT_EQ(said.find('\n'), std::string::npos) << said;
        }
    }
}

}  // namespace
}  // namespace incision

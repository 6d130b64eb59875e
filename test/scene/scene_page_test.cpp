// The table of scene keys in config/README.md, held against the parsers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "incision/base/input_error.h"
#include "incision/scene/scene.h"
#include "support/scene_table.h"

namespace incision {
namespace {

const std::string FOLDER = INCISION_SOURCE_DIR;

// The scene with every section, or where a key goes with another kind of body, the one of that.
std::string sceneWith(const std::string& key) {
  const auto begins = [&](const char* beginning) { return key.rfind(beginning, 0) == 0; };
  const char* name = begins("body.meshes")                         ? "meshes"
                     : begins("body.scale") || begins("body.mesh") ? "mesh"
                                                                   : "everything";
  return FOLDER + "/test/fuzz/scene_corpus/" + name + ".yaml";
}

// What is said of such a scene when one value is put into it.
std::string complaintOfKey(const std::string& key, const std::string& value) {
  try {
    loadScene(sceneWith(key), {key + "=" + value});
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

// A name that the user gives, in capitals here. Of tools it says which kind: its rows are what that has beside all.
bool isName(const std::string& key) {
  return std::all_of(key.begin(), key.end(), [](unsigned char c) { return std::isupper(c); });
}

TEST(ScenePage, ListsEveryKeyAndNoOther) {
  std::map<std::string, std::set<std::string>> listed;
  for (SceneRow row : sceneRows(FOLDER)) {
    for (std::size_t dot = row.key.rfind('.'); dot != std::string::npos; dot = row.key.rfind('.')) {
      const std::string last = row.key.substr(dot + 1);
      row.key.resize(dot);
      if (last != "0" && !isName(last)) listed[row.key].insert(last);
    }
    listed[""].insert(row.key);
  }
  EXPECT_GT(listed.size(), 9u);
  const std::set<std::string> of_all_tools = listed["tools.NAME"];
  for (auto& [section, keys] : listed)
    if (section.rfind("tools.", 0) == 0) keys.insert(of_all_tools.begin(), of_all_tools.end());
  for (const auto& [section, keys] : listed) {
    if (keys.empty()) continue;
    const std::string message = complaintOfKey((section.empty() ? "" : section + ".") + "?", "1");
    std::smatch allowed;
    ASSERT_TRUE(std::regex_search(message, allowed, std::regex(R"(unknown key \(allowed: (.*)\))"))) << message;
    std::set<std::string> known;
    const std::string words = allowed[1];
    const std::regex word("[a-z_]+");
    for (std::sregex_iterator w(words.begin(), words.end(), word), end; w != end; ++w) known.insert(w->str());
    EXPECT_EQ(keys, known) << section;
  }
}

TEST(ScenePage, GivesTheRangesOfNumbers) {
  int checked = 0;
  for (const SceneRow& row : sceneRows(FOLDER)) {
    if (row.type != "number" && row.type != "integer") continue;
    const std::string range = std::regex_replace(row.range, std::regex("π/2"), "1.570796");
    std::smatch bounds;
    std::vector<std::string> good, bad;
    if (std::regex_search(range, bounds, std::regex(R"(^([\d.e-]+) to ([\d.e-]*\d))"))) {
      good = {bounds[1], bounds[2]};
      bad = {std::to_string(std::stod(bounds[1]) - 1), std::to_string(std::stod(bounds[2]) * 1.02)};
    } else if (std::regex_search(range, std::regex("^above 0"))) {
      good = {"1e-300", "1e300"}, bad = {"0", "-1"};
    } else if (std::regex_search(range, std::regex("^0 or more"))) {
      good = {"0", "1e300"}, bad = {"-1e-300"};
    } else if (std::regex_search(range, std::regex("^finite"))) {
      good = {"-1e300", "1e300"}, bad = {".inf", ".nan"};
    }
    EXPECT_FALSE(good.empty()) << row.key << ": " << row.range;
    for (const std::string& value : good) EXPECT_EQ(complaintOfKey(row.key, value), "") << row.key;
    for (const std::string& value : bad) EXPECT_NE(complaintOfKey(row.key, value), "") << row.key << " " << value;
    if (std::regex_search(range, std::regex(R"(\.inf)"))) {
      // Another section may still need a number there, and then says so without a range.
      EXPECT_EQ(complaintOfKey(row.key, ".inf").find("allowed"), std::string::npos) << row.key;
    }
    ++checked;
  }
  EXPECT_GT(checked, 20);
}

}  // namespace
}  // namespace incision

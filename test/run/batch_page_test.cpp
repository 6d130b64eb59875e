// The tables of the page on the batch program, held against the program.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "support/batch_folder.h"

namespace incision {
namespace {

using Words = std::set<std::string>;

class BatchPage : public BatchFolder {
 protected:
  /// What stands in code in the first cells of the table with this heading, each word by itself.
  static Words listed(const std::string& heading, const std::string& word) {
    std::ifstream page(std::string(INCISION_SOURCE_DIR) + "/launch/README.md");
    Words words;
    bool inside = false;
    const std::regex in_code("`(" + word + ")[^`]*`");
    for (std::string line; std::getline(page, line); inside = inside && !line.empty()) {
      inside = inside || line.rfind(heading, 0) == 0;
      if (!inside) continue;
      const std::string cell = line.substr(0, line.find('|', 1));
      for (std::sregex_iterator found(cell.begin(), cell.end(), in_code), end; found != end; ++found)
        words.insert(found->str(1));
    }
    return words;
  }
};

TEST_F(BatchPage, ListsEveryKeyOfTheJsonAndNoOther) {
  const std::string tool = "tools={hook: {type: blade, edge: [[0, 0, 0], [0, 0, 1]]}}";
  ASSERT_EQ(run({file("bar.yaml"), "--steps", "1", "--set", tool}), BatchStatus::DONE) << err_.str();
  Words keys;
  const nlohmann::json line = nlohmann::json::parse(out_.str());
  for (const auto& [key, value] : line.items()) keys.insert(key);
  EXPECT_EQ(listed("| JSON key |", "[a-z_]+"), keys);
}

TEST_F(BatchPage, ListsEveryOptionAndNoOther) {
  ASSERT_EQ(run({"--help"}), BatchStatus::DONE);
  const std::string help = out_.str();
  Words options;
  const std::regex option("\n  (--[a-z-]+)");
  for (std::sregex_iterator found(help.begin(), help.end(), option), end; found != end; ++found)
    options.insert(found->str(1));
  EXPECT_EQ(listed("| option | default | meaning |", "--[a-z-]+"), options);
}

}  // namespace
}  // namespace incision

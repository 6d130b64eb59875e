#pragma once

#include <fstream>
#include <regex>
#include <string>
#include <vector>

namespace incision {

/// A row of the table of scene keys in config/README.md.
struct SceneRow {
  std::string key;  ///< such as loads.0.ramp
  std::string type, standard, range;
};

/// All rows; where one has two keys, each has its own.
inline std::vector<SceneRow> sceneRows(const std::string& package) {
  std::ifstream page(package + "/config/README.md");
  std::vector<SceneRow> rows;
  bool inside = false;
  const std::regex cells(R"(\| `([^|]*)` \| ([^|]*) \|[^|]*\| ([^|]*) \| (.*) \|)");
  for (std::string line; std::getline(page, line); inside = inside && !line.empty()) {
    inside = inside || line == "| key | type | unit | default | range and meaning |";
    std::smatch cell;
    if (!inside || !std::regex_match(line, cell, cells)) continue;
    std::string name =
        std::regex_replace(std::regex_replace(cell.str(1), std::regex(R"(\[\]\.)"), ".0."), std::regex(R"(\[\])"), "");
    const std::size_t comma = name.find("`, `");  // a second key of that section
    rows.push_back({name.substr(0, comma), cell[2], cell[3], cell[4]});
    if (comma == std::string::npos) continue;
    rows.push_back({name.substr(0, name.rfind('.', comma) + 1) + name.substr(comma + 4), cell[2], cell[3], cell[4]});
  }
  return rows;
}

}  // namespace incision

#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace incision::bench {

/// One measured run: what was run, its sizes, times in milliseconds.
using Json = nlohmann::ordered_json;

/// A column of a table: its heading, where its value lies in a row, and how many digits follow the point.
struct Column {
  std::string heading, pointer;
  int digits = 0;
};

/// Prints rows under headings on standard output as they come. A row starts with its "name"; what it lacks is a dash.
class Table {
 public:
  Table(const std::string& title, std::vector<Column> columns);
  void print(const Json& row) const;

 private:
  std::vector<Column> columns_;
};

}  // namespace incision::bench

#include "benchmark/table.h"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace incision::bench {
namespace {

constexpr int NAME_WIDTH = 34;

int width(const Column& column) {
  return std::max({9, column.digits + 5, 2 + static_cast<int>(column.heading.size())});
}

std::string cell(const Json& row, const Column& column) {
  const Json::json_pointer pointer(column.pointer);
  if (!row.contains(pointer)) return "-";
  std::ostringstream text;
  text << std::fixed << std::setprecision(column.digits) << row.at(pointer).get<double>();
  return text.str();
}

}  // namespace

Table::Table(const std::string& title, std::vector<Column> columns) : columns_(std::move(columns)) {
  std::cout << '\n' << title << '\n' << std::string(NAME_WIDTH, ' ');
  for (const Column& column : columns_) std::cout << std::setw(width(column)) << column.heading;
  std::cout << std::endl;
}

void Table::print(const Json& row) const {
  std::cout << std::left << std::setw(NAME_WIDTH) << row.at("name").get<std::string>() << std::right;
  for (const Column& column : columns_) std::cout << std::setw(width(column)) << cell(row, column);
  std::cout << std::endl;
}

}  // namespace incision::bench

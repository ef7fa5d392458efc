#pragma once

#include <algorithm>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "support/real_inputs.hpp"

namespace lepp::test {

using Row = std::map<std::string, std::string>;

/// The cells of one line of a .csv file.
inline std::vector<std::string> split_cells(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    else if (c == ',' && !quoted) cells.emplace_back();
    else if (c != '\r') cells.back() += c;
  }
  return cells;
}

/// The rows of a .csv file among the real inputs, by the names in its first line.
inline std::vector<Row> table(const std::string& name) {
  std::vector<Row> rows;
  const auto file = real_input(name);
  if (!file) return rows;
  std::ifstream in(*file);
  std::string line;
  std::getline(in, line);
  const auto head = split_cells(line);
  while (std::getline(in, line)) {
    const auto cells = split_cells(line);
    Row row;
    for (std::size_t i = 0; i < std::min(head.size(), cells.size()); ++i) row[head[i]] = cells[i];
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace lepp::test

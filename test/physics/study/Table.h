// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Tables of CSV files and of pages of the guide.

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace perilymph::test {

/// The cells of a line of CSV; quoted ones may hold commas.
inline std::vector<std::string> csvCells(const std::string& line)
{
  std::vector<std::string> cells(1);
  bool isQuoted = false;
  for (const char letter : line) {
    if (letter == '"')
      isQuoted = !isQuoted;
    else if (letter == ',' && !isQuoted)
      cells.emplace_back();
    else
      cells.back() += letter;
  }
  return cells;
}

using Row = std::map<std::string, std::string>;

/// The rows of a CSV file by the names of its columns.
inline std::vector<Row> csvRows(const std::filesystem::path& file)
{
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  const std::vector<std::string> header = csvCells(line);
  std::vector<Row> rows;
  while (std::getline(stream, line)) {
    const std::vector<std::string> cells = csvCells(line);
    Row row;
    for (std::size_t i = 0; i < header.size() && i < cells.size(); ++i) row[header[i]] = cells[i];
    rows.push_back(row);
  }
  return rows;
}

/// The cells of every table's rows in one section of a page.
inline std::vector<std::vector<std::string>> pageRows(const std::filesystem::path& page,
                                                      const std::string& heading)
{
  std::ifstream stream(page);
  std::string line;
  while (std::getline(stream, line) && line != heading) continue;
  std::vector<std::vector<std::string>> rows;
  while (std::getline(stream, line) && line.rfind("##", 0) != 0) {
    if (line.rfind("| ", 0) != 0) continue;
    std::vector<std::string> cells;
    std::istringstream row(line.substr(1));
    std::string cell;
    while (std::getline(row, cell, '|')) {
      const auto from = cell.find_first_not_of(" *");
      cells.push_back(from == std::string::npos
                          ? ""
                          : cell.substr(from, cell.find_last_not_of(" *") + 1 - from));
    }
    rows.push_back(cells);
  }
  return rows;
}

}  // namespace perilymph::test

// SPDX-License-Identifier: BSD-3-Clause
#include "TickLog.h"

#include <fstream>
#include <sstream>

namespace perilymph::hidstack {

namespace {

std::ostream& operator<<(std::ostream& out, const HandleTick& tick)
{
  return out << tick.due << ' ' << tick.sent << ' ' << tick.answered << ' ' << tick.force << ' '
             << tick.outputs << ' ' << tick.sequence << ' ' << tick.position << ' ' << tick.passage;
}
std::istream& operator>>(std::istream& in, HandleTick& tick)
{
  return in >> tick.due >> tick.sent >> tick.answered >> tick.force >> tick.outputs >>
         tick.sequence >> tick.position >> tick.passage;
}

std::ostream& operator<<(std::ostream& out, const LoopTick& tick)
{
  return out << tick.read << ' ' << tick.written << ' ' << tick.sequence << ' ' << tick.isValid
             << ' ' << tick.force;
}
std::istream& operator>>(std::istream& in, LoopTick& tick)
{
  return in >> tick.read >> tick.written >> tick.sequence >> tick.isValid >> tick.force;
}

std::ostream& operator<<(std::ostream& out, const ReportRow& row)
{
  return out << row.read << ' ' << row.sequence;
}
std::istream& operator>>(std::istream& in, ReportRow& row)
{
  return in >> row.read >> row.sequence;
}

template <class Row>
Result<void> writeRows(const std::filesystem::path& file, const std::vector<Row>& rows)
{
  std::ofstream out(file);
  out.precision(12);
  for (const Row& row : rows) out << row << '\n';
  out.flush();
  if (!out) return Error{file.string() + " could not be written: is the disk full?"};
  return {};
}

template <class Row>
Result<std::vector<Row>> readRows(const std::filesystem::path& file)
{
  std::ifstream in(file);
  if (!in) return Error{file.string() + " could not be opened: the program that writes it failed."};
  std::vector<Row> rows;
  for (std::string line; std::getline(in, line);) {
    std::istringstream text(line);
    Row row;
    if (!(text >> row))
      return Error{file.string() + ", line " + std::to_string(rows.size() + 1) + ": '" + line +
                   "' is no row of this log."};
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

Result<void> write(const std::filesystem::path& file, const std::vector<HandleTick>& ticks)
{
  return writeRows(file, ticks);
}
Result<void> write(const std::filesystem::path& file, const std::vector<LoopTick>& ticks)
{
  return writeRows(file, ticks);
}
Result<void> write(const std::filesystem::path& file, const std::vector<ReportRow>& rows)
{
  return writeRows(file, rows);
}

Result<std::vector<HandleTick>> readHandleLog(const std::filesystem::path& file)
{
  return readRows<HandleTick>(file);
}
Result<std::vector<LoopTick>> readLoopLog(const std::filesystem::path& file)
{
  return readRows<LoopTick>(file);
}
Result<std::vector<ReportRow>> readReportLog(const std::filesystem::path& file)
{
  return readRows<ReportRow>(file);
}

}  // namespace perilymph::hidstack

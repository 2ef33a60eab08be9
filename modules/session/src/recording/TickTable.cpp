// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/TickTable.h"

#include <fstream>
#include <optional>
#include <string>

#include "perilymph/database/Database.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/session/Csv.h"

namespace perilymph::session {

namespace {

using database::Database;
using database::Statement;

/// Fills an empty file.
Result<void> fillTable(const RecordedInsertion& recorded, const std::filesystem::path& place)
{
  auto table = Database::openNew(place);
  if (!table) return table.error();
  std::string columns, values;
  for (const char* name : columnNames) {
    columns += std::string(", ") + name + " REAL";
    values += ",?";
  }
  // One transaction into a file that gets its name when it is whole: a journal protects nothing.
  if (auto done =
          table->run("PRAGMA journal_mode=OFF; BEGIN; CREATE TABLE tick(tick INTEGER PRIMARY KEY" +
                     columns + ")");
      !done)
    return done;
  {
    auto insert = table->prepare("INSERT INTO tick VALUES(?" + values + ")");
    if (!insert) return insert.error();
    std::optional<Error> failed;
    const auto read = recorded.forEach([&](const haptics::TickRecord& record) {
      insert->reset();
      insert->bind(0, static_cast<std::int64_t>(record.tick));
      int parameter = 1;
      for (const double value : columnValues(record)) insert->bind(parameter++, value);
      if (insert->step() == Statement::Step::done) return true;
      failed = Error{table->lastError()};
      return false;
    });
    if (!read) return read.error();
    if (failed) return *failed;
  }
  return table->run("COMMIT");
}

}  // namespace

Result<void> writeTickTable(const RecordedInsertion& recorded, const std::filesystem::path& file)
{
  if (const auto done = database::checkNoCompanions(file); !done) return done.error();
  Result<void> filled;
  const auto written = writeWhole(file, [&](const std::filesystem::path& place) {
    if (!std::ofstream(place, std::ios::binary)) return false;
    filled = fillTable(recorded, place);
    return static_cast<bool>(filled);
  });
  if (!filled) return filled.error();
  return written;
}

}  // namespace perilymph::session

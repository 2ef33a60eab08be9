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

/// Fills an empty file at a place; messages name the file that it becomes.
Result<void> fillTable(const RecordedInsertion& recorded, const std::filesystem::path& place,
                       const std::filesystem::path& file)
{
  const auto cannotWrite = [&file](const Sentence& reason) {
    return Error{"%1 cannot be written: %2. Make space on its disk, or name a file on another one.",
                 file, reason};
  };
  auto table = Database::openNew(place);
  if (!table) return cannotWrite(table.error().message);
  std::string columns, values;
  for (const char* name : columnNames) {
    columns += std::string(", ") + name + " REAL";
    values += ",?";
  }
  // One transaction into a file that gets its name when it is whole: a journal protects nothing, and
  // would be left where the program is interrupted. SQLite's defensive mode knows no journal_mode=OFF.
  if (auto done = table->run(
          "PRAGMA journal_mode=MEMORY; BEGIN; CREATE TABLE tick(tick INTEGER PRIMARY KEY" +
          columns + ")");
      !done)
    return cannotWrite(done.error().message);
  {
    auto insert = table->prepare("INSERT INTO tick VALUES(?" + values + ")");
    if (!insert) return cannotWrite(insert.error().message);
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
    if (failed) return cannotWrite(failed->message);
  }
  if (const auto done = table->run("COMMIT"); !done) return cannotWrite(done.error().message);
  return {};
}

}  // namespace

Result<void> writeTickTable(const RecordedInsertion& recorded, const std::filesystem::path& file)
{
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(file, ignored);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    return Error{
        "%1 is not a file: a table of SQLite cannot go into a folder, a pipe or a device. Name a "
        "file.",
        file};
  if (const auto done = database::checkNoCompanions(file); !done) return done.error();
  Result<void> filled;
  const auto written = writeWhole(file, [&](const std::filesystem::path& place) {
    if (!std::ofstream(place, std::ios::binary)) return false;
    filled = fillTable(recorded, place, file);
    return static_cast<bool>(filled);
  });
  if (!filled) return filled.error();
  return written;
}

}  // namespace perilymph::session

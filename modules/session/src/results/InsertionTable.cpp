// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/InsertionTable.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>

#include "perilymph/foundation/Unfinished.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::session {

namespace {

namespace fs = std::filesystem;
using database::Database;
using database::Statement;
using Table = InsertionTableKind::Table;

bool isDone(Statement& statement)
{
  const bool done = statement.step() == Statement::Step::done;
  statement.reset();
  return done;
}

/// Writes the facts of a new file, with the seal of no row.
Result<void> keepFacts(Database& database, const SealedFacts& facts)
{
  auto insert = database.prepare("INSERT INTO meta VALUES(?,?)");
  if (!insert) return insert.error();
  SealedFacts sealed = facts;
  sealed[sealKey] = sealOver(facts, Sha256());
  for (const auto& [key, value] : sealed) {
    insert->bind(0, key);
    insert->bind(1, value);
    if (!isDone(*insert)) return Error{database.lastError()};
  }
  return {};
}

/// Creates an empty file: a file with the final name is whole or does not exist. One that another
/// program made meanwhile is left as it is.
Result<void> create(const fs::path& file, const InsertionTableKind& kind, const SealedFacts& facts)
{
  const auto failed = [&file](const std::string& reason) {
    return Error{
        "%1 cannot be created: %2. Check the folder's permissions and the space on the disk.", file,
        reason};
  };
  const std::string unfinished = unfinishedPath(file).string();
  const int descriptor =
      ::open(unfinished.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_NOFOLLOW | O_CLOEXEC,
             kind.audience == Audience::owner ? 0600 : 0666);
  if (descriptor < 0) return failed("its folder takes no file");
  ::close(descriptor);
  const auto written = [&]() -> Result<void> {
    auto opened = Database::openNew(unfinished);
    if (!opened) return opened.error();
    if (const auto done = opened->run(database::creationOf(kind.file)); !done) return done;
    if (const auto done = keepFacts(*opened, facts); !done) return done;
    return opened->run("COMMIT");
  }();
  const int problem = written ? giveNewName(unfinished, file) : 0;
  std::error_code ignored;
  fs::remove(unfinished, ignored);
  if (!written) return failed(written.error().message);
  if (problem == 0 || problem == EEXIST) return {};
  if (problem == EPERM || problem == EOPNOTSUPP)
    return Error{
        "%1 cannot be created: its file system has no hard links. Give a folder on another disk.",
        file};
  return failed(std::strerror(problem));
}

/// Reads one row; empty if a value has another type than its column.
std::optional<Row> rowOf(const Statement& statement, const std::string& columns)
{
  Row row;
  row.reserve(columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const int column = static_cast<int>(i);
    const Statement::Type type = statement.type(column);
    if (columns[i] == 'i' && type == Statement::Type::integer)
      row.emplace_back(statement.integer(column));
    else if (columns[i] == 'r' && type == Statement::Type::real)
      row.emplace_back(statement.real(column));
    else if (columns[i] == 't' && type == Statement::Type::text)
      row.emplace_back(statement.text(column));
    else
      return std::nullopt;
  }
  return row;
}

/// The whole number at the beginning of a row.
std::int64_t numberOf(const Row& row) { return std::get<std::int64_t>(row.front()); }

/// Adds a row to a hash. SQLite stores -0.0 as 0.0.
void addTo(Sha256& hash, std::size_t table, const Row& row)
{
  hash.add(std::uint64_t{table});
  for (const Cell& cell : row) {
    if (const auto* text = std::get_if<std::string>(&cell)) {
      hash.add(std::uint64_t{text->size()});
      hash.add(std::string_view(*text));
      continue;
    }
    const auto* real = std::get_if<double>(&cell);
    std::uint64_t bits = real ? 0 : static_cast<std::uint64_t>(std::get<std::int64_t>(cell));
    const double plain = real ? *real + 0.0 : 0.0;
    if (real) std::memcpy(&bits, &plain, sizeof bits);
    hash.add(bits);
  }
}

void addTo(Sha256& hash, const InsertionRows& one)
{
  addTo(hash, 0, one.row);
  for (std::size_t i = 0; i < one.others.size(); ++i)
    for (const Row& row : one.others[i]) addTo(hash, i + 1, row);
}

/// The rows of one table, the key first.
class Reader {
public:
  static Result<Reader> open(const Database& database, const Table& table)
  {
    std::string keys;
    for (std::size_t i = 1; i <= table.keys; ++i) keys += (i > 1 ? ", " : "") + std::to_string(i);
    auto rows = database.prepare("SELECT * FROM " + table.name + " ORDER BY " + keys);
    if (!rows) return database.readingError(rows.error().message);
    Reader reader(database, table, *std::move(rows));
    if (const auto done = reader.next(); !done) return done.error();
    return reader;
  }

  /// The row at which the reader stands; null behind the last.
  const Row* row() const { return row_ ? &*row_ : nullptr; }

  Result<void> next()
  {
    const Statement::Step step = rows_.step();
    if (step == Statement::Step::failed) return database_->readingError(database_->lastError());
    std::optional<Row> found;
    if (step == Statement::Step::row) {
      found = rowOf(rows_, table_->columns);
      if (!found)
        return database_->readingError(Sentence{"a value in %1 has another type", table_->name});
      if (row_ && !std::lexicographical_compare(row_->begin(), row_->begin() + keys(),
                                                found->begin(), found->begin() + keys()))
        return database_->readingError(Sentence{"the rows of %1 are not in order", table_->name});
    }
    row_ = std::move(found);
    return {};
  }

private:
  Reader(const Database& database, const Table& table, Statement rows)
      : database_(&database), table_(&table), rows_(std::move(rows))
  {
  }
  std::ptrdiff_t keys() const { return static_cast<std::ptrdiff_t>(table_->keys); }

  const Database* database_;
  const Table* table_;
  Statement rows_;
  std::optional<Row> row_;
};

bool insertRow(Statement& insert, const Row& row)
{
  int place = 0;
  for (const Cell& cell : row)
    std::visit([&](const auto& value) { insert.bind(place++, value); }, cell);
  return isDone(insert);
}

}  // namespace

std::vector<std::string> lastingRows(const std::string& table, const std::string& key)
{
  return {std::string("SELECT key, value FROM meta WHERE key <> '") + sealKey + "' ORDER BY key",
          "SELECT * FROM " + table + " ORDER BY " + key};
}

Result<InsertionTable> InsertionTable::openToContinue(const fs::path& file,
                                                      const InsertionTableKind& kind,
                                                      const SealedFacts& facts)
{
  std::error_code ignored;
  if (!fs::exists(file, ignored))
    if (const auto done = create(file, kind, facts); !done) return done.error();
  auto opened = Database::openToAppend(file, kind.file);
  if (!opened) return opened.error();
  InsertionTable table(*std::move(opened), file, kind);
  if (const auto done = table.database_.run("PRAGMA journal_mode=WAL; PRAGMA synchronous=FULL");
      !done)
    return Error{"%1 cannot be continued: %2.", file, done.error().message};
  if (const auto done = table.readFacts(); !done) return done.error();
  if (const auto done = table.checkRows(); !done) return done.error();
  if (const auto done = table.expect(facts); !done) return done.error();
  return table;
}

Result<InsertionTable> InsertionTable::beginAgain(const fs::path& file,
                                                  const InsertionTableKind& kind,
                                                  const SealedFacts& facts)
{
  if (const auto refused = checkWritable(file, Links::refused); !refused) return refused.error();
  auto former = Database::openNew(file);
  if (former && !former->run("PRAGMA locking_mode=EXCLUSIVE; BEGIN IMMEDIATE; COMMIT") &&
      former->isBusy())
    return Error{"%1 is in use: another program works on it. Wait until that program has ended.",
                 file};
  // removed while it is locked
  std::error_code failure;
  for (const char* companion : {"", "-wal", "-shm", "-journal"}) {
    fs::remove(file.string() + companion, failure);
    if (failure) return Error{"%1 cannot be removed: %2.", file, failure.message()};
  }
  if (former) former->abandon();
  return openToContinue(file, kind, facts);
}

Result<InsertionTable> InsertionTable::open(const fs::path& file, const InsertionTableKind& kind)
{
  auto opened = Database::open(file, kind.file);
  if (!opened) return opened.error();
  InsertionTable table(*std::move(opened), file, kind);
  if (const auto done = table.readFacts(); !done) return done.error();
  if (const auto done = table.checkRows(); !done) return done.error();
  return table;
}

Result<InsertionTable::Outline> InsertionTable::outlineOf(const fs::path& file,
                                                          const InsertionTableKind& kind)
{
  auto opened = Database::open(file, kind.file);
  if (!opened) return opened.error();
  InsertionTable table(*std::move(opened), file, kind);
  if (const auto done = table.readFacts(); !done) return done.error();
  // Not count(*): of a damaged file it would not end.
  const Table& insertions = kind.tables.front();
  auto rows = table.database_.prepare("SELECT 1 FROM " + insertions.name);
  if (!rows) return table.damaged(rows.error().message);
  Outline outline{table.facts_, 0};
  Statement::Step step = rows->step();
  for (; step == Statement::Step::row; step = rows->step()) ++outline.count;
  if (step == Statement::Step::failed) return table.damaged(table.database_.lastError());
  return outline;
}

Result<void> InsertionTable::readFacts()
{
  auto rows = database_.prepare("SELECT key, value FROM meta ORDER BY key");
  if (!rows) return damaged(rows.error().message);
  Statement::Step step = rows->step();
  for (; step == Statement::Step::row; step = rows->step())
    if (rows->type(0) != Statement::Type::text || rows->type(1) != Statement::Type::text ||
        !facts_.emplace(rows->text(0), rows->text(1)).second)
      return damaged(Sentence{"a fact about it is not readable"});
  if (step == Statement::Step::failed) return damaged(database_.lastError());
  return {};
}

Result<void> InsertionTable::checkRows()
{
  const auto done = read([this](const InsertionRows& one) -> Result<void> {
    addTo(rows_, one);
    ++count_;
    return {};
  });
  if (!done) return done;
  const auto program = facts_.find(programFact);
  seal_ = sealIn(facts_, rows_, database_.version() >= kind_->sealedFrom,
                 program == facts_.end() ? std::string_view() : program->second);
  facts_.erase(sealKey);
  return {};
}

Result<void> InsertionTable::expect(const SealedFacts& facts) const
{
  const auto fact = [](const SealedFacts& all, const char* key) {
    const auto found = all.find(key);
    return found == all.end() ? std::string() : found->second;
  };
  if (seal_ == Seal::changed)
    return Error{
        "%1 was changed after the program wrote it, so its results are not continued. Delete it or "
        "give another folder.",
        file_};
  if (seal_ == Seal::absent)
    return Error{
        "%1 carries no seal: it is of an earlier version. Delete it or give another folder.",
        file_};
  if (fact(facts_, fingerprintFact) != fact(facts, fingerprintFact))
    return Error{"%1 %2 Delete it or give another folder.", file_, kind_->foreign};
  if (fact(facts_, programFact) != fact(facts, programFact))
    return Error{
        "%1 was begun by another build of the program (%2; this is %3). Delete it or give another "
        "folder.",
        file_, fact(facts_, programFact), fact(facts, programFact)};
  if (facts_ != facts)
    return Error{"%1 is for other insertions. Delete it or give another folder.", file_};
  return {};
}

Result<void> InsertionTable::read(
    const std::function<Result<void>(const InsertionRows&)>& each) const
{
  std::vector<Reader> readers;
  for (const Table& table : kind_->tables) {
    auto reader = Reader::open(database_, table);
    if (!reader) return reader.error();
    readers.push_back(*std::move(reader));
  }
  while (const Row* row = readers.front().row()) {
    InsertionRows one{*row, std::vector<std::vector<Row>>(readers.size() - 1)};
    for (std::size_t i = 1; i < readers.size(); ++i)
      while (readers[i].row() && numberOf(*readers[i].row()) == numberOf(one.row)) {
        one.others[i - 1].push_back(*readers[i].row());
        if (const auto done = readers[i].next(); !done) return done;
      }
    if (const auto done = each(one); !done) return done;
    if (const auto done = readers.front().next(); !done) return done;
    for (std::size_t i = 1; i < readers.size(); ++i)
      if (const Row* other = readers[i].row(); other && numberOf(*other) <= numberOf(one.row))
        return damaged(Sentence{"rows of %1 belong to no insertion", kind_->tables[i].name});
  }
  for (std::size_t i = 1; i < readers.size(); ++i)
    if (readers[i].row())
      return damaged(Sentence{"rows of %1 belong to no insertion", kind_->tables[i].name});
  return {};
}

Result<void> InsertionTable::append(const std::vector<InsertionRows>& block)
{
  Sha256 rows = rows_;
  for (const InsertionRows& one : block) addTo(rows, one);
  const auto written = [&]() -> Result<void> {
    if (const auto done = database_.run("BEGIN"); !done) return done;
    for (std::size_t i = 0; i < kind_->tables.size(); ++i) {
      std::string values(2 * kind_->tables[i].columns.size() - 1, ',');
      for (std::size_t k = 0; k < values.size(); k += 2) values[k] = '?';
      auto insert =
          database_.prepare("INSERT INTO " + kind_->tables[i].name + " VALUES(" + values + ")");
      if (!insert) return insert.error();
      for (const InsertionRows& one : block) {
        if (i == 0 && !insertRow(*insert, one.row)) return Error{database_.lastError()};
        if (i > 0 && i <= one.others.size())
          for (const Row& row : one.others[i - 1])
            if (!insertRow(*insert, row)) return Error{database_.lastError()};
      }
    }
    auto seal = database_.prepare("UPDATE meta SET value = ? WHERE key = ?");
    if (!seal) return seal.error();
    seal->bind(0, sealOver(facts_, rows));
    seal->bind(1, std::string(sealKey));
    if (!isDone(*seal)) return Error{database_.lastError()};
    return database_.run("COMMIT");
  }();
  if (written) {
    rows_ = rows;
    count_ += block.size();
    return written;
  }
  const std::string reason = written.error().message;
  static_cast<void>(database_.run("ROLLBACK"));
  return Error{"%1 takes no more %2: %3. Those before are kept; make space and run it again.",
               file_, kind_->results, reason};
}

Result<void> InsertionTable::close()
{
  if (const auto done = database_.run("PRAGMA journal_mode=DELETE"); !done)
    return Error{"%1 cannot be closed: %2.", file_, done.error().message};
  return {};
}

}  // namespace perilymph::session

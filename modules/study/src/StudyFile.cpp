// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/study/StudyFile.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "StudyViews.h"
#include "perilymph/foundation/Unfinished.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::study {

namespace {

namespace fs = std::filesystem;
using database::Database;
using database::Statement;

const database::FileKind& studyKind()
{
  static const database::FileKind kind = {
      "a study of Perilymph",
      "Choose a .sqlite file that 'perilymph-cli study' wrote.",
      "Delete it and run its shard again.",
      0x50655374,  // "PeSt"
      2,           // 1 had no views
      {"CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL)",
       "CREATE TABLE insertion(number INTEGER PRIMARY KEY, cochlea TEXT NOT NULL, settings TEXT "
       "NOT "
       "NULL, ending TEXT NOT NULL, reason TEXT NOT NULL, A_mm REAL NOT NULL, B_mm REAL NOT NULL, "
       "st_length_mm REAL NOT NULL, depth_mm REAL NOT NULL, max_depth_mm REAL NOT NULL, angle_deg "
       "REAL NOT NULL, "
       "coverage_percent REAL NOT NULL, peak_mN REAL NOT NULL, peak_depth_mm REAL NOT NULL, end_mN "
       "REAL NOT NULL, partition_mN REAL NOT NULL, ticks INTEGER NOT NULL, ticks_not_converged "
       "INTEGER NOT NULL)",
       "CREATE TABLE profile(number INTEGER NOT NULL, depth_mm REAL NOT NULL, force_mN REAL NOT "
       "NULL, PRIMARY KEY(number, depth_mm)) WITHOUT ROWID",
       "CREATE TABLE contact(number INTEGER NOT NULL, contact INTEGER NOT NULL, is_inserted "
       "INTEGER "
       "NOT NULL, angle_deg REAL NOT NULL, depth_mm REAL NOT NULL, to_modiolus_mm REAL NOT NULL, "
       "frequency_Hz REAL NOT NULL, PRIMARY KEY(number, contact)) WITHOUT ROWID"},
      studyViews()};
  return kind;
}

/// The end of a name; nothing for a name that none has.
std::optional<analysis::InsertionEnd> endNamed(const std::string& name)
{
  const analysis::InsertionEnd end = haptics::endNamed(name);
  if (end == analysis::InsertionEnd::none && name != haptics::nameOf(end)) return std::nullopt;
  return end;
}

std::string jsonOf(const session::Overrides& settings)
{
  nlohmann::json json = nlohmann::json::object();
  for (const auto& [key, value] : settings) json[key] = value;
  return json.dump();
}

/// Settings of their JSON text; nothing for any other text.
std::optional<session::Overrides> settingsIn(const std::string& text)
{
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  session::Overrides settings;
  for (const auto& [key, value] : json.items()) {
    if (!value.is_string()) return std::nullopt;
    settings.emplace_back(key, value.get<std::string>());
  }
  return settings;
}

std::map<std::string, std::string> rowsOf(const StudyFileFacts& facts)
{
  return {{"title", facts.title},
          {"study", facts.text},
          {"fingerprint", facts.fingerprint},
          {"program", facts.program},
          {"cases", std::to_string(facts.cases)},
          {"first", std::to_string(facts.first)},
          {"end", std::to_string(facts.end)}};
}

/// Runs a statement that returns no row.
bool isDone(Statement& statement)
{
  const bool done = statement.step() == Statement::Step::done;
  statement.reset();
  return done;
}

bool addContacts(Statement& insert, const StudyResult& result)
{
  for (const analysis::ContactPosition& contact : result.insertion.contacts) {
    insert.bind(0, static_cast<std::int64_t>(result.number));
    insert.bind(1, static_cast<std::int64_t>(contact.number));
    insert.bind(2, static_cast<std::int64_t>(contact.isInserted ? 1 : 0));
    insert.bind(3, inDegrees(contact.angle));
    insert.bind(4, inMillimeters(contact.depth));
    insert.bind(5, inMillimeters(contact.toModiolus));
    insert.bind(6, contact.frequency_Hz);
    if (!isDone(insert)) return false;
  }
  return true;
}

bool addProfile(Statement& insert, const StudyResult& result)
{
  for (const analysis::DepthForce& point : result.insertion.profile) {
    insert.bind(0, static_cast<std::int64_t>(result.number));
    insert.bind(1, inMillimeters(point.depth));
    insert.bind(2, inMillinewtons(point.force));
    if (!isDone(insert)) return false;
  }
  return true;
}

bool addInsertion(Statement& insert, const StudyResult& result)
{
  const analysis::FullInsertion& found = result.insertion;
  insert.bind(0, static_cast<std::int64_t>(result.number));
  insert.bind(1, result.cochlea);
  insert.bind(2, jsonOf(result.settings));
  insert.bind(3, std::string(haptics::nameOf(found.end)));
  insert.bind(4, found.reason);
  const double numbers[] = {result.a_mm,
                            result.b_mm,
                            result.scalaLength_mm,
                            inMillimeters(found.depth),
                            inMillimeters(found.maxDepth),
                            inDegrees(found.apical),
                            100.0 * found.coverage,
                            inMillinewtons(found.peak.force),
                            inMillimeters(found.peak.depth),
                            inMillinewtons(found.endForce),
                            inMillinewtons(found.maxMembraneForce)};
  int place = 5;
  for (const double number : numbers) insert.bind(place++, number);
  insert.bind(place++, static_cast<std::int64_t>(found.ticks));
  insert.bind(place, static_cast<std::int64_t>(found.ticksNotConverged));
  return isDone(insert);
}

}  // namespace

StudyFileFacts factsOf(const Study& study, std::size_t first, std::size_t end)
{
  return {study.title(), study.text(), study.fingerprint(), buildId(), study.size(), first, end};
}

Result<StudyFile> StudyFile::create(const fs::path& file, const StudyFileFacts& facts)
{
  const auto failed = [&file](const std::string& reason) {
    return Error{file.string() + " cannot be created: " + reason +
                 ". Check the folder's permissions and the space on the disk."};
  };
  // Written under another name first: a file with the final name is whole or does not exist.
  const std::string unfinished = unfinishedPath(file).string();
  const int descriptor =
      ::open(unfinished.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor < 0) return failed("its folder takes no file");
  ::close(descriptor);
  const auto written = [&]() -> Result<Done> {
    auto opened = Database::openNew(unfinished);
    if (!opened) return opened.error();
    if (const auto done = opened->run(database::creationOf(studyKind())); !done) return done;
    auto insert = opened->prepare("INSERT INTO meta VALUES(?,?)");
    if (!insert) return insert.error();
    for (const auto& [key, value] : rowsOf(facts)) {
      insert->bind(0, key);
      insert->bind(1, value);
      if (!isDone(*insert)) return Error{opened->lastError()};
    }
    return opened->run("COMMIT");
  }();
  const bool isLinked = written && ::link(unfinished.c_str(), file.c_str()) == 0;
  std::error_code ignored;
  fs::remove(unfinished, ignored);
  if (!written) return failed(written.error().message);
  if (!isLinked) return failed("there is one already, or its file system has no hard links");
  return resume(file);
}

Result<StudyFile> StudyFile::resume(const fs::path& file)
{
  auto opened = Database::openToAppend(file, studyKind());
  if (!opened) return opened.error();
  StudyFile study(*std::move(opened));
  study.file_ = file;
  // A commit survives the end of the process and of the machine.
  if (const auto done = study.database_.run("PRAGMA journal_mode=WAL; PRAGMA synchronous=FULL");
      !done)
    return Error{file.string() + " cannot be continued: " + done.error().message + "."};
  if (const auto done = study.readFacts(); !done) return done.error();
  return study;
}

Result<StudyFile> StudyFile::open(const fs::path& file)
{
  auto opened = Database::open(file, studyKind());
  if (!opened) return opened.error();
  StudyFile study(*std::move(opened));
  study.file_ = file;
  if (const auto done = study.readFacts(); !done) return done.error();
  return study;
}

Result<Done> StudyFile::readFacts()
{
  auto rows = database_.prepare("SELECT key, value FROM meta");
  if (!rows) return database_.readingError(rows.error().message);
  std::map<std::string, std::string> found;
  Statement::Step step = rows->step();
  for (; step == Statement::Step::row; step = rows->step()) found[rows->text(0)] = rows->text(1);
  if (step == Statement::Step::failed) return database_.readingError(database_.lastError());
  const auto count = [&found](const char* key) {
    const std::string& text = found[key];
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size() ? std::optional(number)
                                                                    : std::nullopt;
  };
  const auto cases = count("cases"), first = count("first"), end = count("end");
  if (!cases || !first || !end || *first > *end || *end > *cases || *cases > maxCases)
    return database_.readingError("it does not say which insertions it is for");
  facts_ = {
      found["title"], found["study"], found["fingerprint"], found["program"], *cases, *first, *end};
  return Done{};
}

Result<std::size_t> StudyFile::size() const
{
  // Not count(*): of a damaged file it would not end.
  auto rows = database_.prepare("SELECT number FROM insertion ORDER BY number");
  if (!rows) return database_.readingError(rows.error().message);
  std::size_t count = 0;
  Statement::Step step = rows->step();
  for (; step == Statement::Step::row; step = rows->step())
    if (rows->integer(0) != static_cast<std::int64_t>(facts_.first + count++) ||
        facts_.first + count > facts_.end)
      return database_.readingError("its insertions are not consecutive");
  if (step == Statement::Step::failed) return database_.readingError(database_.lastError());
  return count;
}

Result<Done> StudyFile::append(const std::vector<StudyResult>& results)
{
  auto insertion =
      database_.prepare("INSERT INTO insertion VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
  auto profile = database_.prepare("INSERT INTO profile VALUES(?,?,?)");
  auto contact = database_.prepare("INSERT INTO contact VALUES(?,?,?,?,?,?,?)");
  std::string reason;
  if (insertion && profile && contact && database_.run("BEGIN")) {
    const bool isWritten =
        std::all_of(results.begin(), results.end(), [&](const StudyResult& each) {
          return addInsertion(*insertion, each) && addProfile(*profile, each) &&
                 addContacts(*contact, each);
        });
    if (!isWritten) reason = database_.lastError();
    if (isWritten) {
      const auto done = database_.run("COMMIT");
      if (done) return Done{};
      reason = done.error().message;
    }
    static_cast<void>(database_.run("ROLLBACK"));
  } else {
    reason = database_.lastError();
  }
  return Error{file_.string() + " takes no more results: " + reason +
               ". Those before are kept; make space and run it again."};
}

Result<Done> StudyFile::close()
{
  if (const auto done = database_.run("PRAGMA journal_mode=DELETE"); !done)
    return Error{file_.string() + " cannot be closed: " + done.error().message + "."};
  return Done{};
}

Result<Done> StudyFile::read(const std::function<Result<Done>(const StudyResult&)>& each,
                             Part part) const
{
  auto rows = database_.prepare("SELECT * FROM insertion ORDER BY number");
  auto profiles =
      database_.prepare("SELECT number, depth_mm, force_mN FROM profile ORDER BY number, depth_mm");
  auto contacts = database_.prepare("SELECT * FROM contact ORDER BY number, contact");
  if (!rows || !profiles || !contacts) return database_.readingError(database_.lastError());
  const bool isWhole = part == Part::whole;
  Statement::Step profile = isWhole ? profiles->step() : Statement::Step::done;
  Statement::Step contact = isWhole ? contacts->step() : Statement::Step::done;
  Statement::Step step = rows->step();
  std::size_t next = facts_.first;
  for (; step == Statement::Step::row; step = rows->step()) {
    StudyResult result;
    const std::int64_t number = rows->integer(0);
    if (number != static_cast<std::int64_t>(next++) || next > facts_.end)
      return database_.readingError("its insertions are not consecutive");
    result.number = static_cast<std::size_t>(number);
    result.cochlea = rows->text(1);
    const auto settings = settingsIn(rows->text(2));
    const auto end = endNamed(rows->text(3));
    if (!settings || !end)
      return database_.readingError("insertion " + std::to_string(number) + " is not readable");
    result.settings = *settings;
    analysis::FullInsertion& found = result.insertion;
    found.end = *end;
    found.reason = rows->text(4);
    result.a_mm = rows->real(5);
    result.b_mm = rows->real(6);
    result.scalaLength_mm = rows->real(7);
    found.depth = millimeters(rows->real(8));
    found.maxDepth = millimeters(rows->real(9));
    found.apical = degrees(rows->real(10));
    found.coverage = rows->real(11) / 100.0;
    found.peak = {millimeters(rows->real(13)), millinewtons(rows->real(12))};
    found.endForce = millinewtons(rows->real(14));
    found.maxMembraneForce = millinewtons(rows->real(15));
    found.ticks = static_cast<std::uint64_t>(rows->integer(16));
    found.ticksNotConverged = static_cast<std::uint64_t>(rows->integer(17));
    for (; profile == Statement::Step::row && profiles->integer(0) <= number;
         profile = profiles->step())
      if (profiles->integer(0) == number)
        found.profile.push_back({millimeters(profiles->real(1)), millinewtons(profiles->real(2))});
    for (; contact == Statement::Step::row && contacts->integer(0) <= number;
         contact = contacts->step()) {
      if (contacts->integer(0) != number) continue;
      analysis::ContactPosition position;
      position.number = static_cast<int>(contacts->integer(1));
      position.isInserted = contacts->integer(2) != 0;
      position.angle = degrees(contacts->real(3));
      position.depth = millimeters(contacts->real(4));
      position.toModiolus = millimeters(contacts->real(5));
      position.frequency_Hz = contacts->real(6);
      found.contacts.push_back(position);
    }
    if (const auto done = each(result); !done) return done;
  }
  if (step == Statement::Step::failed) return database_.readingError(database_.lastError());
  return Done{};
}

}  // namespace perilymph::study

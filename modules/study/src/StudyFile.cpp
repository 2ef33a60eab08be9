// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/study/StudyFile.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "StudyViews.h"
#include "perilymph/analysis/PhysicalRanges.h"
#include "perilymph/anatomy/DuctLength.h"
#include "perilymph/foundation/Choice.h"
#include "perilymph/foundation/Utf8.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::study {

namespace {

namespace fs = std::filesystem;
namespace physical = analysis::physical;
using session::InsertionRows;
using session::Row;

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

constexpr const char* notesFact = "notes";
constexpr const char* filesFact = "files";

/// Values of files as JSON: a list of four texts each.
std::string jsonOf(const std::vector<StudyFileValue>& values)
{
  nlohmann::json json = nlohmann::json::array();
  for (const StudyFileValue& each : values)
    json.push_back({each.key, each.value, each.name, each.content});
  return json.dump();
}

/// The same of their JSON text; nothing for any other text.
std::optional<std::vector<StudyFileValue>> fileValuesIn(const std::string& text)
{
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_array()) return std::nullopt;
  std::vector<StudyFileValue> values;
  for (const auto& row : json) {
    constexpr std::size_t fields = 4;
    const auto isText = [](const auto& each) { return each.is_string(); };
    if (!row.is_array() || row.size() != fields || !std::ranges::all_of(row, isText))
      return std::nullopt;
    const auto field = [&row](std::size_t i) { return row[i].template get<std::string>(); };
    values.push_back({field(0), field(1), field(2), field(3)});
  }
  return values;
}

SealedFacts sealedOf(const StudyFileFacts& facts)
{
  SealedFacts sealed = {{"title", facts.title},
                        {"study", facts.text},
                        {session::fingerprintFact, facts.fingerprint},
                        {session::programFact, facts.program},
                        {"cases", std::to_string(facts.cases)},
                        {"first", std::to_string(facts.first)},
                        {"end", std::to_string(facts.end)}};
  for (const std::string& note : facts.notes) sealed[notesFact] += note + '\n';
  if (!facts.fileValues.empty()) sealed[filesFact] = jsonOf(facts.fileValues);
  return sealed;
}

/// The facts of a file; nothing if it does not say which insertions it is for.
std::optional<StudyFileFacts> factsIn(SealedFacts found)
{
  const auto count = [&found](const char* key) {
    const std::string& text = found[key];
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size() ? std::optional(number)
                                                                    : std::nullopt;
  };
  const auto cases = count("cases"), first = count("first"), end = count("end");
  if (!cases || !first || !end || *first > *end || *end > *cases || *cases > maxCases)
    return std::nullopt;
  StudyFileFacts facts{onOneLine(found["title"]),
                       found["study"],
                       found[session::fingerprintFact],
                       found[session::programFact],
                       *cases,
                       *first,
                       *end};
  std::istringstream notes(found[notesFact]);
  for (std::string note; std::getline(notes, note);) facts.notes.push_back(onOneLine(note));
  if (const std::string& files = found[filesFact]; !files.empty()) {
    auto values = fileValuesIn(files);
    if (!values) return std::nullopt;
    facts.fileValues = *std::move(values);
  }
  return facts;
}

InsertionRows rowsOf(const StudyResult& result)
{
  const analysis::InsertionRun& found = result.insertion;
  const auto number = static_cast<std::int64_t>(result.number);
  InsertionRows rows{
      {number, result.cochlea, jsonOf(result.settings), std::string(haptics::nameOf(found.end)),
       found.reason, result.a_mm, result.b_mm, result.scalaLength_mm, inMillimeters(found.depth),
       inMillimeters(found.maxDepth), inDegrees(found.apical), 100.0 * found.coverage,
       inMillinewtons(found.peak.force), inMillimeters(found.peak.depth),
       inMillinewtons(found.endForce), inMillinewtons(found.partition),
       static_cast<std::int64_t>(found.ticks), static_cast<std::int64_t>(found.ticksNotConverged)},
      {{}, {}}};
  for (const analysis::DepthForce& point : found.profile)
    rows.others[0].push_back({number, inMillimeters(point.depth), inMillinewtons(point.force)});
  for (const analysis::ContactPosition& contact : found.contacts)
    rows.others[1].push_back({number, static_cast<std::int64_t>(contact.number),
                              static_cast<std::int64_t>(contact.isInserted ? 1 : 0),
                              inDegrees(contact.angle), inMillimeters(contact.depth),
                              inMillimeters(contact.toModiolus), contact.frequency_Hz});
  return rows;
}

/// Reads the cells of a row in their order; their types are those of the table.
class Cells {
public:
  explicit Cells(const Row& row) : row_(row) {}
  std::int64_t whole() { return std::get<std::int64_t>(row_[next_++]); }
  double real() { return std::get<double>(row_[next_++]); }
  const std::string& text() { return std::get<std::string>(row_[next_++]); }

private:
  const Row& row_;
  std::size_t next_ = 0;
};

/// The contacts of an insertion; an error if one is neither inserted nor not.
Result<std::vector<analysis::ContactPosition>> contactsIn(const std::vector<Row>& rows)
{
  static constexpr std::array inserted{std::int64_t{0}, std::int64_t{1}};
  std::vector<analysis::ContactPosition> contacts;
  for (const Row& row : rows) {
    Cells cells(row);
    cells.whole();  // the insertion's
    analysis::ContactPosition contact;
    contact.number = static_cast<int>(cells.whole());
    const std::int64_t isInserted = cells.whole();
    if (isInserted != inserted[0] && isInserted != inserted[1])
      return Error{"is_inserted is %1; it must be 0 or 1", isInserted};
    contact.isInserted = isInserted == inserted[1];
    contact.angle = degrees(cells.real());
    contact.depth = millimeters(cells.real());
    contact.toModiolus = millimeters(cells.real());
    contact.frequency_Hz = cells.real();
    contacts.push_back(contact);
  }
  return contacts;
}

/// Why the cochlea of an insertion is impossible; empty if it is not, or was not built.
std::string impossibleCochlea(const StudyResult& result)
{
  if (result.a_mm == 0.0 && result.b_mm == 0.0 && result.scalaLength_mm == 0.0) return {};
  for (const auto& [name, value, range] :
       {std::tuple{"A", result.a_mm, physical::a_mm}, std::tuple{"B", result.b_mm, physical::b_mm},
        std::tuple{"the length of the scala", result.scalaLength_mm, physical::scalaLength_mm}})
    if (auto reason = analysis::impossibility(name, "mm", value, range); !reason.empty())
      return reason;
  return {};
}

Result<StudyResult> resultIn(const InsertionRows& rows)
{
  StudyResult result;
  Cells cells(rows.row);
  result.number = static_cast<std::size_t>(cells.whole());
  result.cochlea = cells.text();
  const auto settings = settingsIn(cells.text());
  const auto end = endNamed(cells.text());
  if (!settings || !end) return Error{"its settings or its ending cannot be read"};
  result.settings = *settings;
  analysis::InsertionRun& found = result.insertion;
  found.end = *end;
  found.reason = cells.text();
  result.a_mm = cells.real();
  result.b_mm = cells.real();
  result.scalaLength_mm = cells.real();
  found.depth = millimeters(cells.real());
  found.maxDepth = millimeters(cells.real());
  found.apical = degrees(cells.real());
  found.coverage = cells.real() / 100.0;
  found.peak.force = millinewtons(cells.real());
  found.peak.depth = millimeters(cells.real());
  found.endForce = millinewtons(cells.real());
  found.partition = millinewtons(cells.real());
  const std::int64_t ticks = cells.whole(), notConverged = cells.whole();
  if (ticks < 0 || notConverged < 0) return Error{"its ticks are fewer than none"};
  found.ticks = static_cast<std::uint64_t>(ticks);
  found.ticksNotConverged = static_cast<std::uint64_t>(notConverged);
  for (const Row& row : rows.others[0])
    found.profile.push_back(
        {millimeters(std::get<double>(row[1])), millinewtons(std::get<double>(row[2]))});
  auto contacts = contactsIn(rows.others[1]);
  if (!contacts) return contacts.error();
  found.contacts = *std::move(contacts);
  for (auto& reason : {impossibleCochlea(result), analysis::impossibility(found)})
    if (!reason.empty()) return Error{reason};
  return result;
}

const session::InsertionTableKind& studyKind()
{
  static const session::InsertionTableKind kind = {
      {Sentence{"a study of Perilymph"},
       Sentence{"Choose a .sqlite file that 'perilymph-cli study' wrote."},
       Sentence{"Delete it and run its shard again."},
       0x50655374,  // "PeSt"
       5,           // 1 had no views, 2 no seal, 3 former views, 4 nothing of files
       {"CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL)",
        "CREATE TABLE insertion(number INTEGER PRIMARY KEY, cochlea TEXT NOT NULL, settings TEXT "
        "NOT "
        "NULL, ending TEXT NOT NULL, reason TEXT NOT NULL, A_mm REAL NOT NULL, B_mm REAL NOT NULL, "
        "st_length_mm REAL NOT NULL, depth_mm REAL NOT NULL, max_depth_mm REAL NOT NULL, angle_deg "
        "REAL NOT NULL, "
        "coverage_percent REAL NOT NULL, peak_mN REAL NOT NULL, peak_depth_mm REAL NOT NULL, "
        "end_mN "
        "REAL NOT NULL, partition_mN REAL NOT NULL, ticks INTEGER NOT NULL, ticks_not_converged "
        "INTEGER NOT NULL)",
        "CREATE TABLE profile(number INTEGER NOT NULL, depth_mm REAL NOT NULL, force_mN REAL NOT "
        "NULL, PRIMARY KEY(number, depth_mm)) WITHOUT ROWID",
        "CREATE TABLE contact(number INTEGER NOT NULL, contact INTEGER NOT NULL, is_inserted "
        "INTEGER "
        "NOT NULL, angle_deg REAL NOT NULL, depth_mm REAL NOT NULL, to_modiolus_mm REAL NOT NULL, "
        "frequency_Hz REAL NOT NULL, PRIMARY KEY(number, contact)) WITHOUT ROWID"},
       studyViews(),
       formerStudyViews(),
       1,
       {},
       session::lastingRows("insertion", "number")},
      3,
      {{"insertion",
        "itttt"
        "rrrrrrrrrrr"
        "ii"},
       {"profile", "irr", 2},
       {"contact", "iiirrrr", 2}},
      "belongs to another study, or this one or a file it names was changed since.",
      "results"};
  return kind;
}

}  // namespace

StudyFileFacts factsOf(const Study& study, std::size_t first, std::size_t end)
{
  return {study.title(), study.text(), study.fingerprint(), buildId(),         study.size(),
          first,         end,          study.notes(),       study.fileValues()};
}

Result<StudyFile> StudyFile::openToContinue(const fs::path& file, const StudyFileFacts& facts)
{
  auto table = session::InsertionTable::openToContinue(file, studyKind(), sealedOf(facts));
  if (!table) return table.error();
  StudyFile opened(*std::move(table), facts);
  if (const auto done = opened.read([](const StudyResult&) -> Result<void> { return {}; }); !done)
    return done.error();
  return opened;
}

Result<StudyFile> StudyFile::open(const fs::path& file)
{
  auto table = session::InsertionTable::open(file, studyKind());
  if (!table) return table.error();
  auto facts = factsIn(table->facts());
  if (!facts) return table->damaged(Sentence{"it does not say which insertions it is for"});
  facts->seal = table->seal();
  if (facts->seal == Seal::changed) facts->fingerprint.clear();
  return StudyFile(*std::move(table), *std::move(facts));
}

Result<std::pair<StudyFileFacts, std::size_t>> StudyFile::outlineOf(const fs::path& file)
{
  auto outline = session::InsertionTable::outlineOf(file, studyKind());
  if (!outline) return outline.error();
  auto facts = factsIn(outline->facts);
  if (!facts || outline->count > facts->end - facts->first)
    return Error{"%1 does not say which insertions it is for. Delete it and run its shard again.",
                 file};
  return std::pair{*std::move(facts), outline->count};
}

Result<void> StudyFile::append(const std::vector<StudyResult>& results)
{
  std::vector<InsertionRows> rows;
  rows.reserve(results.size());
  for (const StudyResult& each : results) rows.push_back(rowsOf(each));
  return table_.append(rows);
}

Result<void> StudyFile::read(const std::function<Result<void>(const StudyResult&)>& each) const
{
  std::size_t next = facts_.first;
  return table_.read([&](const InsertionRows& rows) -> Result<void> {
    const auto result = resultIn(rows);
    if (!result)
      return table_.damaged(Sentence{"insertion %1 is not readable: %2",
                                     std::get<std::int64_t>(rows.row[0]), result.error().message});
    if (result->number != next++ || next > facts_.end)
      return table_.damaged(Sentence{"its insertions are not consecutive"});
    return each(*result);
  });
}

double StudyResult::ductLength_mm() const
{
  if (!(a_mm > 0.0 && b_mm > 0.0)) return 0.0;
  return inMillimeters(anatomy::ellipticCircularDuctLength(millimeters(a_mm), millimeters(b_mm)));
}

}  // namespace perilymph::study

// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/PatientRecord.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Unfinished.h"

namespace perilymph::session {

namespace {

namespace fs = std::filesystem;

constexpr int recordFormat = 1;
constexpr const char* exportedPatient = "patient.toml";
constexpr const char* exportedRecord = "record.json";
constexpr const char* exportedInsertions = "insertions";
constexpr std::size_t maxRecordBytes = std::size_t{64} << 10;
constexpr std::size_t maxInsertions = 10'000;
constexpr std::size_t blockBytes = std::size_t{1} << 20;  // copied between two looks at the caller

std::string textOf(const PatientRecord& record)
{
  nlohmann::ordered_json json = {{"format", recordFormat},
                                 {"tags", record.tags},
                                 {"notes", record.notes},
                                 {"archived", record.isArchived}};
  for (const PatientScan& scan : record.scans)
    json["scans"].push_back({{"series_sha256", scan.series}, {"saved_utc", scan.savedUtc}});
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

/// A hash or its beginning.
bool isSeries(const std::string& text)
{
  constexpr std::size_t maxDigits = 64;  // SHA-256
  return !text.empty() && text.size() <= maxDigits &&
         text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

/// "2026-11-20T09:30:00Z"
bool isDate(const std::string& text)
{
  constexpr std::string_view form = "dddd-dd-ddTdd:dd:ddZ";
  return std::equal(text.begin(), text.end(), form.begin(), form.end(), [](char c, char expected) {
    return expected == 'd' ? c >= '0' && c <= '9' : c == expected;
  });
}

Result<PatientRecord> readRecord(const fs::path& file)
{
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return PatientRecord{};
  const auto text = readWhole(file, maxRecordBytes);
  if (!text) return text.error();
  PatientRecord record;
  try {
    const auto json = nlohmann::json::parse(*text);
    // A number beyond an int is of no program: as a double it is still greater.
    if (json.at("format").get<double>() > recordFormat)
      return Error{file.string() + " is of a newer program. Open it with that one."};
    record.tags = json.at("tags").get<std::vector<std::string>>();
    record.notes = json.at("notes").get<std::string>();
    record.isArchived = json.at("archived").get<bool>();
    for (const auto& scan : json.value("scans", nlohmann::json::array()))
      record.scans.push_back(
          {scan.at("series_sha256").get<std::string>(), scan.at("saved_utc").get<std::string>()});
  } catch (const nlohmann::json::exception&) {
    return Error{file.string() +
                 " is not the record of a patient: it needs format, tags, notes and archived. "
                 "Restore it from a backup, or remove it."};
  }
  if (const auto possible = checkRecord(record); !possible)
    return Error{file.string() + ": " + possible.error().message};
  return record;
}

/// Copies files one after the other, and stops where its caller asks for it.
class Copying {
public:
  Copying(const std::vector<fs::path>& files, const CopyProgress& progress) : progress_(progress)
  {
    std::error_code ignored;
    for (const fs::path& file : files) {
      const std::uintmax_t bytes = fs::file_size(file, ignored);
      if (!ignored) all_ += bytes;
    }
  }

  /// Copies a file to a name that does not exist, for its owner only.
  Result<Done> copy(const fs::path& from, const fs::path& to)
  {
    const auto written =
        writeWhole(to, [&](const fs::path& place) { return copyContent(from, place); },
                   {Links::refused, Audience::owner, Existing::refused});
    if (isCanceled_) return Error{"The copy was canceled; nothing of it was kept."};
    return written;
  }

private:
  bool copyContent(const fs::path& from, const fs::path& to)
  {
    std::ifstream source(from, std::ios::binary);
    std::ofstream copy(to, std::ios::binary);
    std::vector<char> block(blockBytes);
    while (source && copy) {
      isCanceled_ = progress_ && !progress_(done_, all_);
      if (isCanceled_) return false;
      source.read(block.data(), static_cast<std::streamsize>(block.size()));
      copy.write(block.data(), source.gcount());
      done_ += static_cast<std::uintmax_t>(source.gcount());
    }
    return source.eof() && copy.flush();
  }

  const CopyProgress& progress_;
  std::uintmax_t done_ = 0, all_ = 0;
  bool isCanceled_ = false;
};

/// Recordings in an exported folder.
Result<std::vector<fs::path>> insertionsIn(const fs::path& folder)
{
  std::vector<fs::path> found;
  std::error_code failure;
  fs::directory_iterator entries(folder / exportedInsertions, failure);
  if (failure) return found;  // none was exported
  for (const fs::directory_entry& entry : entries) {
    if (entry.is_symlink(failure) || !entry.is_regular_file(failure) ||
        entry.path().extension() != ".insertion")
      return Error{entry.path().string() +
                   " is not a recording; an exported patient has nothing else there. Remove it."};
    found.push_back(entry.path());
    if (found.size() > maxInsertions)
      return Error{folder.string() + " holds more than 10000 recordings. Remove some."};
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

Result<Done> checkRecord(const PatientRecord& record)
{
  if (record.notes.size() > maxNotes)
    return Error{"Notes have " + std::to_string(record.notes.size()) +
                 " characters; at most 4000 are kept. Shorten them."};
  if (record.tags.size() > maxTags)
    return Error{"There are " + std::to_string(record.tags.size()) +
                 " tags; at most 16 are kept. Remove some."};
  if (record.scans.size() > maxScans)
    return Error{"There are " + std::to_string(record.scans.size()) +
                 " scans; at most 64 are kept. Remove some."};
  for (const PatientScan& scan : record.scans)
    if (!isSeries(scan.series) || !isDate(scan.savedUtc))
      return Error{"The scan \"" + scan.series + "\" of \"" + scan.savedUtc +
                   "\" is not possible: it has up to 64 hexadecimal digits and a date like "
                   "2026-11-20T09:30:00Z. Correct or remove it."};
  std::set<std::string> seen;
  for (const std::string& tag : record.tags) {
    const bool isClean = std::none_of(tag.begin(), tag.end(), [](char c) {
      return c == ',' || static_cast<unsigned char>(c) < ' ';
    });
    if (tag.empty() || tag.size() > maxTag || !isClean)
      return Error{"The tag \"" + tag +
                   "\" is not possible: it has 1 to 24 characters and no comma. Change it."};
    if (!seen.insert(tag).second) return Error{"The tag \"" + tag + "\" stands twice. Remove one."};
  }
  return Done{};
}

fs::path recordFileOf(const fs::path& patient)
{
  return fs::path(patient).replace_extension(".json");
}

Result<PatientRecord> loadPatientRecord(const fs::path& patient)
{
  return readRecord(recordFileOf(patient));
}

Result<Done> savePatientRecord(const PatientRecord& record, const fs::path& patient)
{
  if (const auto possible = checkRecord(record); !possible) return possible;
  return writeWhole(recordFileOf(patient), textOf(record), {Links::followed, Audience::owner});
}

Result<Done> exportPatient(const fs::path& patient, const std::vector<fs::path>& insertions,
                           const fs::path& folder, const CopyProgress& progress)
{
  std::error_code failure;
  if (fs::exists(fs::symlink_status(folder, failure)))
    return Error{folder.string() + " exists. Give the name of a new folder."};
  const auto record = loadPatientRecord(patient);
  if (!record) return record.error();
  auto unfinished = UnfinishedFolder::create(folder);
  if (!unfinished) return unfinished.error();
  const fs::path& place = unfinished->path();
  Copying copying(insertions, progress);
  if (const auto done = copying.copy(patient, place / exportedPatient); !done) return done;
  if (const auto done =
          writeWhole(place / exportedRecord, textOf(*record), {Links::refused, Audience::owner});
      !done)
    return done;
  fs::create_directory(place / exportedInsertions, failure);
  for (const fs::path& each : insertions)
    if (const auto done = copying.copy(each, place / exportedInsertions / each.filename()); !done)
      return done;
  return unfinished->finish();
}

Result<fs::path> importPatient(const fs::path& folder, const fs::path& library,
                               const fs::path& recordings, const CopyProgress& progress)
{
  const auto patient = anatomy::loadPatient(folder / exportedPatient);
  if (!patient) return patient.error();
  if (const auto code = anatomy::checkPatientCode(patient->label); !code) return code.error();
  const auto record = readRecord(folder / exportedRecord);
  if (!record) return record.error();
  const auto insertions = insertionsIn(folder);
  if (!insertions) return insertions.error();

  const char* ear = patient->side == anatomy::Side::left ? "left" : "right";
  const fs::path file = library / (patient->label + "-" + ear + ".toml");
  std::error_code failure;
  if (fs::exists(file, failure))
    return Error{"The library has " + patient->label + ", " + ear +
                 " ear, already. Rename or remove that patient first."};
  for (const fs::path& each : *insertions)
    if (fs::exists(recordings / each.filename(), failure))
      return Error{(recordings / each.filename()).string() +
                   " exists; an import replaces no recording. Rename it first."};

  std::vector<fs::path> made;
  const auto written = [&]() -> Result<Done> {
    fs::create_directories(library, failure);
    fs::create_directories(recordings, failure);
    Copying copying(*insertions, progress);
    for (const fs::path& each : *insertions) {
      const fs::path copy = recordings / each.filename();
      if (const auto done = copying.copy(each, copy); !done) return done;
      made.push_back(copy);
    }
    made.push_back(recordFileOf(file));
    if (const auto done = savePatientRecord(*record, file); !done) return done;
    return anatomy::savePatient(*patient, file);
  }();
  if (written) return file;
  for (const fs::path& each : made) fs::remove(each, failure);
  return written.error();
}

}  // namespace perilymph::session

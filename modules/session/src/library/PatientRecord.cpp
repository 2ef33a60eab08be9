// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/session/PatientRecord.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <stop_token>
#include <string_view>
#include <utility>

#include "library/PatientRecordText.h"
#include "perilymph/anatomy/EarWords.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/FileLock.h"
#include "perilymph/foundation/Unfinished.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/session/RecordedInsertion.h"

namespace perilymph::session {

namespace {

namespace fs = std::filesystem;

constexpr const char* exportedPatient = "patient.toml";
constexpr const char* exportedRecord = "record.json";
constexpr const char* exportedInsertions = "insertions";
constexpr std::size_t maxRecordBytes = std::size_t{4} << 20;
constexpr std::size_t maxInsertions = 10'000;
constexpr std::size_t blockBytes = std::size_t{1} << 20;  // copied between two looks at the caller

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
  return recordIn(*text, file.string());
}

/// Held while a patient's files are read and replaced.
Result<FileLock> lockPatient(const fs::path& patient)
{
  return FileLock::take(patient.parent_path() / ("." + patient.stem().string() + ".lock"),
                        patient.string());
}

/// Whether a list begins with all entries of another one.
template <class Entry>
bool continues(const std::vector<Entry>& longer, const std::vector<Entry>& shorter)
{
  return longer.size() >= shorter.size() &&
         std::equal(shorter.begin(), shorter.end(), longer.begin());
}

/// Replaces a record by one that was made of it. The patient is locked.
Result<PatientRecord> replaceRecord(const PatientRecord& record, const PatientRecord& before,
                                    const fs::path& patient)
{
  if (const auto possible = checkRecord(record); !possible) return possible.error();
  if (!continues(record.versions, before.versions) || !continues(record.plans, before.plans) ||
      !continues(record.insertions, before.insertions) ||
      !continues(record.outcomes, before.outcomes))
    return Error{
        "%1 is not replaced: versions, plans, insertions or outcomes in it would be lost. Read it "
        "again.",
        recordFileOf(patient).string()};
  PatientRecord kept = record;
  kept.isChangedByHand = record.isChangedByHand || before.isChangedByHand;
  const std::string text = textOf(kept);
  if (text.size() > maxRecordBytes)
    return Error{"%1 would be larger than 4 MiB. Shorten the notes or remove scans.",
                 recordFileOf(patient).string()};
  if (const auto done = writeWhole(recordFileOf(patient), text, {Links::followed, Audience::owner});
      !done)
    return done.error();
  return recordIn(text, recordFileOf(patient).string());
}

/// Copies files one after the other, and stops where its caller asks for it.
class Copying {
public:
  Copying(const std::vector<fs::path>& files, const CopyProgress& progress,
          const std::stop_token& stop)
      : progress_(progress), stop_(stop)
  {
    std::error_code ignored;
    for (const fs::path& file : files) {
      const std::uintmax_t bytes = fs::file_size(file, ignored);
      if (!ignored) all_ += bytes;
    }
  }

  /// Copies a file to a name that does not exist, for its owner only.
  Result<void> copy(const fs::path& from, const fs::path& to)
  {
    const auto written =
        writeWhole(to, [&](const fs::path& place) { return copyContent(from, place); },
                   {Links::refused, Audience::owner, Existing::refused});
    if (stop_.stop_requested()) return Error{"The copy was canceled; nothing of it was kept."};
    return written;
  }

private:
  bool copyContent(const fs::path& from, const fs::path& to)
  {
    std::ifstream source(from, std::ios::binary);
    std::ofstream copy(to, std::ios::binary);
    std::vector<char> block(blockBytes);
    while (source && copy) {
      if (progress_) progress_(done_, all_);
      if (stop_.stop_requested()) return false;
      source.read(block.data(), static_cast<std::streamsize>(block.size()));
      copy.write(block.data(), source.gcount());
      done_ += static_cast<std::uintmax_t>(source.gcount());
    }
    return source.eof() && copy.flush();
  }

  const CopyProgress& progress_;
  const std::stop_token& stop_;
  std::uintmax_t done_ = 0, all_ = 0;
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
      return Error{"%1 is not a recording; an exported patient has nothing else there. Remove it.",
                   entry.path()};
    if (const auto opened = RecordedInsertion::open(entry.path()); !opened)
      return Error{"%1 cannot be imported: %2", entry.path(), opened.error().message};
    found.push_back(entry.path());
    if (found.size() > maxInsertions)
      return Error{"%1 holds more than 10000 recordings. Remove some.", folder};
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Checks what format 2 has beyond format 1.
Result<void> checkLists(const PatientRecord& record)
{
  if (record.versions.size() > maxVersions ||
      std::max({record.plans.size(), record.insertions.size(), record.outcomes.size()}) >
          maxEntries)
    return Error{"A record keeps at most 256 versions and 10000 plans, insertions and outcomes."};
  constexpr double largest_mm = 1e4;  // of a position in a scanner
  for (const PatientVersion& version : record.versions) {
    if (!version.savedUtc.empty() && !isDate(version.savedUtc))
      return Error{"A version was saved at \"%1\", which is no date like 2026-11-20T09:30:00Z.",
                   version.savedUtc};
    if (const auto patient = anatomy::patientIn(version.patient, "A version"); !patient)
      return patient.error();
    for (const PatientLandmark& each : version.landmarks)
      for (const double place_mm : each.lps_mm)
        if (!(std::fabs(place_mm) <= largest_mm))
          return Error{"The landmark %1 lies beyond any scanner. Correct it.", each.name};
  }
  for (const PatientOutcome& each : record.outcomes)
    if (!isSeries(each.series) || !isDate(each.utc))
      return Error{"An outcome of the series \"%1\" has no hash or no date.", each.series};
  return {};
}

Result<void> checkAllMarkups(const PatientRecord& record)
{
  if (record.markups.size() > maxScans)
    return Error{"There are markups of %1 scans; those of %2 are kept at most. Remove some.",
                 record.markups.size(), maxScans};
  std::set<std::string> seen;
  for (const ct::CtMarkups& each : record.markups) {
    if (const auto possible = ct::checkMarkups(each); !possible) return possible;
    if (!seen.insert(each.seriesKey).second)
      return Error{"Markups of the CT series %1 stand twice. Remove one of the lists.",
                   each.seriesKey};
  }
  return {};
}

}  // namespace

Result<void> checkRecord(const PatientRecord& record)
{
  if (record.notes.size() > maxNotes)
    return Error{"Notes have %1 characters; at most 4000 are kept. Shorten them.",
                 record.notes.size()};
  if (record.tags.size() > maxTags)
    return Error{"There are %1 tags; at most 16 are kept. Remove some.", record.tags.size()};
  if (record.scans.size() > maxScans)
    return Error{"There are %1 scans; at most 64 are kept. Remove some.", record.scans.size()};
  for (const PatientScan& scan : record.scans)
    if (!isSeries(scan.series) || !isDate(scan.savedUtc))
      return Error{
          "The scan \"%1\" of \"%2\" is not possible: it has up to 64 hexadecimal digits and a "
          "date like 2026-11-20T09:30:00Z. Correct or remove it.",
          scan.series, scan.savedUtc};
  if (const auto possible = checkLists(record); !possible) return possible;
  if (const auto possible = checkAllMarkups(record); !possible) return possible;
  std::set<std::string> seen;
  for (const std::string& tag : record.tags) {
    const bool isClean = std::none_of(tag.begin(), tag.end(), [](char c) {
      return c == ',' || static_cast<unsigned char>(c) < ' ';
    });
    if (tag.empty() || tag.size() > maxTag || !isClean)
      return Error{
          "The tag \"%1\" is not possible: it has 1 to 24 characters and no comma. Change it.",
          tag};
    if (!seen.insert(tag).second) return Error{"The tag \"%1\" stands twice. Remove one.", tag};
  }
  return {};
}

fs::path recordFileOf(const fs::path& patient)
{
  return fs::path(patient).replace_extension(".json");
}

Result<PatientRecord> loadPatientRecord(const fs::path& patient)
{
  return readRecord(recordFileOf(patient));
}

Result<PatientRecord> savePatientRecord(const PatientRecord& record, const fs::path& patient)
{
  if (const auto possible = checkRecord(record); !possible) return possible.error();
  const auto lock = lockPatient(patient);
  if (!lock) return lock.error();
  const auto before = loadPatientRecord(patient);
  if (!before) return before.error();
  // a file that was removed holds nothing that could be lost, unless the patient was renamed
  std::error_code ignored;
  const bool isRemoved = before->base.empty() && fs::exists(patient, ignored);
  if (before->base != record.base && !isRemoved)
    return Error{
        "%1 was changed by another program meanwhile; it is not replaced. Read it again, and make "
        "the change in it.",
        recordFileOf(patient).string()};
  return replaceRecord(record, *before, patient);
}

Result<PatientRecord> changePatientRecord(const fs::path& patient,
                                          const std::function<void(PatientRecord&)>& change)
{
  const auto lock = lockPatient(patient);
  if (!lock) return lock.error();
  const auto before = loadPatientRecord(patient);
  if (!before) return before.error();
  PatientRecord record = *before;
  change(record);
  return replaceRecord(record, *before, patient);
}

const ct::CtMarkups* markupsOf(const PatientRecord& record, const std::string& seriesKey)
{
  const auto found = std::ranges::find(record.markups, seriesKey, &ct::CtMarkups::seriesKey);
  return found == record.markups.end() ? nullptr : &*found;
}

void setMarkups(PatientRecord& record, const ct::CtMarkups& markups)
{
  std::erase_if(record.markups,
                [&](const ct::CtMarkups& each) { return each.seriesKey == markups.seriesKey; });
  if (!markups.markups.empty()) record.markups.push_back(markups);
}

Result<void> savePatientVersion(const anatomy::Patient& patient, const fs::path& file,
                                const VersionFacts& facts, bool isNew)
{
  const auto lock = lockPatient(file);
  if (!lock) return lock.error();
  std::error_code failure;
  const bool isThere = fs::exists(file, failure);
  if (isThere && isNew)
    return Error{"%1 is there already; it is not replaced. Open that patient, or use another code.",
                 file};
  const auto before = loadPatientRecord(file);
  if (!before) return before.error();
  PatientRecord record = *before;
  const auto isLast = [&record](const std::string& text) {
    return !record.versions.empty() && record.versions.back().patient == text;
  };
  if (isThere) {
    const auto former = anatomy::loadPatient(file);
    if (!former)
      return Error{"%1 The file is not replaced; move it away, or open it with a newer version.",
                   former.error().message};
    const std::string text = anatomy::patientText(*former);
    if (!isLast(text)) record.versions.push_back({"", "", text, {}, {}});
  }
  const std::string text = anatomy::patientText(patient);
  if (!isLast(text))
    record.versions.push_back({facts.utc, buildId(), text, facts.landmarks, facts.warnings});
  const std::string series = statedSeries(patient);
  const bool isKnown = std::any_of(record.scans.begin(), record.scans.end(),
                                   [&series](const auto& each) { return each.series == series; });
  if (!series.empty() && !isKnown) record.scans.push_back({series, facts.utc});
  if (const auto kept = replaceRecord(record, *before, file); !kept) return kept.error();
  return writeWhole(file, facts.text.empty() ? text : facts.text,
                    {Links::followed, Audience::owner});
}

Result<void> exportPatient(const fs::path& patient, const std::vector<fs::path>& insertions,
                           const fs::path& folder, const CopyProgress& progress,
                           const std::stop_token& stop)
{
  std::error_code failure;
  if (fs::exists(fs::symlink_status(folder, failure)))
    return Error{"%1 exists. Give the name of a new folder.", folder};
  const auto record = loadPatientRecord(patient);
  if (!record) return record.error();
  auto unfinished = UnfinishedFolder::create(folder);
  if (!unfinished) return unfinished.error();
  const fs::path& place = unfinished->path();
  Copying copying(insertions, progress, stop);
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
                               const fs::path& recordings, const CopyProgress& progress,
                               const std::stop_token& stop)
{
  const auto patient = anatomy::loadPatient(folder / exportedPatient);
  if (!patient) return patient.error();
  if (const auto code = anatomy::checkPatientCode(patient->label); !code) return code.error();
  const auto record = readRecord(folder / exportedRecord);
  if (!record) return record.error();
  const auto insertions = insertionsIn(folder);
  if (!insertions) return insertions.error();

  const char* ear = anatomy::nameOf(patient->side);
  const fs::path file = library / (patient->label + "-" + ear + ".toml");
  std::error_code failure;
  fs::create_directories(library, failure);
  const auto lock = lockPatient(file);
  if (!lock) return lock.error();
  if (fs::exists(file, failure))
    return Error{"The library has %1, %2, already. Rename or remove that patient first.",
                 patient->label, anatomy::earOf(patient->side)};
  if (fs::exists(recordFileOf(file), failure))
    return Error{
        "%1 holds notes on a patient of this code and ear whose file is missing; an import does "
        "not replace it. Rename it first.",
        recordFileOf(file).string()};
  for (const fs::path& each : *insertions)
    if (fs::exists(recordings / each.filename(), failure))
      return Error{"%1 exists; an import replaces no recording. Rename it first.",
                   (recordings / each.filename()).string()};

  std::vector<fs::path> made;
  const auto written = [&]() -> Result<void> {
    fs::create_directories(library, failure);
    fs::create_directories(recordings, failure);
    Copying copying(*insertions, progress, stop);
    for (const fs::path& each : *insertions) {
      const fs::path copy = recordings / each.filename();
      if (const auto done = copying.copy(each, copy); !done) return done;
      made.push_back(copy);
    }
    made.push_back(recordFileOf(file));
    if (const auto kept = replaceRecord(*record, {}, file); !kept) return kept.error();
    return anatomy::savePatient(*patient, file);
  }();
  if (written) return file;
  for (const fs::path& each : made) fs::remove(each, failure);
  return written.error();
}

}  // namespace perilymph::session

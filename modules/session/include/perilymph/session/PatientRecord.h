// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What is kept of a patient's ear besides the file of its measures: every version of the measures,
// scans with what a person marked in them, plans, insertions, outcomes, tags, notes, and whether the
// patient is archived.
// A file beside the patient's, so that a copy of the folder is a backup. Nothing names the patient.

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/ct/Markups.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Seal.h"

namespace perilymph::session {

/// Limits of a record [characters, entries].
inline constexpr std::size_t maxNotes = 4000, maxTag = 24, maxTags = 16, maxScans = 64;
inline constexpr std::size_t maxVersions = 256, maxEntries = 10'000;

/// A CT series from which measures of the patient were saved.
struct PatientScan {
  std::string series;    ///< SHA-256 of the series, hexadecimal (MeasurementOrigin::seriesKey).
  std::string savedUtc;  ///< When the first measures of it were saved: "2026-11-20T09:30:00Z".

  friend bool operator==(const PatientScan&, const PatientScan&) = default;
};

/// A landmark of the cochlea in the scan.
struct PatientLandmark {
  std::string name;                   ///< "RW".
  std::array<double, 3> lps_mm = {};  ///< In the CT, LPS.
  bool isByHand = false;              ///< Placed by a person, else proposed by the program.

  friend bool operator==(const PatientLandmark&, const PatientLandmark&) = default;
};

/// The measures as they were saved once. A version is never changed: other measures are a new one.
struct PatientVersion {
  std::string savedUtc;
  std::string program;  ///< Build of the program that saved it.
  std::string patient;  ///< anatomy::patientText(): measures, errors, origin, to a picometer.
  std::vector<PatientLandmark> landmarks = {};
  std::vector<Sentence> warnings = {};  ///< Warnings of the measurement, a sentence each.

  friend bool operator==(const PatientVersion&, const PatientVersion&) = default;
};

/// A plan or an insertion of the patient.
struct PatientEntry {
  std::string utc;   ///< When it was made.
  std::string name;  ///< The plan's number; the name of the recording's file.
  std::string what;  ///< "flex28, flex24".

  friend bool operator==(const PatientEntry&, const PatientEntry&) = default;
};

/// What a CT after surgery showed.
struct PatientOutcome {
  std::string utc;
  std::string series;   ///< SHA-256 of the CT series after surgery.
  std::string content;  ///< The JSON text of the contacts found.

  friend bool operator==(const PatientOutcome&, const PatientOutcome&) = default;
};

struct PatientRecord {
  std::vector<std::string> tags;  ///< "revision", "EAS"; each once.
  std::string notes;
  bool isArchived = false;              ///< Hidden from lists, but kept.
  std::vector<PatientScan> scans = {};  ///< Each series once, in the order of their dates.
  // The oldest first. Entries are added and never removed or changed.
  std::vector<PatientVersion> versions = {};
  std::vector<PatientEntry> plans = {}, insertions = {};
  std::vector<PatientOutcome> outcomes = {};
  /// What a person marked in a CT, each series once; unlike the lists above they may be changed and removed.
  std::vector<ct::CtMarkups> markups = {};
  /// Whether the file was once changed by hand after the program wrote it.
  bool isChangedByHand = false;
  Seal seal = Seal::intact;  ///< State of the file as read; absent in format 1.
  std::string base = {};     ///< SHA-256 of the file as read; empty if there was none.

  /// Compares what is kept; the file's state is no part of it.
  friend bool operator==(const PatientRecord& one, const PatientRecord& other)
  {
    return one.tags == other.tags && one.notes == other.notes &&
           one.isArchived == other.isArchived && one.scans == other.scans &&
           one.versions == other.versions && one.plans == other.plans &&
           one.insertions == other.insertions && one.outcomes == other.outcomes &&
           one.markups == other.markups;
  }
};

/// Checks lengths and characters; tags have no commas and no line breaks, series are hashes. A message has
/// no text of a markup.
Result<void> checkRecord(const PatientRecord& record);

/// The record's file: "P-017-left.json" beside "P-017-left.toml".
std::filesystem::path recordFileOf(const std::filesystem::path& patient);

/// The record beside a patient's file; an empty one if there is none. Formats 1 to 3 are read. One
/// that was changed by hand is read and marked as such.
Result<PatientRecord> loadPatientRecord(const std::filesystem::path& patient);

/// Writes a record beside a patient's file, whole or not at all. Refuses to replace a file that
/// another program changed since the record was read, one that cannot be read or is of a newer
/// program, and to lose versions, plans, insertions or outcomes.
///
/// @return  The record as it is in the file now.
Result<PatientRecord> savePatientRecord(const PatientRecord& record,
                                        const std::filesystem::path& patient);

/// Changes a record as it is in the file now: no other program comes between reading and writing.
Result<PatientRecord> changePatientRecord(const std::filesystem::path& patient,
                                          const std::function<void(PatientRecord&)>& change);

/// The markups of a CT series in a record; null if there are none of it.
const ct::CtMarkups* markupsOf(const PatientRecord& record, const std::string& seriesKey);

/// Replaces the markups of their series in a record; without any, those of the series are removed.
void setMarkups(PatientRecord& record, const ct::CtMarkups& markups);

/// Contents of a version besides the measures.
struct VersionFacts {
  std::string utc;
  std::string text = {};  ///< Text of the patient's file, with comments; by default patientText().
  std::vector<PatientLandmark> landmarks = {};
  std::vector<Sentence> warnings = {};
};

/// Saves a patient's measures: the file, and a new version in the record if they are others than the
/// last. The measures that the file had before become a version, too, if they are not one yet.
///
/// @param isNew  Whether there may be no such file yet.
/// @return       An error, and the file stays, if it is new for the caller, cannot be read, or another
///               program works on the patient.
Result<void> savePatientVersion(const anatomy::Patient& patient, const std::filesystem::path& file,
                                const VersionFacts& facts, bool isNew);

/// Receives the bytes of insertions that are copied, and all of them.
using CopyProgress = std::function<void(std::uintmax_t done, std::uintmax_t all)>;

/// Writes a patient as a new folder: patient.toml, record.json, and copies of insertions, for their
/// owner only. The folder appears when everything is in it; one that `stop` ended leaves nothing.
///
/// @param insertions  Recordings of the patient.
/// @return            Refuses a folder that exists.
Result<void> exportPatient(const std::filesystem::path& patient,
                           const std::vector<std::filesystem::path>& insertions,
                           const std::filesystem::path& folder, const CopyProgress& progress = {},
                           const std::stop_token& stop = {});

/// Adds an exported patient to a library. Everything is checked before the first file is written,
/// and the patient's file is the last one.
///
/// @param library     Folder of the patients.
/// @param recordings  Folder to which the insertions are copied.
/// @return            The patient's file. Refuses a code and ear that the library has, notes that it
///                    has of them, insertions whose names are taken or that are no recordings, links,
///                    and files that cannot be read.
Result<std::filesystem::path> importPatient(const std::filesystem::path& folder,
                                            const std::filesystem::path& library,
                                            const std::filesystem::path& recordings,
                                            const CopyProgress& progress = {},
                                            const std::stop_token& stop = {});

}  // namespace perilymph::session

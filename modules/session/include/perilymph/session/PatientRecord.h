// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What is kept of a patient besides the measures: tags, notes, scans, and whether the patient is
// archived.
// A file beside the patient's, so that a copy of the folder is a backup. Nothing names the patient.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::session {

/// Limits of a record [characters, entries].
inline constexpr std::size_t maxNotes = 4000, maxTag = 24, maxTags = 16, maxScans = 64;

/// A CT series from which measures of the patient were saved.
struct PatientScan {
  std::string series;    ///< SHA-256 of the series, hexadecimal (MeasurementOrigin::seriesKey).
  std::string savedUtc;  ///< When the first measures of it were saved: "2026-11-20T09:30:00Z".

  friend bool operator==(const PatientScan&, const PatientScan&) = default;
};

struct PatientRecord {
  std::vector<std::string> tags;  ///< "revision", "EAS"; each once.
  std::string notes;
  bool isArchived = false;              ///< Hidden from lists, but kept.
  std::vector<PatientScan> scans = {};  ///< Each series once, in the order of their dates.

  friend bool operator==(const PatientRecord&, const PatientRecord&) = default;
};

/// Checks lengths and characters; tags have no commas and no line breaks, series are hashes.
Result<Done> checkRecord(const PatientRecord& record);

/// The record's file: "P-017-left.json" beside "P-017-left.toml".
std::filesystem::path recordFileOf(const std::filesystem::path& patient);

/// The record beside a patient's file; an empty one if there is none.
Result<PatientRecord> loadPatientRecord(const std::filesystem::path& patient);

/// Writes the record beside a patient's file, whole or not at all.
Result<Done> savePatientRecord(const PatientRecord& record, const std::filesystem::path& patient);

/// Receives the bytes of insertions that are copied, and all of them; false stops copying.
using CopyProgress = std::function<bool(std::uintmax_t done, std::uintmax_t all)>;

/// Writes a patient as a new folder: patient.toml, record.json, and copies of insertions, for their
/// owner only. The folder appears when everything is in it; one that was stopped leaves nothing.
///
/// @param insertions  Recordings of the patient.
/// @return            Refuses a folder that exists.
Result<Done> exportPatient(const std::filesystem::path& patient,
                           const std::vector<std::filesystem::path>& insertions,
                           const std::filesystem::path& folder, const CopyProgress& progress = {});

/// Adds an exported patient to a library. Everything is checked before the first file is written,
/// and the patient's file is the last one.
///
/// @param library     Folder of the patients.
/// @param recordings  Folder to which the insertions are copied.
/// @return            The patient's file. Refuses a code and ear that the library has, insertions
///                    whose names are taken, links, and files that cannot be read.
Result<std::filesystem::path> importPatient(const std::filesystem::path& folder,
                                            const std::filesystem::path& library,
                                            const std::filesystem::path& recordings,
                                            const CopyProgress& progress = {});

}  // namespace perilymph::session

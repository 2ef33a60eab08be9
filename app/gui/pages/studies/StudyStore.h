// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Studies that are made in the window: their settings, and their folders on the disk.

#include <QString>
#include <QStringList>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// A key of a scenario with its limits; equal limits are one value.
struct DraftValue {
  std::string key;
  double low = 0.0, high = 0.0;
};

/// What a study is to be.
struct StudyDraft {
  std::string title;
  std::string scenario = "surgery-flex28";      ///< The scenario that plans have, too.
  std::vector<std::string> arrays, frictions;   ///< Names; every combination runs.
  bool hasMean = false;                         ///< The average cochlea is one of them.
  std::size_t simulated = 0;                    ///< Cochleae drawn from the population.
  std::vector<std::filesystem::path> patients;  ///< Absolute.
  std::vector<DraftValue> values;
  std::size_t samples = 1;  ///< Samples of the ranges in each cochlea.
  std::uint64_t seed = 1;
  int nodes = 100;
  double timeStep_ms = 5.0;
};

/// The study as `perilymph-cli study` reads it; patients with their paths.
std::string studyText(const StudyDraft& draft);

/// A study's folder: `study.toml`, copies of the patients, and what is computed.
struct StoredStudy {
  std::filesystem::path folder;
  QString title;
  std::size_t done = 0, cases = 0;  ///< Insertions; both 0 before the first block.
  bool isComplete = false;
};

/// Name of the settings in a study's folder.
inline constexpr const char* studySettingsFile = "study.toml";

/// Folder of all studies: `studies` beside the folder of recordings.
std::filesystem::path studiesFolder();

/// Writes the settings and copies of the patients into a folder that depends on all of them, so that
/// the same study continues where it ended.
Result<std::filesystem::path> saveStudy(const StudyDraft& draft);

/// How far a study's folder is.
StoredStudy readStoredStudy(const std::filesystem::path& folder);

/// The titles of all studies of studiesFolder().
QStringList storedTitles();

/// All studies of studiesFolder(), the last changed first.
std::vector<StoredStudy> storedStudies();

}  // namespace perilymph::gui

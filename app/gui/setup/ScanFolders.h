// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Where CT series were read, so that the page CT and a patient's history open them again.

#include <filesystem>
#include <string>
#include <vector>

namespace perilymph::gui {

/// A CT series that was read.
struct ReadScan {
  std::string series;           ///< SHA-256 of the series.
  std::filesystem::path place;  ///< Nothing may be there any more.
  std::string utc = {};         ///< When it was read last, ISO 8601; empty from earlier versions.
  std::string code = {};        ///< The patient whose measures were taken in it; empty if unknown.
};

/// Remembers where a CT series was read, for the user of this computer alone: such folders often bear
/// patients' names, so neither settings nor a patient's files, exports, reports, lists or logs have them.
///
/// @param series  SHA-256 of the series.
/// @param code    Of the patient; empty keeps the code that is known.
void rememberScan(const std::string& series, const std::filesystem::path& place,
                  const std::string& code = {});

/// Where a series was read last; empty if nothing is known of it. Nothing may be there any more.
std::filesystem::path placeOfScan(const std::string& series);

/// The series that were read last, the last one first. Without those from archives, whose files are
/// removed when the program ends, and those of earlier versions, whose dates are not known.
std::vector<ReadScan> recentScans();

/// Removes all of them. False if the file cannot be removed.
bool clearScans();

}  // namespace perilymph::gui

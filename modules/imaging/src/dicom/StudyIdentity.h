// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What makes a DICOM object part of a patient's study. For EncapsulatedPdf alone: nothing else reads
// who a patient is.

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

/// Attributes of patient and study as they stand in a CT, by group and element, in the CT's own
/// character set.
struct StudyIdentity {
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::string> values;
  std::string studyUid;
  /// SHA-256 of each of its series that states a UID (CtSeries::key).
  std::set<std::string> seriesKeys = {};
};

/// Reads the identity in one DICOM file; none if it states no study.
std::optional<StudyIdentity> identityIn(const std::filesystem::path& file);

/// Reads the identity that all DICOM files below a path have in common. No error names it.
Result<StudyIdentity> readStudyIdentity(const std::filesystem::path& ct);

}  // namespace perilymph::imaging

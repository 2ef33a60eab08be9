// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The headers of a CT's files, from which an object that is written takes patient and study.

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::archive {

inline constexpr std::size_t maxLetters = 64;  // of LO, PS3.5

using Headers = std::vector<std::unique_ptr<DcmFileFormat>>;

/// What is before the voxels in each file of a series below a folder, or in one file. Refuses a place
/// without that series.
///
/// @param seriesKey  SHA-256 of its UID (CtSeries::key).
Result<Headers> readHeaders(const std::filesystem::path& ct, const std::string& seriesKey);

/// Refuses a version of the program that no element of 64 ASCII letters holds.
Result<void> checkSoftware(const std::string& software);

}  // namespace perilymph::archive

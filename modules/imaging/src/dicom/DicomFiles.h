// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The DICOM files below a folder, in a DICOMDIR, or a single one.

#include <cstddef>
#include <filesystem>
#include <vector>

#include "DicomHeader.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/imaging/CtSeries.h"

namespace perilymph::imaging {

struct DicomFiles {
  std::vector<DicomHeader> headers;
  std::size_t others = 0;  ///< Files that are not DICOM.
};

/// Reads the headers of all DICOM files, in the order of their names. Links to folders are not
/// followed.
Result<DicomFiles> listDicomFiles(const std::filesystem::path& path, const ReadingHooks& hooks);

/// What a canceled reading says.
Error canceledReading();

}  // namespace perilymph::imaging

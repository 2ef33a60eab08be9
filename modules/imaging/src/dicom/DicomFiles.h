// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The DICOM files below a folder, in a DICOMDIR, or a single one.

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "../UnpackedZip.h"
#include "DicomHeader.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/imaging/CtSeries.h"

namespace perilymph::imaging {

struct DicomFiles {
  std::vector<DicomHeader> headers;
  std::size_t others = 0;                     ///< Files that are not DICOM.
  std::vector<std::filesystem::path> stumps;  ///< Files that end before they say what they are.
  std::vector<Sentence> warnings;             ///< Sentences about all of them.
  /// Where the files of a .zip are, for as long as they are needed.
  std::shared_ptr<const UnpackedZip> unpacked;
};

/// Reads the headers of all DICOM files, in the order of their names. Links to folders are not
/// followed; a .zip is unpacked. Refuses more files than maxCtFiles, and a folder that takes longer.
Result<DicomFiles> listDicomFiles(const std::filesystem::path& path, const ReadingHooks& hooks,
                                  std::chrono::milliseconds longest = std::chrono::minutes(5));

/// What a canceled reading says.
Error canceledReading();

}  // namespace perilymph::imaging

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Whether the voxels of a file are stored as its header says.

#include "DicomHeader.h"

namespace perilymph::imaging {

/// Whether the file ends before its voxels do.
bool isCutOff(const DicomHeader& header, std::int64_t fileSize);

/// Adds to the faults of a header with voxels where bits, bytes, frames or fragments contradict each other.
void checkStoredBits(DicomHeader& header);

}  // namespace perilymph::imaging

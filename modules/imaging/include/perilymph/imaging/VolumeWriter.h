// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A CT as a file without any data of the patient.

#include <filesystem>

#include "perilymph/ct/CtVolume.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

/// Writes voxels and geometry, nothing else: .nrrd (LPS, exact), .nii or .nii.gz (RAS, positions
/// rounded to single precision). What the voxels show of a face is not removed.
///
/// Refuses other extensions and files that cannot be written.
Result<void> writeVolume(const ct::CtVolume& volume, const std::filesystem::path& file);

}  // namespace perilymph::imaging

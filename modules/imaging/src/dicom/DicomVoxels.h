// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// From the files of a DICOM series to its volume.

#include "DicomSeries.h"
#include "perilymph/ct/CtVolume.h"

namespace perilymph::imaging {

/// Decodes the slices of a series that has a stack, drops those that are there twice with the same
/// voxels, and resamples a tilted gantry's to right angles.
Result<ct::CtVolume> readVoxels(const DicomSeries& series, const ReadingHooks& hooks);

}  // namespace perilymph::imaging

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// From the files of a DICOM series to its volume.

#include <string>
#include <vector>

#include "DicomSeries.h"
#include "perilymph/ct/CtVolume.h"

namespace perilymph::imaging {

struct ReadVolume {
  ct::CtVolume volume;
  std::vector<Sentence> warnings;  ///< Sentences about the voxels.
};

/// Decodes the slices of a series that has a stack, drops those that are there twice with the same
/// voxels, and resamples a tilted gantry's to right angles.
///
/// Refuses voxels that no Hounsfield units can be: nearly constant, beyond 16 bits, or scaled so that slices do not
/// join. What was not measured is `ct::unmeasured`.
Result<ReadVolume> readVoxels(const DicomSeries& series, const ReadingHooks& hooks);

}  // namespace perilymph::imaging

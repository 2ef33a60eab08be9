// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The image planes of a file, from its functional groups or its own elements.

#include <vtkDICOMMetaData.h>

#include "DicomHeader.h"
#include "TagNumbers.h"

namespace perilymph::imaging {

/// Frames in a file up to which it is read.
inline constexpr int maxFrames = 20'000;

/// Fills in the frames of a header, and notes where a file states a frame's geometry or gray values twice, or the
/// number of frames, and both differ.
void readFrames(vtkDICOMMetaData& values, TagNumbers& numbers, DicomHeader& header);

}  // namespace perilymph::imaging

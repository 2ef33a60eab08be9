// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What DICOM states twice, each pair with its tolerance and its answer.

#include <optional>
#include <string>
#include <vector>

#include "../statements/Statements.h"
#include "DicomHeader.h"

namespace perilymph::imaging {

namespace dicomPairs {

// of one file; each is refused
extern const StatedTwice framesAndGroups, framesAndFragments, framesAndOffsets, framesAndBytes,
    highBit, bitsStored, columnsOutsideGroups, rowsOutsideGroups, slopeOutsideGroups,
    interceptOutsideGroups, aspectRatio, modality, grayTable;

// of a series; each is a warning
extern const StatedTwice step, location, locationOfSlice, fieldOfView, imagerColumns, imagerRows,
    tilt, imagesInAcquisition, mediaClass, smallest, largest, directions, imageNumber, side,
    realWorldSlope, realWorldIntercept;

}  // namespace dicomPairs

/// Every pair, as the guide prints them.
std::vector<StatedTwice> allDicomPairs();

/// The sentence about a file that states a quantity twice; empty where both agree.
std::optional<Sentence> disagreement(const DicomHeader& header, const StatedTwice& pair,
                                     double first, double second);

}  // namespace perilymph::imaging

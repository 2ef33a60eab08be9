// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What stands against reading a series.

#include <string>

#include "DicomSeries.h"

namespace perilymph::imaging {

/// The modality that a file states, or that of its class where it states none.
std::string statedModality(const DicomHeader& header);

/// Why the series cannot be read, as far as its files tell one by one: a sentence; empty if it can.
std::string obstacleOf(const DicomSeries& series);

/// Why the order of the slices in its stack is none of one reconstruction: a setting alternates; empty if it is.
std::string orderObstacleOf(const DicomSeries& series);

/// Why its gray values are not Hounsfield units, as its headers say: a sentence; empty if they are.
std::string grayValueWarning(const DicomSeries& series);

}  // namespace perilymph::imaging

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What stands against reading a series.

#include <cstddef>
#include <string>
#include <utility>

#include "DicomSeries.h"

namespace perilymph::imaging {

/// The modality that a file states, or that of its class where it states none.
std::string statedModality(const DicomHeader& header);

/// Why the series cannot be read, as far as its files tell one by one: a sentence; empty if it can.
Sentence obstacleOf(const DicomSeries& series);

/// How a setting changes along a stack. Empty values change nothing.
struct Changes {
  std::size_t count = 0;
  bool returns = false;  ///< To a value that it had before.
  std::pair<std::string, std::string> example;
};

/// @param setting  Index in the settings of the headers.
Changes changesOf(const DicomSeries& series, std::size_t setting);

/// Why the order of the slices in its stack is none of one reconstruction: a setting alternates; empty if it is.
Sentence orderObstacleOf(const DicomSeries& series);

/// Why its gray values are not Hounsfield units, as its headers say: a sentence; empty if they are.
Sentence grayValueWarning(const DicomSeries& series);

}  // namespace perilymph::imaging

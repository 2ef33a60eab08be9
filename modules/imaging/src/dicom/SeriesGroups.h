// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Which files make one series: of one patient, study and frame of reference, not of one series number alone.

#include <string>
#include <vector>

#include "DicomHeader.h"

namespace perilymph::imaging {

struct SeriesGroup {
  /// SeriesInstanceUID; "without-uid-1" and so on without one. Where several groups state one UID, those of other
  /// patients or studies have "#1", "#2" behind it, and those of another frame of reference but the largest too.
  std::string uid;
  std::string
      warning;  ///< A sentence about images of the same number that do not belong to it; may be empty.
  std::vector<DicomHeader> headers;
};

/// Files by series, in the order of their UIDs.
std::vector<SeriesGroup> groupsOf(std::vector<DicomHeader> headers);

}  // namespace perilymph::imaging

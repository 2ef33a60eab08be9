// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A study of one small CT, of a patient with a name.

#include <string>
#include <vector>

#include "../imaging/SmallCt.h"
#include "perilymph/test/DicomWriter.h"

namespace perilymph::archive {

inline constexpr const char* ctStudy = "1.2.840.99.17";
inline constexpr const char* ctSeries = "1.2.840.99.17.1";

/// One file a slice.
inline std::vector<test::DicomData> smallStudy(int slices = 12,
                                               const std::string& series = ctSeries)
{
  auto files = test::dicomSlices(imaging::smallCt(Eigen::Matrix3d::Identity(),
                                                  Eigen::Vector3d(0.3, 0.3, 0.3), {16, 16, slices}),
                                 series);
  for (test::DicomData& file : files) {
    file.setText(0x00080005, "CS", "ISO_IR 100");
    file.setText(0x00080020, "DA", "20250102");
    file.setText(0x00081030, "LO", "Temporal bone");
    file.setText(0x0008103E, "LO", "0.3 mm");
    file.setText(0x00100010, "PN", "M\xfcller^Jane");  // ISO 8859-1
    file.setText(0x00100020, "LO", "MRN-4711");
    file.setText(0x00100030, "DA", "19700102");
    file.setText(0x0020000D, "UI", ctStudy);
    file.setText(0x00200011, "IS", "3");
  }
  return files;
}

}  // namespace perilymph::archive

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A CT of two slices in a study that names its patient.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "perilymph/ct/CtVolume.h"
#include "perilymph/foundation/Sha256.h"
#include "perilymph/test/DicomWriter.h"

namespace perilymph::test {

/// The SHA-256 by which patient files and plans name a series.
inline std::string keyOfSeries(const std::string& series)
{
  Sha256 key;
  key.add(std::string_view(series));
  return key.hex();
}

/// Writes the slices of a series into a folder.
inline void writeStudy(const std::filesystem::path& folder, const std::string& series,
                       const std::string& patientName)
{
  Eigen::Matrix4d lps = Eigen::Matrix4d::Identity();
  lps.topLeftCorner<3, 3>() *= 0.3;
  const auto volume = ct::CtVolume::make({4, 4, 2}, lps, std::vector<std::int16_t>(32, 7), {});
  ASSERT_TRUE(volume) << volume.error().message;
  auto slices = dicomSlices(*volume, series);
  for (DicomData& slice : slices) {
    slice.setText(0x0020000D, "UI", "1.2.840.99");
    slice.setText(0x00100010, "PN", patientName);
  }
  writeDicomFiles(slices, folder);
}

}  // namespace perilymph::test

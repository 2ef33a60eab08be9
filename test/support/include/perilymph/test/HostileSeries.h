// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Series that no reader may take for one CT of one ear, made from the slices of a good one.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "perilymph/test/DicomWriter.h"

namespace perilymph::test {

/// One way in which a series is not to be trusted.
struct HostileSeries {
  std::string name;
  std::function<void(std::vector<DicomData>&)> change;
  std::string sentence;  ///< A part of what is said of it.
  bool isCut = false;    ///< One file ends before its voxels do.

  /// Writes the changed series as a folder.
  void write(std::vector<DicomData> slices, const std::filesystem::path& folder) const
  {
    if (change) change(slices);
    writeDicomFiles(slices, folder);
    if (!isCut) return;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      std::filesystem::resize_file(entry.path(), std::filesystem::file_size(entry.path()) / 2);
      return;
    }
  }
};

/// Images of two patients or spacings, missing slices, a cut one: each is refused with a sentence.
inline std::vector<HostileSeries> hostileSeries()
{
  const auto middle = [](std::vector<DicomData>& slices) -> DicomData& {
    return slices[slices.size() / 2];
  };
  return {
      // images of two numbers are two series, and neither has all slices
      {"two-patients", [=](auto& slices) { middle(slices).setText(0x00100020, "LO", "ANOTHER"); },
       "1 slice is missing"},
      {"two-births", [=](auto& slices) { middle(slices).setText(0x00100030, "DA", "19500101"); },
       "may be of two patients"},
      {"two-spacings",
       [=](auto& slices) {
         middle(slices).setNumbers(0x00280030, {0.41, 0.41});
       },
       "several pixel spacings"},
      {"missing-slices",
       [](auto& slices) { slices.erase(slices.begin() + 20, slices.begin() + 23); },
       "3 slices are missing"},
      {"cut-slice", {}, "cut off", true}};
}

}  // namespace perilymph::test

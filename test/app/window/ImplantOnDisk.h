// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// An implanted phantom as two folders of DICOM files: the CT before surgery and the CT after it.

#include "perilymph/test/DicomWriter.h"
#include "perilymph/test/ImplantPhantom.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {

/// Its contacts are 1.9 mm apart, and none of its neighbors merges with another at 0.3 mm.
inline constexpr const char* implantedArray = "flex24";
/// Twice the 95th percentile of a contact's error where the numbers are right (README of the module outcome: 0.22 mm
/// of the ears of 0.3 mm); a contact that has its neighbor's number is 1.9 mm off.
inline constexpr double foundWithin_mm = 0.44;

/// The phantom of a development seed, and its folders "before" and "after". A half minute.
struct ImplantOnDisk {
  ImplantPhantom phantom = [] {
    ImplantCondition condition;
    condition.array = implantedArray;
    return makeImplantPhantom(31, highResolutionImplantScan(), condition);
  }();
  TemporaryFolder folder;
  ImplantOnDisk()
  {
    writeDicomFiles(dicomSlices(phantom.preoperative.volume, "1.2.3.31"), folder / "before");
    writeDicomFiles(dicomSlices(phantom.postoperative, "1.2.4.31"), folder / "after");
  }
};

/// Made once.
inline const ImplantOnDisk& implantOnDisk()
{
  static const ImplantOnDisk made;
  return made;
}

}  // namespace perilymph::test

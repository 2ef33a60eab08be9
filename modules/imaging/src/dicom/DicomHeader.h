// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What one DICOM file says of its image. The patient's name, number and dates are never read.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/ct/SliceStack.h"

namespace perilymph::imaging {

/// One image plane of a file.
struct DicomFrame {
  ct::SlicePose pose;
  /// Distance between columns (along a row), then between rows [mm].
  std::optional<Eigen::Vector2d> pixelSpacing_mm;
  double slope = 1.0, intercept = 0.0;  ///< From stored value to Hounsfield units.
  bool isLocalizer = false;             ///< A scout.
};

/// How the voxels of a file are stored. `deflated` is a file that is compressed as a whole behind its meta
/// information (DICOM PS3.5, A.5): nothing else is known of it.
enum class PixelCoding { plain, compressed, deflated, unknown };

struct DicomHeader {
  std::filesystem::path file;
  std::string seriesUid, sopClass, transferSyntax, modality, photometric, scanner, kernel;
  PixelCoding coding = PixelCoding::plain;
  bool isLossy = false;
  int rows = 0, columns = 0, samples = 1, bitsAllocated = 0;
  std::vector<DicomFrame> frames;
  bool isDerived = false;    ///< Computed from other images, as reformatted planes are.
  bool hasPixels = false;    ///< There is an image.
  bool isEncrypted = false;  ///< Attributes are encrypted.
  bool isTruncated = false;  ///< The file ends before its voxels do.
};

/// Reads the header of a file up to its voxels; none where it is no DICOM file.
std::optional<DicomHeader> readDicomHeader(const std::filesystem::path& file);

/// Parses a file up to its voxels as the reader of the voxels does, all elements of it, and keeps nothing.
void parseWholeHeader(const std::filesystem::path& file);

/// The files that a DICOMDIR names, each within its folder; none where the file is no DICOMDIR.
std::optional<std::vector<std::filesystem::path>> filesOfDicomDir(
    const std::filesystem::path& file);

}  // namespace perilymph::imaging

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What one DICOM file says of its image. The patient's name, number and date of birth are kept as digests only.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
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
  /// Second statements of the geometry: SliceThickness, SpacingBetweenSlices, SliceLocation [mm].
  std::optional<double> thickness_mm, spacing_mm, location_mm;
};

/// How the voxels of a file are stored. `deflated` is a file that is compressed as a whole behind its meta
/// information (DICOM PS3.5, A.5): nothing else is known of it.
enum class PixelCoding { plain, compressed, deflated, unknown };

/// Whom and what an image belongs to. Digests tell equal from different and nothing else.
struct DicomIdentity {
  std::string patient, study,
      frameOfReference;  ///< Digests of number and UIDs; empty where absent.
  /// Digests of what else is stated of the patient, by tag: "PatientSex (0010,0040)".
  std::vector<std::pair<std::string, std::string>> others;
};

struct DicomHeader {
  std::filesystem::path file;
  std::string seriesUid, sopClass, transferSyntax, modality, photometric, scanner, kernel;
  std::string mediaClass;   ///< MediaStorageSOPClassUID: the class again, before the header.
  std::string rescaleType;  ///< "HU" or another unit; empty where absent.
  /// Day of the acquisition, else of series or study: "2026-11-20"; empty where none is stated.
  std::string acquired;
  PixelCoding coding = PixelCoding::plain;
  bool isLossy = false;
  int rows = 0, columns = 0, samples = 1;
  /// Bits of a stored value; `highBit` and `bitsStored` are 0 where absent.
  int bitsAllocated = 0, bitsStored = 0, highBit = 0;
  bool isSigned = false;
  bool hasOverlayBits = false;  ///< Bits beyond the stored ones hold an overlay.
  /// Stored values that stand for no measurement, the lowest and the highest.
  std::optional<std::array<double, 2>> padding;
  std::optional<double> smallest, largest;  ///< Stored values, as the header states them.
  std::vector<DicomFrame> frames;
  std::optional<Eigen::Vector2d> imagerSpacing_mm, aspectRatio;  ///< Columns, then rows.
  std::optional<double> reconstructionDiameter_mm, gantryTilt_deg;
  std::optional<int> imagesInAcquisition;
  std::string instanceUid;  ///< SOPInstanceUID, which no other image has.
  std::optional<double> instanceNumber;
  /// Laterality and ImageLaterality: "R", "L", or what else is there; empty where absent.
  std::string laterality, imageLaterality;
  std::string patientOrientation;  ///< Where rows and columns point, as "L\\P"; empty where absent.
  /// Slope and intercept by which RealWorldValueMappingSequence gives Hounsfield units.
  std::optional<std::array<double, 2>> realWorldScale;
  DicomIdentity identity;
  /// How the image was made, by tag, as text: differences tell reconstructions apart.
  std::vector<std::pair<std::string, std::string>> settings;
  bool isDerived = false;       ///< Computed from other images, as reformatted planes are.
  bool hasPixels = false;       ///< There is an image.
  bool isDirectory = false;     ///< A DICOMDIR.
  bool isEncrypted = false;     ///< Attributes are encrypted.
  bool isTruncated = false;     ///< The file ends before its voxels do.
  std::int64_t pixelStart = 0;  ///< Byte at which the value of PixelData begins.
  std::optional<std::int64_t> pixelBytes;  ///< Length of that value; none where undefined.
  /// What contradicts itself or cannot be read in this file, sentences.
  std::vector<Sentence> faults;
  /// Why the file was not parsed, a sentence; empty where it was.
  Sentence notParsed;
};

/// Reads the header of a file up to its voxels; none where it is no DICOM file.
std::optional<DicomHeader> readDicomHeader(const std::filesystem::path& file);

/// Name of a file for messages, on one line.
std::string nameOf(const DicomHeader& header);

/// Parses a file up to its voxels as the reader of the voxels does, all elements of it, and keeps nothing.
void parseWholeHeader(const std::filesystem::path& file);

}  // namespace perilymph::imaging

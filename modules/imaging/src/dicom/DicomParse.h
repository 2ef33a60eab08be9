// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One pass of vtk-dicom's parser over a file, and the texts it leaves.

#include <vtkDICOMMetaData.h>
#include <vtkDICOMValue.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace perilymph::imaging {

struct ParsedDicom {
  vtkSmartPointer<vtkDICOMMetaData> values;
  bool hasPixels = false, isDamaged = false;
  std::int64_t pixelStart = 0, fileSize = 0;
  std::uint32_t pixelLength =
      0;  ///< Length of PixelData as its element says; 0xFFFFFFFF where undefined.
};

/// Parses a file up to its voxels. Only what is asked for is kept of a header, so that none is larger than it
/// may be; without a query, every element. None where the file does not begin as DICOM files do.
std::optional<ParsedDicom> parseDicom(const std::filesystem::path& file, vtkDICOMMetaData* wanted);

/// A value on one line, without padding, of at most 128 bytes.
std::string textIn(const vtkDICOMValue& value);

/// A UID as it stands, but for its padding: a damaged one must not become a known one.
std::string uidIn(const vtkDICOMValue& value);

/// True where one of a value's texts is the one that is wanted.
bool hasValue(const vtkDICOMValue& value, const char* wanted);

}  // namespace perilymph::imaging

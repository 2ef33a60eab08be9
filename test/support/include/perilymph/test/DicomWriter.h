// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// DICOM files made by hand, element by element, so that what reads them is tested against the
// standard and not against itself.

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/ct/CtVolume.h"

namespace perilymph::test {

/// Tags are written 0xGGGGEEEE.
using DicomTag = std::uint32_t;

/// A set of data elements, written explicitly in little-endian order.
class DicomData {
public:
  void setText(DicomTag tag, const std::string& type, const std::string& value);
  void setNumber(DicomTag tag, std::uint16_t value);
  void setNumbers(DicomTag tag, const std::vector<double>& values);  ///< As decimal text.
  void setSequence(DicomTag tag, const std::vector<DicomData>& items);
  void setPixels(const std::vector<std::uint16_t>& values);
  void setBytes(DicomTag tag, const std::string& type, std::string bytes);
  void remove(DicomTag tag) { elements_.erase(tag); }
  bool has(DicomTag tag) const { return elements_.contains(tag); }

  /// Elements without the header of a file.
  std::string elements() const;
  /// A file with preamble and header. The transfer syntax is only stated, not applied.
  std::string file(const std::string& transferSyntax = "1.2.840.10008.1.2.1") const;

private:
  std::map<DicomTag, std::pair<std::string, std::string>> elements_;
};

/// One file a slice, as a scanner writes them, with a patient's name, number and date of birth that
/// no reader may show: "Secretname^Patient", "SECRETID", "19010203".
std::vector<DicomData> dicomSlices(const ct::CtVolume& volume,
                                   const std::string& seriesUid = "1.2.3.4");

/// The volume as one enhanced multi-frame file.
DicomData enhancedDicom(const ct::CtVolume& volume, const std::string& seriesUid = "1.2.3.5");

/// Writes files under names whose order is not that of the slices.
void writeDicomFiles(const std::vector<DicomData>& files, const std::filesystem::path& folder);

}  // namespace perilymph::test

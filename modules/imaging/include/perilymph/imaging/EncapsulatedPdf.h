// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A PDF as a DICOM object (Encapsulated PDF Storage), for the archive that holds the patient's CT.
//
// An archive matches an object to a patient by name, number and study. They are read from the CT at
// this moment, written to the one file the user asked for, and neither kept, shown nor logged.

#include <filesystem>
#include <optional>
#include <string>

#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

/// A document to encapsulate. Texts are ASCII, so that they suit the CT's character set.
struct PdfDocument {
  std::string content;      ///< Bytes of the PDF.
  std::string title;        ///< "Insertion plan"; at most 64 letters.
  std::string patientCode;  ///< Number of the patient where no CT is given.
  std::string software;     ///< Version of the program; at most 64 letters.
  /// SHA-256 of the series from which its numbers come (CtSeries::key); empty where no one is known.
  std::string seriesKey = {};
  /// Whether it may become part of a study all the same if no series is known.
  bool isFiledWithoutSeries = false;
};

/// Writes a PDF as an Encapsulated PDF object with new series and instance UIDs, atomically.
///
/// @param ct    Folder, DICOMDIR or file of the patient's CT, of whose study the object becomes a
///              part. Without it the object has a new study, the patient's code and no name.
/// @param file  The DICOM file to write.
/// @return      Refuses a CT without the series of the document, whose files belong to several studies
///              or state none, a content that is no PDF, and texts that are too long or not ASCII.
Result<void> writeEncapsulatedPdf(const PdfDocument& document,
                                  const std::optional<std::filesystem::path>& ct,
                                  const std::filesystem::path& file);

}  // namespace perilymph::imaging

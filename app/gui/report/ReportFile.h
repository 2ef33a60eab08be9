// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A report as a file: a PDF, or a DICOM object that holds it.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// Where a report is saved. A file that ends in .dcm is a DICOM object.
struct ReportPlace {
  std::filesystem::path file;
  /// Folder, DICOMDIR or file of the CT whose study a DICOM object becomes a part of.
  std::optional<std::filesystem::path> ct = std::nullopt;
  /// Whether it does so all the same if the report states no series.
  bool isCtNotCompared = false;

  bool isDicom() const { return file.extension() == ".dcm"; }
};

/// What a DICOM object states of a report. Texts are ASCII.
struct ReportIdentity {
  std::string title;      ///< "Insertion plan"
  std::string code;       ///< The patient's; empty if the label is not a code: it may be a name.
  std::string seriesKey;  ///< The CT series of the measures; empty where nobody vouches for one.
};

/// Writes a PDF file.
using PdfWriting = std::function<Result<void>(const std::filesystem::path&)>;

/// A patient's label as the code of an identity.
std::string codeOf(const anatomy::Patient& patient);

/// Refuses a place whose file would replace one of the CT.
Result<void> checkPlace(const ReportPlace& place);

/// Refuses to file a report in the study of a CT if it states no series to compare with.
Result<void> checkFiled(const ReportIdentity& identity);

/// The bytes of a PDF, written to a temporary folder. UI thread.
Result<std::string> pdfBytes(const PdfWriting& writing);

/// Writes the DICOM object that holds a PDF, atomically. Any thread.
Result<void> writeDicom(std::string pdf, const ReportIdentity& identity, const ReportPlace& place);

}  // namespace perilymph::gui

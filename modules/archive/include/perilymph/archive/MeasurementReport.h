// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Measures of a cochlea as a DICOM structured report (TID 1500) of the CT's study.

#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::archive {

/// What was measured; the codes of the report are in the guide's page archive.md.
enum class Quantity { a, b, h, ductLength };

struct ReportedMeasure {
  Quantity quantity = Quantity::a;
  double value_mm = 0.0;
  double halfWidth95_mm = 0.0;  ///< Half of the 95 % interval; 0 where the error is not known.
};

/// The measures of one cochlea.
struct MeasurementReport {
  std::vector<ReportedMeasure> measures;
  bool isRight = false;
  bool hasMarksByHand = false;  ///< A person placed landmarks that steered the fit.
  std::string software;         ///< Version of the program; at most 64 ASCII letters.
  std::string seriesKey;        ///< SHA-256 of the series that was measured (CtSeries::key).
};

/// Writes a report with new series and instance UIDs, for its owner only, atomically. It names the
/// patient and the study as the CT does and refers to every image of the series that was measured.
/// One cochlea of one series has the same tracking UID in every report.
///
/// @param ct  The folder of the CT.
/// @return    Refuses a report without measures, and a folder without that series.
Result<void> writeMeasurementReport(const MeasurementReport& report,
                                    const std::filesystem::path& ct,
                                    const std::filesystem::path& file);

}  // namespace perilymph::archive

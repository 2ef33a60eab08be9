// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Texts on what clinics report of an array.

#include <QString>
#include <string>

#include "perilymph/analysis/ClinicalReports.h"

namespace perilymph::gui {

/// "408 (373–449)°", "49 of 51", "7 %"; empty where nothing is reported.
QString clinicsReport(const std::string& array, analysis::ReportedQuantity quantity);

/// The same for narrow cells: "408°", "96 %", "45–102" for forces in mN.
QString clinicsReportShort(const std::string& array, analysis::ReportedQuantity quantity);

/// A line for each report: numbers, n, what they are and where from; empty where there is none.
QString clinicsReportDetails(const std::string& array, analysis::ReportedQuantity quantity);

/// The source of clinicsReport(); empty where nothing is reported.
std::string clinicsSource(const std::string& array, analysis::ReportedQuantity quantity);

/// Whether the program's clinical table misses a row of an array.
bool isNotValidated(const std::string& array);

/// "Not validated: the clinical table misses angular depth of flex24."; empty for other arrays.
QString notValidatedNote(const std::string& array);

/// "not validated" of an array of which the clinical table misses a row, "not tested" of one without a row;
/// else empty.
QString verdictMark(const std::string& array);
/// A sentence on the mark; empty without one.
QString verdictNote(const std::string& array);

}  // namespace perilymph::gui

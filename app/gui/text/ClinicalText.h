// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Texts on what clinics report of an array.

#include <QString>
#include <string>

#include "perilymph/analysis/ClinicalReports.h"

namespace perilymph::gui {

/// "408 (IQR 373–449)°", "49 of 51", "7 %"; empty where nothing is reported.
QString clinicsReport(const std::string& array, analysis::ReportedQuantity quantity);

/// The same for narrow cells: "408°", "96 %", "45–102" for forces in mN.
QString clinicsReportShort(const std::string& array, analysis::ReportedQuantity quantity);

/// A line for each report: numbers, n, what they are and where from; empty where there is none.
QString clinicsReportDetails(const std::string& array, analysis::ReportedQuantity quantity);

/// The source of clinicsReport(); empty where nothing is reported.
std::string clinicsSource(const std::string& array, analysis::ReportedQuantity quantity);

/// "not validated" where the program's clinical table misses a row of an array, "not tested" where it has
/// none; empty where all rows are met.
QString verdictMark(const std::string& array);

/// "Not validated: the program’s clinical table misses angular depth of flex24.", likewise.
QString verdictNote(const std::string& array);

/// Whether what clinics report is of this array alone.
bool isOfArrayAlone(const std::string& array, analysis::ReportedQuantity quantity);

/// What must be said beside the values of a plan, in the window and on paper.
QString planLimitsText();

}  // namespace perilymph::gui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The cochlea in a report: measures with their place in the population and their uncertainty.

#include "gui/report/References.h"
#include "gui/report/ReportContent.h"
#include "gui/report/ReportSheet.h"

namespace perilymph::gui {

/// Paints the table of measures, cochlear duct length and coverage.
///
/// @return  Its lower end [mm].
double paintAnatomy(ReportSheet& sheet, const ReportContent& content, References& references,
                    double y_mm, double width_mm);

}  // namespace perilymph::gui

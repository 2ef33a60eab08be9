// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The table of a cochlea's measures in reports: with their uncertainty and place in the population.

#include <vector>

#include "gui/report/References.h"
#include "gui/report/ReportSheet.h"
#include "gui/setup/Populations.h"
#include "perilymph/analysis/AnatomyMeasures.h"
#include "perilymph/anatomy/Patient.h"

namespace perilymph::gui {

struct MeasureRow {
  QString name, value, place;
  std::string source;  ///< For References::label(); empty without one.
};

/// A length measured in a patient, compared with its population.
MeasureRow measuredRow(const QString& name, Length value, const Population& population,
                       const std::string& source, Length error);

/// A, B and H of a patient who has them, with the errors of their measurement.
std::vector<MeasureRow> basalTurnRows(const anatomy::Patient& patient);

/// Title of the table of a patient's measures.
QString measuresTitle(const anatomy::Patient& patient);

/// A measure of a built cochlea, with its uncertainty if `bands` has one: "33.9 ± 0.4 mm".
QString measureText(const std::vector<analysis::Measure>& measures,
                    const std::vector<double>& bands, const char* key);

/// The cochlear duct length (anatomy's DuctLength.h).
MeasureRow ductLengthRow(const QString& value);

/// Paints the table.
///
/// @return  Its lower end [mm].
double paintMeasures(ReportSheet& sheet, const QString& title, const std::vector<MeasureRow>& rows,
                     References& references, double y_mm, double width_mm);

}  // namespace perilymph::gui

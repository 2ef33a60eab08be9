// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/ReportAnatomy.h"

#include <QCoreApplication>

#include "gui/report/MeasureTable.h"
#include "gui/text/Numbers.h"
#include "perilymph/analysis/ErrorBand.h"

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

std::vector<MeasureRow> rowsOf(const ReportContent& content)
{
  const anatomy::Patient& patient = content.scenario.patient();
  const auto valueOf = [&content](const char* key) {
    return measureText(content.measures, content.bands, key);
  };
  std::vector<MeasureRow> rows;
  if (!content.hasPatient()) {
    rows = {{tr("A: basal-turn diameter"), valueOf("A_mm"), tr("of the model"), {}},
            {tr("B: basal-turn width"), valueOf("B_mm"), tr("of the model"), {}}};
  } else if (patient.basalTurn) {
    rows = basalTurnRows(patient);
  } else {
    const std::string sections = "Froehlich et al. 2024";
    rows = {
        measuredRow(tr("Organ of Corti length"), patient.scalaTympaniLength,
                    scalaLengthPopulation(), "Stakhovskaya et al. 2007", analysis::measuringError),
        measuredRow(tr("Scala width at round window"), patient.roundWindowWidth,
                    windowWidthPopulation(), sections, analysis::measuringError),
        measuredRow(tr("Scala height at round window"), patient.roundWindowHeight,
                    windowHeightPopulation(), sections, analysis::measuringError)};
  }
  rows.push_back(ductLengthRow(valueOf("cdl_oc_mm")));
  rows.push_back({tr("Cochlear coverage"),
                  tr("%1 %").arg(numberText(100.0 * cochlearCoverage(content.contacts), 0)),
                  tr("organ of Corti basal to the most apical contact"),
                  {}});
  return rows;
}

}  // namespace

double paintAnatomy(ReportSheet& sheet, const ReportContent& content, References& references,
                    double y_mm, double width_mm)
{
  const QString title = content.hasPatient() ? measuresTitle(content.patient())
                        : content.scenario.anatomy() == anatomy::AnatomySource::mean
                            ? tr("Cochlea: average of 15 human cochleae")
                            : tr("Cochlea: model");
  return paintMeasures(sheet, title, rowsOf(content), references, y_mm, width_mm);
}

}  // namespace perilymph::gui

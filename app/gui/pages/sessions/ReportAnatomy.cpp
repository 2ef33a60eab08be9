// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/sessions/ReportAnatomy.h"

#include <QCoreApplication>
#include <cmath>

#include "gui/parts/Numbers.h"
#include "gui/setup/Populations.h"
#include "perilymph/analysis/ErrorBand.h"

namespace perilymph::gui {

namespace {

constexpr double row_mm = 4.4;

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

struct AnatomyRow {
  QString name, value, place, source;
};

QString withError(double value_mm, double error_mm, int decimals)
{
  return tr("%1 ± %2 mm").arg(numberText(value_mm, decimals), numberText(error_mm, decimals));
}

/// "1.2 SD above population mean (9.2 ± 0.4 mm)"
QString placeOf(Length value, const Population& population)
{
  if (!population.mean || !population.standardDeviation) return tr("no population mean available");
  const double off = (value - *population.mean) / *population.standardDeviation;
  const QString mean = numberText(inMillimeters(*population.mean), 2);
  const QString spread = numberText(inMillimeters(*population.standardDeviation), 2);
  if (std::fabs(off) < 0.05) return tr("at population mean (%1 ± %2 mm)").arg(mean, spread);
  return (off < 0.0 ? tr("%1 SD below population mean (%2 ± %3 mm)")
                    : tr("%1 SD above population mean (%2 ± %3 mm)"))
      .arg(numberText(std::fabs(off), 1), mean, spread);
}

AnatomyRow measured(const QString& name, Length value, const Population& population,
                    const QString& source, Length error = analysis::measuringError)
{
  return {name, withError(inMillimeters(value), inMillimeters(error), 2),
          placeOf(value, population), source};
}

/// A measure of the built cochlea, with its uncertainty if there is one.
QString valueOf(const ReportContent& content, const char* key)
{
  for (std::size_t i = 0; i < content.measures.size(); ++i) {
    if (content.measures[i].key != key) continue;
    const double value = content.measures[i].value;
    if (i < content.bands.size()) return withError(value, content.bands[i], 1);
    return tr("%1 mm").arg(numberText(value, 1));
  }
  return QStringLiteral("–");
}

std::vector<AnatomyRow> rowsOf(const ReportContent& content)
{
  const anatomy::Patient& patient = content.scenario.patient();
  std::vector<AnatomyRow> rows;
  if (!content.hasPatient()) {
    rows = {{tr("A: basal-turn diameter"), valueOf(content, "A_mm"), tr("of the model"), {}},
            {tr("B: basal-turn width"), valueOf(content, "B_mm"), tr("of the model"), {}}};
  } else if (patient.basalTurn) {
    const QString source = tr("Pietsch et al. 2017, n = 138");
    const anatomy::BasalTurnErrors errors = analysis::errorsOf(patient);
    rows = {measured(tr("A: basal-turn diameter"), patient.basalTurn->a, lengthAPopulation(),
                     source, errors.a),
            measured(tr("B: basal-turn width"), patient.basalTurn->b, widthBPopulation(), source,
                     errors.b)};
    if (patient.basalTurn->h)
      rows.push_back(measured(tr("H: cochlear height"), *patient.basalTurn->h, heightHPopulation(),
                              {}, errors.h.value_or(analysis::measuringError)));
  } else {
    const QString sections = tr("Froehlich et al. 2024, n = 15");
    rows = {measured(tr("Organ of Corti length"), patient.scalaTympaniLength,
                     scalaLengthPopulation(), tr("Stakhovskaya et al. 2007, n = 9")),
            measured(tr("Scala width at round window"), patient.roundWindowWidth,
                     windowWidthPopulation(), sections),
            measured(tr("Scala height at round window"), patient.roundWindowHeight,
                     windowHeightPopulation(), sections)};
  }
  rows.push_back({tr("Cochlear duct length (CDL)"), valueOf(content, "cdl_oc_mm"),
                  tr("estimated from A: 4.16 A − 4 mm"), tr("Alexiades et al. 2015")});
  rows.push_back({tr("Cochlear coverage"),
                  tr("%1 %").arg(numberText(100.0 * cochlearCoverage(content.contacts), 0)),
                  tr("organ of Corti basal to the most apical contact"), tr("this insertion")});
  return rows;
}

}  // namespace

double paintAnatomy(ReportSheet& sheet, const ReportContent& content, double y_mm, double width_mm)
{
  const QString title = content.hasPatient() ? tr("Cochlea, CT measurements ± measuring error")
                        : content.scenario.anatomy() == anatomy::AnatomySource::mean
                            ? tr("Cochlea: average of 15 human cochleae")
                            : tr("Cochlea: model");
  y_mm = sheet.heading(0.0, y_mm, width_mm, title);
  const double ends[] = {0.0, 0.28 * width_mm, 0.43 * width_mm, 0.77 * width_mm, width_mm};
  for (const AnatomyRow& row : rowsOf(content)) {
    const QString cells[] = {row.name, row.value, row.place, row.source};
    const ReportFace faces[] = {ReportFace::text, ReportFace::bold, ReportFace::quiet,
                                ReportFace::quiet};
    for (int i = 0; i < 4; ++i)
      sheet.line({ends[i], y_mm, ends[i + 1] - ends[i] - 1.0, row_mm}, cells[i], faces[i]);
    y_mm += row_mm;
  }
  return y_mm;
}

}  // namespace perilymph::gui

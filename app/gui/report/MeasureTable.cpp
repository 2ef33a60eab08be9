// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/MeasureTable.h"

#include <QCoreApplication>
#include <cmath>

#include "gui/setup/EnteredMeasures.h"
#include "gui/text/Numbers.h"
#include "perilymph/analysis/ErrorBand.h"
#include "perilymph/foundation/Normal.h"

namespace perilymph::gui {

namespace {

constexpr double row_mm = 4.4;

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

QString withInterval(double value_mm, double half95_mm, int decimals)
{
  return tr("%1 ± %2 mm").arg(numberText(value_mm, decimals), numberText(half95_mm, decimals));
}

/// "1.2 SD above population mean (9.23 mm, SD 0.53)"
QString placeOf(Length value, const Population& population)
{
  if (!population.mean || !population.standardDeviation) return tr("no population mean available");
  const double off = (value - *population.mean) / *population.standardDeviation;
  const QString mean = numberText(inMillimeters(*population.mean), 2);
  const QString spread = numberText(inMillimeters(*population.standardDeviation), 2);
  if (std::fabs(off) < 0.05) return tr("at population mean (%1 mm, SD %2)").arg(mean, spread);
  return (off < 0.0 ? tr("%1 SD below population mean (%2 mm, SD %3)")
                    : tr("%1 SD above population mean (%2 mm, SD %3)"))
      .arg(numberText(std::fabs(off), 1), mean, spread);
}

}  // namespace

MeasureRow measuredRow(const QString& name, Length value, const Population& population,
                       const std::string& source, Length error)
{
  return {name, withInterval(inMillimeters(value), halfWidth95 * inMillimeters(error), 2),
          placeOf(value, population), source};
}

std::vector<MeasureRow> basalTurnRows(const anatomy::Patient& patient)
{
  const std::string source = "Pietsch et al. 2017";
  const anatomy::BasalTurnErrors errors = analysis::errorsOf(patient);
  std::vector<MeasureRow> rows = {measuredRow(tr("A: basal-turn diameter"), patient.basalTurn->a,
                                              lengthAPopulation(), source, errors.a),
                                  measuredRow(tr("B: basal-turn width"), patient.basalTurn->b,
                                              widthBPopulation(), source, errors.b)};
  if (patient.basalTurn->h)
    rows.push_back(measuredRow(tr("H: cochlear height"), *patient.basalTurn->h, heightHPopulation(),
                               {}, errors.h.value_or(analysis::measuringError)));
  return rows;
}

QString measuresTitle(const anatomy::Patient& patient)
{
  if (patient.seal == Seal::changed) return tr("Cochlea, measures changed by hand");
  QStringList entered;
  for (const std::string& each : enteredMeasures(patient)) entered << QString::fromStdString(each);
  if (!entered.isEmpty())
    return tr("Cochlea, CT measurements, %1 entered, ± 95 % interval")
        .arg(entered.join(QStringLiteral(", ")));
  // a recording keeps the measures, not where they are from
  return anatomy::isFromCt(patient) ? tr("Cochlea, CT measurements ± 95 % interval")
                                    : tr("Cochlea, measures ± 95 % interval");
}

QString measureText(const std::vector<analysis::Measure>& measures,
                    const std::vector<double>& bands, const char* key)
{
  for (std::size_t i = 0; i < measures.size(); ++i) {
    if (measures[i].key != key) continue;
    if (i < bands.size()) return withInterval(measures[i].value, bands[i], 1);
    return tr("%1 mm").arg(numberText(measures[i].value, 1));
  }
  return QStringLiteral("–");
}

MeasureRow ductLengthRow(const QString& value)
{
  return {tr("Cochlear duct length (CDL)"), value,
          tr("elliptic-circular; ± holds what A alone gives"), "Schurzig et al. 2018"};
}

double paintMeasures(ReportSheet& sheet, const QString& title, const std::vector<MeasureRow>& rows,
                     References& references, double y_mm, double width_mm)
{
  y_mm = sheet.heading(0.0, y_mm, width_mm, title);
  const double ends[] = {0.0, 0.27 * width_mm, 0.42 * width_mm, 0.88 * width_mm, width_mm};
  for (const MeasureRow& row : rows) {
    const QString source = row.source.empty() ? QString() : references.label(row.source);
    const QString cells[] = {row.name, row.value, row.place, source};
    const ReportFace faces[] = {ReportFace::text, ReportFace::bold, ReportFace::quiet,
                                ReportFace::quiet};
    for (int i = 0; i < 4; ++i)
      sheet.line({ends[i], y_mm, ends[i + 1] - ends[i] - 1.0, row_mm}, cells[i], faces[i]);
    y_mm += row_mm;
  }
  return y_mm;
}

}  // namespace perilymph::gui

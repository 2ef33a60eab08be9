// SPDX-License-Identifier: BSD-3-Clause
#include "gui/text/ClinicalText.h"

#include <QCoreApplication>
#include <QStringList>

#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "perilymph/analysis/Surgeon.h"

namespace perilymph::gui {

namespace {

using analysis::ClinicalReport;
using analysis::ReportedQuantity;
using analysis::ReportedSpread;

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

const ClinicalReport* find(const std::string& array, ReportedQuantity quantity)
{
  const auto& evidence = analysis::ClinicalEvidence::shipped();
  return evidence ? evidence->find(array, quantity) : nullptr;
}

QString withUnit(const QString& numbers, ReportedQuantity quantity)
{
  switch (quantity) {
    case ReportedQuantity::angle:
      return tr("%1°").arg(numbers);
    case ReportedQuantity::contactsInside:
      return numbers;
    case ReportedQuantity::peakForce:
    case ReportedQuantity::endForce:
      return tr("%1 mN").arg(numbers);
    default:
      return tr("%1 %").arg(numbers);
  }
}

/// "IQR ", "range ": what the bounds of a report are; IQR: from the lower to the upper quartile.
QString spreadText(const ClinicalReport& report)
{
  if (report.spread == ReportedSpread::quartiles) return tr("IQR %1");
  if (report.spread == ReportedSpread::range) return tr("range %1");
  return QStringLiteral("%1");
}

QString numbersText(const ClinicalReport& report)
{
  if (report.count) return tr("%1 of %2").arg(*report.count).arg(report.n);
  const int decimals = report.quantity == ReportedQuantity::contactsInside ? 1 : 0;
  const QString bounds =
      tr("%1–%2").arg(numberText(report.low, decimals), numberText(report.high, decimals));
  if (!report.value) return withUnit(bounds, report.quantity);
  const QString value = numberText(*report.value, decimals);
  if (report.spread == ReportedSpread::none) return withUnit(value, report.quantity);
  if (report.spread == ReportedSpread::sd)
    return withUnit(
        tr("%1 (SD %2)").arg(value, numberText(0.5 * (report.high - report.low), decimals)),
        report.quantity);
  return withUnit(tr("%1 (%2)").arg(value, spreadText(report).arg(bounds)), report.quantity);
}

analysis::ArrayVerdict verdictOf(const std::string& array)
{
  const auto& evidence = analysis::ClinicalEvidence::shipped();
  return evidence ? evidence->verdictOf(array) : analysis::ArrayVerdict::notTested;
}

}  // namespace

QString clinicsReport(const std::string& array, ReportedQuantity quantity)
{
  const ClinicalReport* report = find(array, quantity);
  return report == nullptr ? QString() : numbersText(*report);
}

QString clinicsReportShort(const std::string& array, ReportedQuantity quantity)
{
  const ClinicalReport* report = find(array, quantity);
  if (report == nullptr) return {};
  const bool isForce =
      quantity == ReportedQuantity::peakForce || quantity == ReportedQuantity::endForce;
  if (isForce || !report->value)  // the unit is that of the value above
    return tr("%1–%2").arg(numberText(report->low, 0), numberText(report->high, 0));
  if (report->count && *report->count > 0 && *report->value < 10.0)
    return withUnit(numberText(*report->value, 1), quantity);
  return withUnit(numberText(*report->value, 0), quantity);
}

QString clinicsReportDetails(const std::string& array, ReportedQuantity quantity)
{
  const auto& evidence = analysis::ClinicalEvidence::shipped();
  if (!evidence) return dataText(evidence.error().message);
  QStringList lines;
  for (const ClinicalReport* each : evidence->findAll(array, quantity)) {
    QStringList parts{numbersText(*each)};
    if (each->statistic == "median") parts << tr("median");
    if (each->statistic == "mean") parts << tr("mean");
    if (each->n > 0 && !each->count) parts << tr("n = %1").arg(each->n);
    const std::string& of = each->valueOf.empty() ? each->nOf : each->valueOf;
    if (!of.empty()) parts.back() += tr(" of %1").arg(QString::fromStdString(of));
    lines << tr("Clinics report %1: %2. %3")
                 .arg(parts.join(QStringLiteral(", ")), QString::fromStdString(each->definition),
                      QString::fromStdString(each->source));
  }
  return lines.join(QLatin1Char('\n'));
}

std::string clinicsSource(const std::string& array, ReportedQuantity quantity)
{
  const ClinicalReport* report = find(array, quantity);
  return report == nullptr ? std::string() : report->source;
}

bool isOfArrayAlone(const std::string& array, ReportedQuantity quantity)
{
  const ClinicalReport* report = find(array, quantity);
  return report != nullptr && report->valueOf.empty();
}

QString verdictMark(const std::string& array)
{
  switch (verdictOf(array)) {
    case analysis::ArrayVerdict::miss:
      return tr("not validated");
    case analysis::ArrayVerdict::notTested:
      return tr("not tested");
    case analysis::ArrayVerdict::hit:
      break;
  }
  return {};
}

QString verdictNote(const std::string& array)
{
  const analysis::ArrayVerdict verdict = verdictOf(array);
  if (verdict == analysis::ArrayVerdict::hit) return {};
  if (verdict == analysis::ArrayVerdict::notTested)
    return tr("Not tested: the program’s clinical table has no row of this array.");
  QStringList rows;
  for (const std::string& row : analysis::ClinicalEvidence::shipped()->missedRows(array))
    rows << QString::fromStdString(row);
  return tr("Not validated: the program’s clinical table misses %1.")
      .arg(rows.join(QStringLiteral(", ")));
}

QString planLimitsText()
{
  const auto hand = analysis::shippedHand();
  const QString stops = hand ? tr("%1 to %2 mN")
                                   .arg(numberText(inMillinewtons(hand->stopLow), 0),
                                        numberText(inMillinewtons(hand->stopHigh), 0))
                             : dataText(hand.error().message);
  return tr("Values of the model, not clinical risks: no friction in a living ear is known; the "
            "one "
            "that is taken is estimated from pig tissue, and bands hold its uncertainty. Many "
            "arrays "
            "stop earlier here than clinics report, perimodiolar ones far earlier, and peaks are "
            "bounded by the force at which the simulated hand stops (%1): do not choose a maker by "
            "this table. Translocation is rarer than clinics report.")
      .arg(stops);
}

}  // namespace perilymph::gui

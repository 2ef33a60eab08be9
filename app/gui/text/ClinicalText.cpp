// SPDX-License-Identifier: BSD-3-Clause
#include "gui/text/ClinicalText.h"

#include <QCoreApplication>
#include <QStringList>

#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"

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

QString numbersText(const ClinicalReport& report)
{
  if (report.count) return tr("%1 of %2").arg(*report.count).arg(report.n);
  const int decimals = report.quantity == ReportedQuantity::contactsInside ? 1 : 0;
  const QString bounds =
      tr("%1–%2").arg(numberText(report.low, decimals), numberText(report.high, decimals));
  if (!report.value) return withUnit(bounds, report.quantity);
  const QString value = numberText(*report.value, decimals);
  if (report.spread == ReportedSpread::none) return withUnit(value, report.quantity);
  return withUnit(tr("%1 (%2)").arg(value, bounds), report.quantity);
}

/// "median, quartiles", "mean ± SD", "range".
QString kindText(const ClinicalReport& report)
{
  QStringList parts;
  if (report.statistic == "median") parts << tr("median");
  if (report.statistic == "mean") parts << tr("mean");
  if (report.spread == ReportedSpread::quartiles) parts << tr("quartiles");
  if (report.spread == ReportedSpread::range) parts << tr("range");
  if (report.spread == ReportedSpread::sd) parts << tr("± SD");
  return parts.join(QStringLiteral(", "));
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
    if (const QString kind = kindText(*each); !kind.isEmpty()) parts << kind;
    if (each->n > 0 && !each->count) parts << tr("n = %1").arg(each->n);
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

bool isNotValidated(const std::string& array)
{
  const auto& evidence = analysis::ClinicalEvidence::shipped();
  return evidence && evidence->verdictOf(array) == analysis::ArrayVerdict::miss;
}

QString notValidatedNote(const std::string& array)
{
  if (!isNotValidated(array)) return {};
  QStringList rows;
  for (const std::string& row : analysis::ClinicalEvidence::shipped()->missedRows(array))
    rows << QString::fromStdString(row);
  return tr("Not validated: the program’s clinical table misses %1.")
      .arg(rows.join(QStringLiteral(", ")));
}

QString verdictMark(const std::string& array)
{
  const auto& evidence = analysis::ClinicalEvidence::shipped();
  if (!evidence) return {};
  switch (evidence->verdictOf(array)) {
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
  if (const QString note = notValidatedNote(array); !note.isEmpty()) return note;
  const auto& evidence = analysis::ClinicalEvidence::shipped();
  if (!evidence || evidence->verdictOf(array) == analysis::ArrayVerdict::hit) return {};
  return tr("Not tested: the program’s clinical table has no row of this array.");
}

}  // namespace perilymph::gui

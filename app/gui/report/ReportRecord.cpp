// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/ReportRecord.h"

// In this order: identification, anatomy, picture and results, contacts, limits, signature.

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "gui/report/InsertionResults.h"
#include "gui/report/ReportAnatomy.h"
#include "gui/report/ReportHead.h"
#include "gui/report/ReportPicture.h"
#include "gui/text/Numbers.h"

namespace perilymph::gui {

namespace {

constexpr double gap_mm = 3.0;     // between blocks
constexpr double gutter_mm = 6.0;  // between columns
constexpr double picture_mm = 84.0;

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

/// "Standard, 2.0 mm/s, scripted insertion"
QString techniqueText(const ReportContent& content)
{
  const session::Scenario& scenario = content.scenario;
  const QString technique = scenario.technique() == session::Technique::advanceOffStylet
                                ? tr("Advance off stylet")
                                : tr("Standard");
  const std::string& device = content.facts.device;
  if (device == "Scripted insertion")
    return tr("%1; scripted insertion, %2 mm/s")
        .arg(technique, numberText(inMillimetersPerSecond(scenario.speed()), 1));
  const QString input =
      device == "Mouse and keyboard" ? tr("mouse and keyboard") : QString::fromStdString(device);
  return tr("%1; %2").arg(technique, input);
}

double paintIdentification(ReportSheet& sheet, const ReportContent& content,
                           const ReportIssuer& issuer, double y_mm, double width_mm)
{
  const session::Scenario& scenario = content.scenario;
  const bool isLeft = scenario.patient().side == anatomy::Side::left;
  const double left_mm = 0.43 * width_mm;
  const double left = paintEntries(
      sheet,
      {{tr("Patient code"), content.hasPatient() ? QString::fromStdString(scenario.patient().label)
                                                 : QStringLiteral("–")},
       {tr("Ear"), isLeft ? tr("left ear") : tr("right ear")},
       {tr("Electrode array"), QString::fromStdString(scenario.array().name)},
       {tr("Manufacturer"), QString::fromStdString(scenario.array().maker)}},
      0.0, y_mm, left_mm);
  const double right = paintEntries(sheet,
                                    {{tr("Institution"), issuer.institution},
                                     {tr("Operator"), issuer.operatorName},
                                     {tr("Date and time"), localTimeOf(content.facts.startedUtc)},
                                     {tr("Technique"), techniqueText(content)}},
                                    left_mm + gutter_mm, y_mm, width_mm - left_mm - gutter_mm);
  return std::max(left, right);
}

double paintResults(ReportSheet& sheet, const ReportContent& content, double x_mm, double y_mm,
                    double width_mm)
{
  y_mm = sheet.heading(x_mm, y_mm, width_mm, tr("Results"));
  constexpr double name_mm = 4.0, value_mm = 6.0, detail_mm = 3.4, space_mm = 0.2;
  if (content.plan) {
    sheet.line({x_mm, y_mm, width_mm, detail_mm},
               tr("%1: %2").arg(content.plan->name, content.plan->hold), ReportFace::quiet);
    y_mm += detail_mm + space_mm;
  }
  for (const InsertionResult& result : insertionResults(content)) {
    if (result.isSentence) {
      sheet.line({x_mm, y_mm, width_mm, value_mm}, result.value, ReportFace::bold);
      y_mm += name_mm + 1.0;
      for (const QString& each : result.detail.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
        sheet.line({x_mm, y_mm, width_mm, detail_mm}, each, ReportFace::quiet);
        y_mm += detail_mm + space_mm;
      }
      sheet.rule(x_mm, y_mm + 0.8, width_mm);
      y_mm += 2.0;
      continue;
    }
    constexpr double number_mm = 27.0;
    const double text_mm = width_mm - number_mm;
    sheet.line({x_mm, y_mm, text_mm, name_mm + 1.2}, result.name, ReportFace::text);
    sheet.line({x_mm + text_mm, y_mm, number_mm, value_mm}, result.value, ReportFace::number,
               Qt::AlignRight);
    // the plan's band has the same line
    const QString detail = result.clinics.isEmpty() || !result.plan.isEmpty()
                               ? result.detail
                               : tr("%1; clinics: %2").arg(result.detail, result.clinics);
    sheet.line({x_mm, y_mm + name_mm + 1.0, width_mm, detail_mm}, detail, ReportFace::quiet);
    if (!result.plan.isEmpty())
      sheet.line({x_mm, y_mm + name_mm + 1.0, width_mm, detail_mm},
                 (result.isOutside ? tr("outside the plan, %1") : tr("plan: %1")).arg(result.plan),
                 result.isOutside ? ReportFace::label : ReportFace::quiet, Qt::AlignRight);
    y_mm += name_mm + 1.0 + detail_mm + space_mm;
    sheet.rule(x_mm, y_mm + 0.8, width_mm);
    y_mm += 2.0;
  }
  return y_mm;
}

struct Column {
  QString title;
  double fraction;
};

/// The contacts in two blocks side by side.
double paintContacts(ReportSheet& sheet, const ReportContent& content, double y_mm, double width_mm)
{
  y_mm = sheet.heading(0.0, y_mm, width_mm, tr("Contacts, numbered from the tip"));
  const Column columns[] = {{tr("Contact"), 0.13},
                            {tr("Angle, °"), 0.16},
                            {tr("Frequency, Hz"), 0.25},
                            {tr("To modiolus, mm"), 0.28},
                            {tr("Depth, mm"), 0.18}};
  const std::size_t half = (content.contacts.size() + 1) / 2;
  const double block_mm = 0.5 * (width_mm - gutter_mm);
  constexpr double contactRow_mm = 4.0;
  const auto paintRow = [&](double x_mm, double top_mm, const QStringList& cells, ReportFace face) {
    for (int i = 0; i < cells.size(); ++i) {
      const double cell_mm = columns[i].fraction * block_mm;
      sheet.line({x_mm, top_mm, cell_mm, contactRow_mm}, cells[i], face,
                 i == 0 ? Qt::AlignLeft : Qt::AlignRight);
      x_mm += cell_mm;
    }
  };
  QStringList titles;
  for (const Column& column : columns) titles << column.title;
  for (const double x_mm : {0.0, block_mm + gutter_mm})
    paintRow(x_mm, y_mm, titles, ReportFace::quiet);
  y_mm += contactRow_mm;
  for (std::size_t i = 0; i < content.contacts.size(); ++i) {
    const analysis::ContactPosition& contact = content.contacts[i];
    const double x_mm = i < half ? 0.0 : block_mm + gutter_mm;
    const double top_mm = y_mm + contactRow_mm * double(i < half ? i : i - half);
    const QString number = QString::number(contact.number);
    if (!contact.isInserted) {
      paintRow(x_mm, top_mm, {number}, ReportFace::quiet);
      sheet.line({x_mm, top_mm, 0.54 * block_mm, contactRow_mm}, tr("not inserted"),
                 ReportFace::quiet, Qt::AlignRight);
      continue;
    }
    const QString distance = contact.isAbove ? tr("SV")
                             : contact.toModiolus.si() < 0.0
                                 ? QStringLiteral("–")
                                 : numberText(inMillimeters(contact.toModiolus), 2);
    paintRow(x_mm, top_mm,
             {number, numberText(inDegrees(contact.angle), 0), numberText(contact.frequency_Hz, 0),
              distance, numberText(inMillimeters(contact.depth), 1)},
             ReportFace::text);
  }
  y_mm += contactRow_mm * double(half) + 0.8;
  if (std::ranges::any_of(content.contacts, &analysis::ContactPosition::isAbove))
    y_mm += sheet.paragraph(0.0, y_mm, width_mm,
                            tr("SV: above the cochlear partition, in the scala vestibuli."),
                            ReportFace::quiet);
  return y_mm +
         sheet.paragraph(
             0.0, y_mm, width_mm,
             tr("Angle from the center of the round window. Frequency by Greenwood (1990) at "
                "the place on the organ of Corti. Distance from the center line of the "
                "array to the inner wall. Depth past the opening."),
             ReportFace::quiet);
}

}  // namespace

void paintRecord(ReportSheet& sheet, const ReportContent& content, const ReportIssuer& issuer,
                 const ReportArea& area)
{
  const double width_mm = area.width_mm;
  double y_mm = paintReportTitle(sheet, tr("Insertion report"), area);
  y_mm = paintIdentification(sheet, content, issuer, y_mm, width_mm) + gap_mm;
  y_mm = paintAnatomy(sheet, content, y_mm, width_mm) + gap_mm;

  paintReportPicture(sheet, {0.0, y_mm, picture_mm, picture_mm}, content);
  const double right_mm = picture_mm + gutter_mm;
  const double resultsEnd_mm = paintResults(sheet, content, right_mm, y_mm, width_mm - right_mm);
  y_mm = std::max(y_mm + picture_mm, resultsEnd_mm) + gap_mm;
  y_mm = paintContacts(sheet, content, y_mm, width_mm) + gap_mm;
  y_mm += sheet.paragraph(
      0.0, y_mm, width_mm,
      tr("Limits: computed with a model based on published data, not measured in an ear and not "
         "manufacturer data; no value shows that an insertion is atraumatic."),
      ReportFace::text);
  paintSignature(sheet, y_mm, area);
}

}  // namespace perilymph::gui

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/ReportRecord.h"

// In this order: identification, anatomy, results, curve and pictures, contacts, limits, signature.

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "gui/report/CtPicture.h"
#include "gui/report/InsertionCurve.h"
#include "gui/report/InsertionOutcome.h"
#include "gui/report/InsertionResults.h"
#include "gui/report/ReportAnatomy.h"
#include "gui/report/ReportHeader.h"
#include "gui/report/ReportPicture.h"
#include "gui/report/ReportSetup.h"
#include "gui/run/ScenarioApproach.h"
#include "gui/setup/EarApproach.h"
#include "gui/text/ClinicalText.h"
#include "gui/text/Numbers.h"

namespace perilymph::gui {

namespace {

constexpr double gap_mm = 3.0;     // between blocks
constexpr double gutter_mm = 6.0;  // between columns
constexpr double resultRow_mm = 4.6, contactRow_mm = 4.0;

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

/// "Standard, 2.0 mm/s, scripted insertion"
QString techniqueText(const ReportContent& content)
{
  const session::Scenario& scenario = content.scenario;
  const QString technique = scenario.technique() == session::Technique::advanceOffStylet
                                ? tr("Advance off-stylet")
                                : tr("Standard");
  if (content.facts.isScripted())
    return tr("%1; scripted insertion, %2 mm/s")
        .arg(technique, numberText(inMillimetersPerSecond(scenario.speed()), 1));
  const QString input = content.facts.isByPointer() ? tr("mouse and keyboard")
                                                    : QString::fromStdString(content.facts.device);
  return tr("%1; %2").arg(technique, input);
}

/// "FLEX28, not validated"
QString arrayText(const session::Scenario& scenario)
{
  const QString name = QString::fromStdString(scenario.array().name);
  const QString mark = verdictMark(scenario.arrayName());
  return mark.isEmpty() ? name : tr("%1, %2").arg(name, mark);
}

double paintIdentification(ReportSheet& sheet, const ReportContent& content,
                           const ReportIssuer& issuer, References& references, double y_mm,
                           double width_mm)
{
  const session::Scenario& scenario = content.scenario;
  const bool isLeft = scenario.patient().side == anatomy::Side::left;
  const double left_mm = 0.38 * width_mm;
  const double left = paintEntries(
      sheet,
      {{tr("Patient code"), content.hasPatient() ? QString::fromStdString(scenario.patient().label)
                                                 : QStringLiteral("–")},
       {tr("Ear"), isLeft ? tr("left ear") : tr("right ear")},
       {tr("Landmarks"), landmarksText(content)},
       {tr("Electrode array"), arrayText(scenario)},
       {tr("Manufacturer"), QString::fromStdString(scenario.array().maker)}},
      0.0, y_mm, left_mm);
  const std::vector<ReportEntry> entries = {
      {tr("Institution"), issuer.institution},
      {tr("Operator"), issuer.operatorName},
      {tr("Date and time"), localTimeOf(content.facts.startedUtc)},
      {tr("Technique"), techniqueText(content)},
      {tr("Friction μ"), frictionText(scenario, references)}};
  const double right =
      paintEntries(sheet, entries, left_mm + gutter_mm, y_mm, width_mm - left_mm - gutter_mm);
  return std::max(left, right);
}

/// Columns of the results [mm]: name, value, definition, plan, clinics.
constexpr double resultColumns_mm[] = {37.0, 19.0, 57.0, 38.0, 29.0};

void paintResultRow(ReportSheet& sheet, const QStringList& cells, double y_mm, ReportFace first,
                    ReportFace second, ReportFace plan)
{
  const ReportFace faces[] = {first, second, ReportFace::quiet, plan, ReportFace::quiet};
  double x_mm = 0.0;
  for (int i = 0; i < cells.size(); ++i) {
    // a definition has the room of a plan that is not there
    const double cell_mm =
        resultColumns_mm[i] + (i == 2 && cells[3].isEmpty() ? resultColumns_mm[3] : 0.0);
    sheet.line({x_mm, y_mm, cell_mm - 2.0, resultRow_mm}, cells[i], faces[i],
               i == 1 ? Qt::AlignRight : Qt::AlignLeft);
    x_mm += resultColumns_mm[i];
  }
}

/// What the columns of plan and clinics hold.
QString resultsNote(const ReportContent& content)
{
  const QString clinics = tr("Clinics: median or mean (IQR, range or ± SD) of patients.");
  const QString partition =
      tr("Partition: the model gives fewer translocations than clinics report.");
  QStringList sentences;
  if (content.plan)
    sentences << tr("%1, number %2: %3.")
                     .arg(content.plan->name, content.plan->number, content.plan->hold);
  sentences << clinics << partition;
  if (const QString ears = frictionInEars(content.scenario); !ears.isEmpty())
    sentences << tr("Friction in ears: %1.").arg(ears);
  const anatomy::Approach approach = approachOf(content.scenario);
  if (!isAlongAxis(approach))
    sentences
        << tr("Approach: %1.").arg(approachText(content.scenario.parameters().cochlea, approach));
  return sentences.join(QLatin1Char(' '));
}

double paintResults(ReportSheet& sheet, const ReportContent& content, References& references,
                    double y_mm, double width_mm)
{
  y_mm = sheet.heading(0.0, y_mm, width_mm, tr("Results"));
  const auto results = insertionResults(content);
  for (const InsertionResult& result : results) {
    if (!result.isSentence) continue;
    sheet.line({0.0, y_mm, width_mm, resultRow_mm}, result.value, ReportFace::bold);
    y_mm += resultRow_mm;
    for (const QString& each : result.detail.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
      sheet.line({0.0, y_mm, width_mm, resultRow_mm}, each, ReportFace::quiet);
      y_mm += resultRow_mm;
    }
  }
  if (const auto& passed = content.passedStop) {
    const QString sentence = tr("%1 %2.").arg(passedStopName(*passed), passedStopText(*passed));
    sheet.line({0.0, y_mm, width_mm, resultRow_mm}, sentence, ReportFace::bold);
    y_mm += resultRow_mm;
  }
  paintResultRow(sheet, {{}, {}, {}, content.plan ? tr("plan") : QString(), tr("clinics report")},
                 y_mm, ReportFace::quiet, ReportFace::quiet, ReportFace::quiet);
  y_mm += resultRow_mm - 0.6;
  for (const InsertionResult& result : results) {
    if (result.isSentence) continue;
    const QString plan = result.isOutside ? tr("outside: %1").arg(result.plan) : result.plan;
    const QString clinics =
        result.clinics.isEmpty()
            ? QString()
            : tr("%1 %2").arg(result.clinics, references.label(result.clinicsSource));
    paintResultRow(sheet, {result.name, result.value, result.detail, plan, clinics}, y_mm,
                   ReportFace::text, ReportFace::bold,
                   result.isOutside ? ReportFace::text : ReportFace::quiet);
    sheet.rule(0.0, y_mm + resultRow_mm - 0.2, width_mm);
    y_mm += resultRow_mm;
  }
  y_mm += 0.6;
  return y_mm + sheet.paragraph(0.0, y_mm, width_mm, resultsNote(content), ReportFace::quiet);
}

QString contactsNote(const ReportContent& content)
{
  const QString above =
      std::ranges::any_of(content.contacts, &analysis::ContactPosition::isAbove)
          ? QLatin1Char('\n') + tr("SV: above the cochlear partition, in the scala vestibuli.")
          : QString();
  return tr("Angle from the center of the round window. Frequency by Greenwood's map at the place "
            "on the organ of Corti. Distance from the center line of the array to the inner wall. "
            "Depth past the opening. –: not inserted.") +
         above;
}

constexpr std::size_t contactsOfAStrip = 24;
constexpr int contactRows = 5;

std::size_t stripsOf(const ReportContent& content)
{
  return (content.contacts.size() + contactsOfAStrip - 1) / contactsOfAStrip;
}

double contactsHeight(const ReportSheet& sheet, const ReportContent& content, double width_mm)
{
  constexpr double heading_mm = 7.0;
  return heading_mm + double(stripsOf(content) * contactRows) * contactRow_mm +
         sheet.heightOf(width_mm, contactsNote(content), ReportFace::quiet);
}

/// A contact from its number down to its depth.
QStringList cellsOf(const analysis::ContactPosition& contact)
{
  const QString none = QStringLiteral("–");
  if (!contact.isInserted) return {QString::number(contact.number), none, none, none, none};
  const QString distance = contact.isAbove ? tr("SV")
                           : contact.toModiolus.si() < 0.0
                               ? none
                               : numberText(inMillimeters(contact.toModiolus), 2);
  return {QString::number(contact.number), numberText(inDegrees(contact.angle), 0),
          kilohertzText(contact.frequency_Hz), distance,
          numberText(inMillimeters(contact.depth), 1)};
}

/// The contacts side by side, from the tip.
double paintContacts(ReportSheet& sheet, const ReportContent& content, double y_mm, double width_mm)
{
  y_mm = sheet.heading(0.0, y_mm, width_mm, tr("Contacts, numbered from the tip"));
  const QString names[contactRows] = {tr("Contact"), tr("Angle, °"), tr("Frequency, kHz"),
                                      tr("To modiolus, mm"), tr("Depth, mm")};
  constexpr double names_mm = 26.0;
  const std::size_t across =
      std::min(contactsOfAStrip, std::max<std::size_t>(12, content.contacts.size()));
  const double cell_mm = (width_mm - names_mm) / double(across);
  for (std::size_t strip = 0; strip < stripsOf(content); ++strip) {
    for (int row = 0; row < contactRows; ++row)
      sheet.line({0.0, y_mm + row * contactRow_mm, names_mm - 1.0, contactRow_mm}, names[row],
                 ReportFace::quiet);
    const std::size_t first = strip * contactsOfAStrip;
    for (std::size_t i = first; i < std::min(content.contacts.size(), first + across); ++i) {
      const QStringList cells = cellsOf(content.contacts[i]);
      for (int row = 0; row < contactRows; ++row)
        sheet.line({names_mm + double(i - first) * cell_mm, y_mm + row * contactRow_mm,
                    cell_mm - 0.6, contactRow_mm},
                   cells[row], row == 0 ? ReportFace::bold : ReportFace::text, Qt::AlignRight);
    }
    y_mm += contactRows * contactRow_mm;
  }
  return y_mm + sheet.paragraph(0.0, y_mm, width_mm, contactsNote(content), ReportFace::quiet);
}

QString limitsText()
{
  return tr(
      "Limits: computed with a model based on published data, not measured in an ear and not "
      "manufacturer data; no value shows that an insertion is atraumatic.");
}

/// Force over depth, the array in the cochlea, and the cochlea in the CT where it is kept.
void paintPictures(ReportSheet& sheet, const ReportContent& content, double y_mm, double height_mm,
                   double width_mm)
{
  constexpr double heading_mm = 7.0, fewest_mm = 62.0;
  const QImage ct = cochlearViewOf(content.patient());
  const int pictures = ct.isNull() ? 1 : 2;
  const double side_mm =
      std::min(height_mm - heading_mm, (width_mm - fewest_mm) / pictures - gap_mm);
  const double curve_mm = width_mm - pictures * (side_mm + gap_mm);
  paintInsertionCurve(sheet, {0.0, y_mm, curve_mm, height_mm}, content);
  const double array_mm = curve_mm + gap_mm;
  const double top_mm = sheet.heading(array_mm, y_mm, side_mm, tr("Array in the cochlea"));
  paintReportPicture(sheet, {array_mm, top_mm, side_mm, side_mm}, content);
  if (ct.isNull()) return;
  const double ct_mm = array_mm + side_mm + gap_mm;
  sheet.heading(ct_mm, y_mm, side_mm, tr("CT, cochlear view"));
  paintCtPicture(sheet, {ct_mm, top_mm, side_mm, side_mm}, ct, content.patient());
}

}  // namespace

void paintRecord(ReportSheet& sheet, const ReportContent& content, const ReportIssuer& issuer,
                 References& references, const ReportArea& area)
{
  const double width_mm = area.width_mm;
  double y_mm = paintReportTitle(sheet, tr("Insertion report"), area);
  y_mm = paintIdentification(sheet, content, issuer, references, y_mm, width_mm) + gap_mm;
  y_mm = paintAnatomy(sheet, content, references, y_mm, width_mm) + gap_mm;
  y_mm = paintResults(sheet, content, references, y_mm, width_mm) + gap_mm;

  constexpr double signature_mm = 17.0;
  const double below_mm = contactsHeight(sheet, content, width_mm) + gap_mm +
                          sheet.heightOf(width_mm, limitsText(), ReportFace::text);
  const double pictures_mm = area.bottom_mm - signature_mm - below_mm - gap_mm - y_mm;
  paintPictures(sheet, content, y_mm, pictures_mm, width_mm);
  y_mm += pictures_mm + gap_mm;
  y_mm = paintContacts(sheet, content, y_mm, width_mm) + gap_mm;
  y_mm += sheet.paragraph(0.0, y_mm, width_mm, limitsText(), ReportFace::text);
  paintSignature(sheet, y_mm, area);
}

}  // namespace perilymph::gui

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/ReportRecord.h"

// In this order: identification, anatomy, picture and results, contacts, limits, signature.

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

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

QString mN(double force_N) { return tr("%1 mN").arg(numberText(force_N * 1e3, 0)); }

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

QString ruptureText(const haptics::Translocation& found)
{
  const QString angle = numberText(inDegrees(radians(found.angle)), 0);
  const QString force = numberText(inMillinewtons(newtons(found.force)), 0);
  if (!(found.lengthAbove > 0.0)) return tr("ruptured at %1° by %2 mN").arg(angle, force);
  return tr("translocation: ruptured at %1° by %2 mN, %3 mm above")
      .arg(angle, force, numberText(inMillimeters(meters(found.lengthAbove)), 1));
}

struct ResultRow {
  QString name, value, detail;
};

double paintResults(ReportSheet& sheet, const ReportContent& content, double x_mm, double y_mm,
                    double width_mm)
{
  const analysis::ForceProfile& profile = content.insertion.profile;
  const analysis::Motion& motion = content.insertion.motion;
  const auto inserted = [](const analysis::ContactPosition& each) { return each.isInserted; };
  const auto apical = std::find_if(content.contacts.begin(), content.contacts.end(), inserted);
  const auto basal = std::find_if(content.contacts.rbegin(), content.contacts.rend(), inserted);
  const auto degreesText = [](Angle angle) {
    return tr("%1°").arg(numberText(inDegrees(angle), 0));
  };
  const auto& torn = content.insertion.translocation;
  const QString partition = torn              ? ruptureText(*torn)
                            : content.rupture ? tr("rupture reported at %1–%2 mN (unverified)")
                                                    .arg(numberText(content.rupture->low * 1e3, 0),
                                                         numberText(content.rupture->high * 1e3, 0))
                                              : QString();
  const std::vector<ResultRow> results = {
      {tr("Peak insertion force"), mN(profile.peak.force),
       tr("at insertion depth %1 mm").arg(numberText(profile.peakDepth * 1e3, 1))},
      {tr("Final insertion force"), mN(content.deepest.output.axialForce),
       tr("at maximum insertion depth")},
      {tr("Angular insertion depth"), degreesText(radians(content.deepest.output.angularDepth)),
       apical == content.contacts.end()
           ? tr("of the tip; no contact inserted")
           : tr("of the tip; contacts from %1 to %2")
                 .arg(degreesText(basal->angle), degreesText(apical->angle))},
      {tr("Insertion depth"), tr("%1 mm").arg(numberText(content.deepest.output.depth * 1e3, 1)),
       tr("past the opening")},
      {tr("Insertion time"), tr("%1 s").arg(numberText(motion.time - motion.timeStill, 1)),
       tr("without pauses, to maximum depth; reversals: %1").arg(motion.reversals)},
      {tr("Maximum partition force"),
       std::isnan(profile.partitionForceMax) ? tr("not recorded") : mN(profile.partitionForceMax),
       partition}};
  y_mm = sheet.heading(x_mm, y_mm, width_mm, tr("Results"));
  constexpr double name_mm = 4.0, value_mm = 6.0, detail_mm = 3.4, space_mm = 0.2;
  for (const ResultRow& result : results) {
    constexpr double number_mm = 27.0;
    const double text_mm = width_mm - number_mm;
    sheet.line({x_mm, y_mm, text_mm, name_mm + 1.2}, result.name, ReportFace::text);
    sheet.line({x_mm + text_mm, y_mm, number_mm, value_mm}, result.value, ReportFace::number,
               Qt::AlignRight);
    sheet.line({x_mm, y_mm + name_mm + 1.0, width_mm, detail_mm}, result.detail, ReportFace::quiet);
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

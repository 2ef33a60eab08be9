// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/OutcomeReport.h"

#include <QCoreApplication>
#include <algorithm>

#include "gui/report/ReportPages.h"
#include "gui/setup/OutcomeWords.h"
#include "gui/setup/PatientHistory.h"
#include "gui/setup/PatientLibrary.h"
#include "gui/setup/PlannedFriction.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/DrawingPainter.h"
#include "perilymph/foundation/UtcTime.h"

namespace perilymph::gui {

namespace {

constexpr double between_mm = 3.0, gutter_mm = 6.0;
constexpr double contactRow_mm = 4.0, lowContactRow_mm = 3.2;  // lower where there are many
constexpr std::size_t manyContacts = 16;
constexpr double view_mm = 58.0, unrolled_mm = 30.0, signature_mm = 17.0;

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

QString nowText() { return localTimeOf(utcNow()); }

/// What the surgeon stated, an entry each; what is not known is left out.
QStringList surgeryWords(const outcome::Surgery& surgery)
{
  QStringList words;
  if (surgery.stopReason != outcome::StopReason::unknown)
    words << tr("stopped because of: %1").arg(textOf(surgery.stopReason));
  if (surgery.isMarkReached)
    words << (*surgery.isMarkReached ? tr("intended mark reached")
                                     : tr("intended mark not reached"));
  if (surgery.intendedDepth)
    words << tr("intended depth %1 mm").arg(numberText(inMillimeters(*surgery.intendedDepth), 1));
  if (surgery.contactsOutside)
    words << tr("contacts outside, as seen: %1").arg(*surgery.contactsOutside);
  if (surgery.outside)
    words << tr("length outside %1 mm").arg(numberText(inMillimeters(*surgery.outside), 1));
  if (surgery.opening != outcome::Opening::unknown) words << textOf(surgery.opening);
  if (surgery.tool != outcome::Tool::unknown) words << textOf(surgery.tool);
  if (!surgery.lubricant.empty()) words << QString::fromStdString(surgery.lubricant);
  if (!surgery.lot.empty()) words << tr("lot %1").arg(QString::fromStdString(surgery.lot));
  if (surgery.attempts) words << tr("attempts: %1").arg(*surgery.attempts);
  if (surgery.pullBacks) words << tr("pull-backs: %1").arg(*surgery.pullBacks);
  if (surgery.contactAtResistance)
    words << tr("first resistance at contact %1").arg(*surgery.contactAtResistance);
  if (surgery.daysToCt) words << tr("CT %1 days after surgery").arg(*surgery.daysToCt);
  return words;
}

double paintIdentification(ReportSheet& sheet, const OutcomeReportContent& report,
                           const ReportIssuer& issuer, double y_mm, double width_mm)
{
  const outcome::FoundArray& found = report.content.found;
  const std::string code = codeOf(report.patient);
  const double left_mm = 0.5 * width_mm;
  const double left = paintEntries(
      sheet,
      {{tr("Patient code"), code.empty() ? QStringLiteral("–") : QString::fromStdString(code)},
       {tr("Ear"), report.patient.side == anatomy::Side::left ? tr("left ear") : tr("right ear")},
       {tr("Array"), arrayTitle(found.array)},
       {tr("CT after surgery"),
        tr("series %1").arg(QString::fromStdString(report.content.series.substr(0, 12)))}},
      0.0, y_mm, left_mm);
  const double right = paintEntries(
      sheet,
      {{tr("Institution"), issuer.institution},
       {tr("Operator"), issuer.operatorName},
       {tr("Date and time"), nowText()},
       {tr("Plan"), report.plan
                        ? tr("%1, of %2")
                              .arg(QString::fromStdString(report.content.plan.substr(0, 16)),
                                   localTimeText(report.planMadeUtc))
                        : tr("no plan of this array")}},
      left_mm + gutter_mm, y_mm, width_mm - left_mm - gutter_mm);
  return std::max(left, right);
}

double paintResults(ReportSheet& sheet, const OutcomeReportContent& report, double y_mm,
                    double width_mm)
{
  const outcome::FoundArray& found = report.content.found;
  const planning::ArrayPlan* plan = report.arrayPlan();
  y_mm = sheet.heading(0.0, y_mm, width_mm, tr("What was found, beside the plan"));
  const double columns_mm[] = {0.3 * width_mm, 0.27 * width_mm, 0.27 * width_mm, 0.16 * width_mm};
  const auto row = [&](const QStringList& cells, ReportFace face) {
    double x_mm = 0.0;
    for (int k = 0; k < cells.size(); ++k) {
      sheet.line({x_mm, y_mm, columns_mm[k], contactRow_mm}, cells[k], face);
      x_mm += columns_mm[k];
    }
    y_mm += contactRow_mm + 0.2;
  };
  const QString none = QStringLiteral("–");
  row({QString(), tr("found (95 %)"), tr("plan (band)"), tr("percentile")}, ReportFace::quiet);
  row({tr("Angular insertion depth"), depthText(found),
       plan ? bandWords(plan->angle_deg, 0, tr("°")) : none,
       plan ? percentileText(report.ends.angles_deg, plan->angle_deg,
                             found.angularInsertionDepth_deg)
            : none},
      ReportFace::text);
  row({tr("Inserted length"), insertedText(found),
       plan ? bandWords(plan->depth_mm, 1, tr(" mm")) : none,
       plan ? percentileText(report.ends.depths_mm, plan->depth_mm,
                             {found.insertedLength_mm, found.insertedLengthSd_mm})
            : none},
      ReportFace::text);
  row({tr("Contacts inside"), insideText(found), none, none}, ReportFace::text);
  return y_mm;
}

double paintContacts(ReportSheet& sheet, const OutcomeReportContent& report, double y_mm,
                     double width_mm)
{
  const outcome::FoundArray& found = report.content.found;
  const planning::ArrayPlan* plan = report.arrayPlan();
  y_mm = sheet.heading(
      0.0, y_mm, width_mm,
      tr("Contacts, 1 at the tip; E: the electrode’s number in its maker’s fitting software"));
  const double high_mm = found.contacts.size() > manyContacts ? lowContactRow_mm : contactRow_mm;
  const double shares[] = {0.065, 0.125, 0.125, 0.095, 0.05, 0.075, 0.075, 0.14, 0.08, 0.09, 0.08};
  const auto row = [&](const QStringList& cells, ReportFace face) {
    double x_mm = 0.0;
    for (int k = 0; k < cells.size(); ++k) {
      sheet.line({x_mm, y_mm, shares[k] * width_mm, high_mm}, cells[k], face);
      x_mm += shares[k] * width_mm;
    }
    y_mm += high_mm;
  };
  row({tr("No."), tr("angle (95 %)"), tr("plan (band)"), tr("percentile"), tr("in ST"),
       tr("mod., mm"), tr("GW, kHz"), tr("SG, kHz (95 %)"), tr("filter, kHz"),
       tr("mismatch, st (95 %)"), tr("placed")},
      ReportFace::quiet);
  sheet.rule(0.0, y_mm, width_mm);
  for (const outcome::FoundContact& each : found.contacts) {
    const planning::ContactBand* planned = nullptr;
    if (plan != nullptr)
      for (const planning::ContactBand& band : plan->contacts)
        if (band.number == each.number && band.draws > 0) planned = &band;
    const QString none = QStringLiteral("–");
    row({contactText(each), angleText(each),
         planned ? bandWords(planned->angle_deg, 0, tr("°")) : none,
         planned && each.isInside ? percentileText(planned->angle_deg, each.angle_deg.value) : none,
         scalaText(each), each.isInside ? numberText(each.modiolus_mm, 2) : none,
         each.isInside ? kilohertzText(each.greenwood_Hz[0]) : none,
         each.isInside ? tr("%1 (%2–%3)")
                             .arg(kilohertzText(each.spiralGanglion_Hz[0]),
                                  kilohertzText(each.spiralGanglion_Hz[1]),
                                  kilohertzText(each.spiralGanglion_Hz[2]))
                       : none,
         each.filter_Hz > 0.0 ? kilohertzText(each.filter_Hz) : none, mismatchText(each),
         placementText(each)},
        ReportFace::label);
  }
  return y_mm;
}

void paintDrawing(ReportSheet& sheet, const figures::Drawing& drawing, const QRectF& place_mm)
{
  const QRectF place = sheet.dots(place_mm);
  const double scale = std::min(place.width() / drawing.width, place.height() / drawing.height);
  QPainter& painter = sheet.painter();
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(place.topLeft());
  painter.scale(scale, scale);
  paintMarks(painter, drawing, Lettering::scaled);
  painter.restore();
}

/// Pictures side by side, or what room is left for.
double paintPictures(ReportSheet& sheet, const OutcomeReportContent& report, double y_mm,
                     double room_mm, double width_mm)
{
  const double high_mm = std::min(room_mm, view_mm);
  double left_mm = 0.0;
  if (!report.view.isNull() && high_mm > 0.5 * view_mm) {
    const QRectF place = sheet.dots({0.0, y_mm, high_mm, high_mm});
    const int side = std::min(report.view.width(), report.view.height());
    const QRect middle((report.view.width() - side) / 2, (report.view.height() - side) / 2, side,
                       side);
    sheet.painter().drawImage(place, report.view, middle);
    left_mm = high_mm + gutter_mm;
  }
  if (!report.unrolled.marks.empty() && room_mm >= unrolled_mm)
    paintDrawing(sheet, report.unrolled, {left_mm, y_mm, width_mm - left_mm, high_mm});
  return left_mm > 0.0 ? y_mm + high_mm : y_mm + unrolled_mm;
}

void paintOutcome(ReportSheet& sheet, const OutcomeReportContent& report,
                  const ReportIssuer& issuer, const ReportArea& area)
{
  const double width_mm = area.width_mm;
  double y_mm = paintReportTitle(sheet, tr("Outcome of an implantation"), area);
  y_mm = paintIdentification(sheet, report, issuer, y_mm, width_mm) + between_mm;
  y_mm = paintResults(sheet, report, y_mm, width_mm) + 1.0;
  QString source = earSourceText(report.content.found);
  source[0] = source[0].toUpper();
  const QStringList surgery = surgeryWords(report.content.surgery);
  QStringList lines{source + QLatin1Char('.')};
  if (!surgery.isEmpty()) lines << tr("The surgeon states: %1.").arg(surgery.join(tr("; ")));
  for (const QString& line : lines)
    y_mm += sheet.paragraph(0.0, y_mm, width_mm, line, ReportFace::text) + 0.6;
  QStringList doubts = contradictionTexts(report.content.surgery, report.content.found) +
                       flagTexts(report.content.found);
  if (!report.planDoubt.isEmpty()) doubts.prepend(report.planDoubt);
  for (const QString& flag : doubts)
    y_mm += sheet.paragraph(0.0, y_mm, width_mm, flag, ReportFace::bold) + 0.6;
  y_mm = paintContacts(sheet, report, y_mm + between_mm, width_mm) + between_mm;

  QString method = tr(
      "Positions are those of metal in the CT, with their errors; the basilar membrane is not "
      "visible, so that in scala tympani (ST) is a probability and no diagnosis. mod.: distance to "
      "the inner wall. Place frequencies are estimated, GW by Greenwood’s map, SG on the spiral "
      "ganglion; their intervals are those of the angle, and listeners vary beyond them. filter: "
      "center of the default filter; mismatch: SG above it, in semitones. Plan: median and "
      "band of simulated insertions, of a contact those in which it is inside; percentile: share "
      "of them below the value found. Angles are counted from the round window.");
  if (report.plan) method += QLatin1Char(' ') + tr("Bands: %1.").arg(bandsHold(report.plan->plan));
  const double method_mm = sheet.heightOf(width_mm, method, ReportFace::quiet);
  const double room_mm = area.bottom_mm - signature_mm - method_mm - 2.0 * between_mm - y_mm;
  if (room_mm > unrolled_mm)
    y_mm = paintPictures(sheet, report, y_mm, room_mm, width_mm) + between_mm;
  y_mm += sheet.paragraph(0.0, y_mm, width_mm, method, ReportFace::quiet);
  paintSignature(sheet, y_mm, area);
}

}  // namespace

ReportIdentity OutcomeReportContent::identity() const
{
  return {"Outcome of an implantation", codeOf(patient), content.series};
}

Result<void> writeOutcomeReport(const OutcomeReportContent& content,
                                const std::filesystem::path& file)
{
  ReportPages pages;
  pages.title = tr("Outcome of an implantation");
  pages.subject = tr("Patient %1").arg(nameOfPatient(content.patient));
  pages.time = nowText();
  pages.paintRecord = [&](ReportSheet& sheet, const ReportIssuer& issuer, const ReportArea& area) {
    paintOutcome(sheet, content, issuer, area);
  };
  return writeReportPages(pages, file);
}

}  // namespace perilymph::gui

// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/PlanRecord.h"

#include <QCoreApplication>
#include <algorithm>

#include "gui/report/MeasureTable.h"
#include "gui/report/PlanCurves.h"
#include "gui/report/PlanPicture.h"
#include "gui/report/ReportSetup.h"
#include "gui/setup/EarApproach.h"
#include "gui/setup/MeasureVersions.h"
#include "gui/setup/PlannedFriction.h"
#include "gui/text/ClinicalText.h"
#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "perilymph/foundation/UtcTime.h"

namespace perilymph::gui {

namespace {

constexpr double gap_mm = 3.0;     // between blocks
constexpr double gutter_mm = 6.0;  // between columns
constexpr double maxPicture_mm = 92.0;
constexpr double minPicture_mm = 36.0;  // lower, nothing is seen: the curves are on the next page
constexpr std::size_t manyArrays = 8;   // more have lower rows
constexpr double row_mm = 4.3, lowRow_mm = 3.0;

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

/// The number to 16 digits, and what else number() says.
QString shortNumber(const PlanReportContent& content)
{
  constexpr int digits = 16;
  const int all = static_cast<int>(content.plan().fingerprint.size());
  QString number = content.number();
  return all > digits ? number.remove(digits, all - digits) : number;
}

double paintIdentification(ReportSheet& sheet, const PlanReportContent& content,
                           const ReportIssuer& issuer, double y_mm, double width_mm)
{
  const planning::Plan& plan = content.plan();
  const std::string& software = plan.request.patient.origin.software;
  const bool isChanged = plan.request.patient.seal == Seal::changed;
  const double left_mm = 0.43 * width_mm;
  const double left =
      paintEntries(sheet,
                   {{tr("Patient code"), content.code()},
                    {tr("Ear"), content.ear()},
                    {tr("Measured with"), isChanged          ? tr("changed by hand")
                                          : software.empty() ? QStringLiteral("–")
                                                             : QString::fromStdString(software)},
                    {tr("Landmarks"), landmarksText(plan.request.patient)},
                    {tr("Simulations"), tr("%1 of each array").arg(plan.arrays.front().draws)}},
                   0.0, y_mm, left_mm);
  const double right = paintEntries(sheet,
                                    {{tr("Institution"), issuer.institution},
                                     {tr("Operator"), issuer.operatorName},
                                     {tr("Date and time"), localTimeOf(utcNow())},
                                     {tr("Plan"), shortNumber(content)}},
                                    left_mm + gutter_mm, y_mm, width_mm - left_mm - gutter_mm);
  return std::max(left, right);
}

struct Column {
  QString upper, lower;  ///< Its title.
  double width_mm;
};

/// Cells of an array in the order of the columns.
QStringList cellsOf(const planning::ArrayPlan& array, std::size_t place)
{
  return {numberedName(array, place),
          medianText(array.angle_deg, 0),
          medianText(array.coverage_percent, 0),
          medianText(array.peak_mN, 0),
          medianText(array.partition_mN, forceDecimals(array.partition_mN.high)),
          chanceText(array.allInside, array.draws),
          chanceText(array.resisted, array.draws),
          chanceText(array.buckled, array.draws),
          chanceText(array.foldedTip, array.draws),
          chanceText(array.ruptured, array.draws)};
}

/// What clinics report below the values of an array, in the order of the columns.
QStringList clinicsOf(const planning::ArrayPlan& array)
{
  using analysis::ReportedQuantity;
  const auto reported = [&array](ReportedQuantity quantity) {
    const QString text = clinicsReportShort(array.array, quantity);
    return text.isEmpty() || isOfArrayAlone(array.array, quantity) ? text : text + tr(" †");
  };
  const QString mark = verdictMark(array.array);
  return {mark.isEmpty() ? tr("clinics report") : tr("%1; clinics").arg(mark),
          reported(ReportedQuantity::angle),
          {},
          reported(ReportedQuantity::peakForce),
          {},
          reported(ReportedQuantity::complete),
          {},
          {},
          reported(ReportedQuantity::foldOver),
          reported(ReportedQuantity::translocation)};
}

/// The label of all that the rows of clinics rest on.
QString clinicsLabel(const std::vector<planning::ArrayPlan>& arrays, References& references)
{
  using analysis::ReportedQuantity;
  std::string sources;
  for (const planning::ArrayPlan& each : arrays)
    for (const ReportedQuantity quantity :
         {ReportedQuantity::angle, ReportedQuantity::peakForce, ReportedQuantity::complete,
          ReportedQuantity::foldOver, ReportedQuantity::translocation})
      sources += clinicsSource(each.array, quantity) + "; ";
  return references.label(sources);
}

double paintArrays(ReportSheet& sheet, const PlanReportContent& content, References& references,
                   double y_mm, double width_mm)
{
  const QString hold = bandsHold(content.plan());
  const auto& arrays = content.plan().arrays;
  y_mm = sheet.heading(0.0, y_mm, width_mm, tr("Arrays in this cochlea: median (%1)").arg(hold));
  constexpr double chance_mm = 15.4;  // of "100 (68–100)"
  constexpr double force_mm = 18.2;   // of "100 (100–140)"
  constexpr double between_mm = 2.0;  // columns
  const bool isCounted = arrays.front().draws < analysis::fewestForPercent;
  // in two rows
  const Column columns[] = {{{}, tr("Array"), 29.0},
                            {tr("Angular"), tr("depth, °"), force_mm},
                            {{}, tr("Coverage, %"), 17.4},
                            {tr("Peak"), tr("force, mN"), force_mm},
                            {tr("Partition"), tr("force, mN"), force_mm},
                            {{}, tr("All inside"), chance_mm},
                            {{}, tr("Resistance"), 17.4},
                            {{}, tr("Buckled"), chance_mm},
                            {{}, tr("Tip fold"), chance_mm},
                            {{}, tr("Rupture"), chance_mm}};
  double high_mm = row_mm;
  const auto paintRow = [&](const QStringList& cells, ReportFace face = ReportFace::label) {
    double x_mm = 0.0;
    for (int i = 0; i < cells.size(); ++i) {
      const double before_mm = i == 0 ? 0.0 : between_mm;
      sheet.line({x_mm + before_mm, y_mm, columns[i].width_mm - before_mm, high_mm}, cells[i], face,
                 i == 0 ? Qt::AlignLeft : Qt::AlignRight);
      x_mm += columns[i].width_mm;
    }
    y_mm += high_mm;
  };
  QStringList upper, lower;
  for (const Column& column : columns) upper << column.upper, lower << column.lower;
  constexpr double chances_mm = 4 * chance_mm + 17.4;
  sheet.line({width_mm - chances_mm, y_mm, chances_mm, high_mm},
             isCounted ? tr("number of simulations") : tr("share of simulations, %"),
             ReportFace::label, Qt::AlignRight);
  paintRow(upper);
  y_mm -= 0.9;
  paintRow(lower);
  sheet.rule(0.0, y_mm, width_mm);
  const bool areMany = arrays.size() > manyArrays;
  if (areMany) high_mm = lowRow_mm;
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    QStringList cells = cellsOf(arrays[i], i);
    if (areMany && !verdictMark(arrays[i].array).isEmpty()) cells[0] += QStringLiteral(" *");
    paintRow(cells);
    const QStringList clinics = clinicsOf(arrays[i]);
    // what clinics report of many would leave no room for the signature
    if (areMany) continue;
    y_mm -= 0.6;
    paintRow(clinics, ReportFace::quiet);
  }
  y_mm += 0.6;
  return y_mm +
         sheet.paragraph(
             0.0, y_mm, width_mm,
             tr("Angle and coverage of the most apical contact. Shares, from %1 simulations "
                "on with 95 % intervals: all contacts inside, stop by resistance, buckling in "
                "front of the opening, tip fold-over, a force that reaches the strength of "
                "the cochlear partition. Clinics: medians or means of patients, angular "
                "depth, complete insertions, tip fold-over and translocation %2. Strength "
                "of the partition: assumed; original not available; the model gives fewer "
                "translocations than clinics report. †: of a group of arrays or of one that is not "
                "named, not of this one. Not validated, not tested, or *: the program’s clinical "
                "table misses a row of this array, or has none.")
                 .arg(analysis::fewestForPercent)
                 .arg(clinicsLabel(arrays, references)),
             ReportFace::quiet);
}

/// Why the whole report may not be of this patient, or not of this program; first on the page.
QStringList doubtsOf(const PlanReportContent& content)
{
  QStringList doubts;
  if (const Sentence note = noteOn(content.plan().seal); !note.empty()) doubts << dataText(note);
  if (const Sentence note = noteOn(content.plan().request.patient); !note.empty())
    doubts << dataText(note);
  if (const QString note = supersededText(content.plan().request.patient); !note.isEmpty())
    doubts << note;
  if (content.isStudyNotCompared)
    doubts << tr(
        "The plan states no CT series, or carries no seal, so it was not compared with the study "
        "that this report was filed into.");
  return doubts;
}

/// Height of paragraphs [mm].
double heightOf(const ReportSheet& sheet, const QStringList& lines, double width_mm)
{
  double height_mm = 0.0;
  for (const QString& line : lines)
    height_mm += sheet.heightOf(width_mm, line, ReportFace::quiet) + 0.4;
  return height_mm;
}

/// Method and limits at the lower end of the page: as many of the limits, the last first, as leave
/// the pictures their room; the appendix has all.
QStringList linesOf(const ReportSheet& sheet, const PlanReportContent& content, double width_mm,
                    double room_mm)
{
  QStringList lines = {
      tr("Method: each array is inserted by a simulated hand %1 times (%2). Every time A, B and H "
         "within their errors, the shape of the cochlea, speed, tremor, grip, force limit, "
         "intended "
         "depth, friction, approach, and stiffness and packing of the array's wires are drawn "
         "again; see the appendix.")
          .arg(content.plan().arrays.front().draws)
          .arg(plannedFriction(content.plan()))};
  if (const auto& approach = content.plan().request.approach)
    lines.front() +=
        QLatin1Char(' ') +
        tr("Approach, from which simulations deviate: %1.")
            .arg(approachText({anatomy::AnatomySource::mean, content.plan().request.patient},
                              *approach));
  lines.prepend(planLimitsText());
  const auto& limits = content.stored.limits;
  for (auto limit = limits.rbegin(); limit != limits.rend(); ++limit) {
    lines.insert(2, dataText(*limit));
    if (limit == limits.rbegin() || heightOf(sheet, lines, width_mm) <= room_mm) continue;
    lines.removeAt(2);
    break;
  }
  return lines;
}

}  // namespace

void paintPlanRecord(ReportSheet& sheet, const PlanReportContent& content,
                     const ReportIssuer& issuer, References& references, const ReportArea& area)
{
  const double width_mm = area.width_mm;
  double y_mm = paintReportTitle(sheet, tr("Insertion plan"), area);
  for (const QString& doubt : doubtsOf(content))
    y_mm += sheet.paragraph(0.0, y_mm, width_mm, doubt, ReportFace::bold) + 1.0;
  y_mm = paintIdentification(sheet, content, issuer, y_mm, width_mm) + gap_mm;
  std::vector<MeasureRow> rows = basalTurnRows(content.plan().request.patient);
  rows.push_back(ductLengthRow(measureText(content.measures, content.bands, "cdl_oc_mm")));
  y_mm = paintMeasures(sheet, measuresTitle(content.plan().request.patient), rows, references, y_mm,
                       width_mm) +
         gap_mm;
  y_mm = paintArrays(sheet, content, references, y_mm, width_mm) + gap_mm;

  constexpr double heading_mm = 7.0, signature_mm = 17.0, wantedPicture_mm = 66.0;
  const QStringList lines =
      linesOf(sheet, content, width_mm,
              area.bottom_mm - signature_mm - heading_mm - gap_mm - wantedPicture_mm - y_mm);
  const double limits_mm = heading_mm + heightOf(sheet, lines, width_mm);
  const double free_mm = area.bottom_mm - signature_mm - limits_mm - gap_mm - y_mm;
  if (free_mm >= minPicture_mm) {
    const double picture_mm = std::min(free_mm, maxPicture_mm);
    const bool isAlone = content.plan().arrays.size() == 1;
    const double left_mm = isAlone ? picture_mm : std::max(picture_mm, 0.45 * width_mm);
    paintPlanPicture(sheet, {0.0, y_mm, left_mm, picture_mm}, content);
    const double right_mm = left_mm + gutter_mm;
    paintPlanCurves(sheet, {right_mm, y_mm, width_mm - right_mm, picture_mm}, content);
    y_mm += picture_mm + gap_mm;
  }
  y_mm = sheet.heading(0.0, y_mm, width_mm, tr("Method and limits; all limits in the appendix"));
  for (const QString& line : lines)
    y_mm += sheet.paragraph(0.0, y_mm, width_mm, line, ReportFace::quiet) + 0.4;
  paintSignature(sheet, y_mm, area);
}

}  // namespace perilymph::gui

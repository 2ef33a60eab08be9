// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/PlanInfluences.h"

#include <QCoreApplication>
#include <algorithm>

#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"

namespace perilymph::gui {

namespace {

constexpr std::size_t maxInputs = 8;
constexpr double minFraction = 0.01;
constexpr double row_mm = 3.9, title_mm = 9.0, gap_mm = 4.0, names_mm = 34.0, number_mm = 7.0;
constexpr std::size_t columns = 2;

const QColor angleInk(0x00, 0x5A, 0xA0), peakInk(0xBE, 0x46, 0x00);

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

double strongest(const planning::Influence& each) { return std::max(each.onAngle, each.onPeak); }

/// Those that are drawn, the strongest first.
std::vector<planning::Influence> drawnOf(const planning::ArrayPlan& array)
{
  std::vector<planning::Influence> drawn;
  for (const planning::Influence& each : array.influences)
    if (strongest(each) >= minFraction) drawn.push_back(each);
  std::ranges::stable_sort(drawn, std::greater<>(), strongest);
  if (drawn.size() > maxInputs) drawn.resize(maxInputs);
  return drawn;
}

std::size_t rowsOf(const PlanReportContent& content)
{
  std::size_t rows = 0;
  for (const planning::ArrayPlan& each : content.plan().arrays)
    rows = std::max(rows, drawnOf(each).size());
  return rows;
}

double heightOf(const PlanReportContent& content)
{
  return title_mm + row_mm * double(rowsOf(content)) + gap_mm;
}

/// As many as fit on a page of the report.
std::size_t chartsOnAPage(const PlanReportContent& content)
{
  constexpr double room_mm = 225.0;
  return columns * std::max<std::size_t>(1, std::size_t(room_mm / heightOf(content)));
}

/// A bar from the middle, with its percent behind its end.
void paintBar(ReportSheet& sheet, double middle_mm, double y_mm, double length_mm, double fraction,
              const QColor& ink, bool isLeft)
{
  const double end_mm = isLeft ? middle_mm - length_mm : middle_mm + length_mm;
  sheet.painter().fillRect(
      sheet.dots({std::min(middle_mm, end_mm), y_mm + 0.5, length_mm, row_mm - 1.0}), ink);
  sheet.line({isLeft ? end_mm - number_mm - 0.6 : end_mm + 0.6, y_mm, number_mm, row_mm},
             numberText(100.0 * fraction, 0), ReportFace::label,
             isLeft ? Qt::AlignRight : Qt::AlignLeft);
}

void paintChart(ReportSheet& sheet, const PlanReportContent& content, std::size_t i, double x_mm,
                double y_mm, double width_mm)
{
  const planning::ArrayPlan& array = content.plan().arrays[i];
  const double half_mm = 0.5 * (width_mm - names_mm), middle_mm = x_mm + names_mm + half_mm;
  const double full_mm = half_mm - number_mm - 1.0;  // of a share of 1
  sheet.line({x_mm, y_mm, width_mm, 4.4}, numberedName(array, i), ReportFace::bold);
  y_mm += 4.4;
  sheet.line({middle_mm - half_mm, y_mm, half_mm - 1.0, row_mm}, tr("angle, %"), ReportFace::label,
             Qt::AlignRight);
  sheet.line({middle_mm + 1.0, y_mm, half_mm - 1.0, row_mm}, tr("peak force, %"),
             ReportFace::label);
  y_mm += row_mm;
  for (const planning::Influence& each : drawnOf(array)) {
    sheet.line({x_mm, y_mm, names_mm - 1.0, row_mm}, dataText(each.input), ReportFace::label);
    paintBar(sheet, middle_mm, y_mm, full_mm * std::clamp(each.onAngle, 0.0, 1.0), each.onAngle,
             angleInk, true);
    paintBar(sheet, middle_mm, y_mm, full_mm * std::clamp(each.onPeak, 0.0, 1.0), each.onPeak,
             peakInk, false);
    y_mm += row_mm;
  }
}

}  // namespace

std::size_t influencePages(const PlanReportContent& content)
{
  if (rowsOf(content) == 0) return 0;
  const std::size_t charts = content.plan().arrays.size(), atOnce = chartsOnAPage(content);
  return (charts + atOnce - 1) / atOnce;
}

void paintPlanInfluences(ReportSheet& sheet, const PlanReportContent& content, std::size_t page,
                         const ReportArea& area)
{
  double y_mm = sheet.heading(0.0, area.top_mm, area.width_mm,
                              tr("What decides angle and peak force: share of the variance"));
  y_mm += sheet.paragraph(0.0, y_mm, area.width_mm,
                          tr("Inputs from the strongest on, at most %1 of each array; shares below "
                             "%2 % are not drawn. Blue: angular depth; orange: peak force.")
                              .arg(maxInputs)
                              .arg(numberText(100.0 * minFraction, 0)),
                          ReportFace::quiet) +
          gap_mm;
  constexpr double gutter_mm = 8.0;
  const double width_mm = (area.width_mm - gutter_mm) / double(columns);
  const std::size_t first = page * chartsOnAPage(content),
                    end = std::min(content.plan().arrays.size(), first + chartsOnAPage(content));
  for (std::size_t i = first; i < end; ++i)
    paintChart(sheet, content, i, double((i - first) % columns) * (width_mm + gutter_mm),
               y_mm + double((i - first) / columns) * heightOf(content), width_mm);
}

}  // namespace perilymph::gui

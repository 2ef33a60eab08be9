// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/PlanCurves.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "gui/report/ReportChart.h"
#include "perilymph/figures/Figure.h"
#include "perilymph/planning/ForceCourse.h"

namespace perilymph::gui {

namespace {

constexpr double axis_mm = ReportChart::axis_mm, label_mm = ReportChart::label_mm;
constexpr double minHeight_mm = 16.0;   // of a chart
constexpr double minCounted_mm = 14.0;  // of a plot; in a lower one the counts cover the curve
constexpr double head_mm = 12.0;        // heading and a line of text above the charts
constexpr double broad_mm = 110.0;      // has room for three charts side by side

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

struct Axes {
  figures::FigureAxis depth, force;
};

Axes axesOf(const std::vector<planning::ArrayPlan>& arrays, std::size_t count)
{
  double deepest = 1.0, highest = 1.0;
  for (std::size_t i = 0; i < count; ++i)
    for (const planning::ForceBand& each : arrays[i].force) {
      deepest = std::max(deepest, each.depth_mm);
      highest = std::max(highest, each.force_mN.high);
    }
  return {figures::axisOver({}, 0.0, deepest), figures::axisOver({}, 0.0, highest)};
}

/// "3 of 16"; outside of the class, whose texts lupdate would assign to it.
QString countText(std::size_t draws, std::size_t of) { return tr("%1 of %2").arg(draws).arg(of); }

/// One chart in its place.
class Chart {
public:
  Chart(ReportSheet& sheet, const QRectF& place_mm, const Axes& axes)
      : sheet_(sheet),
        chart_(sheet, place_mm, axes.depth, axes.force),
        plot_mm_(chart_.plot_mm()),
        place_mm_(place_mm),
        axes_(axes)
  {
  }

  void paint(const planning::ArrayPlan& array, std::size_t place) const
  {
    sheet_.line({place_mm_.left() + axis_mm, place_mm_.top(), plot_mm_.width(), label_mm},
                numberedName(array, place), ReportFace::label);
    chart_.paintGrid();
    QPainter& painter = sheet_.painter();
    painter.save();
    painter.setClipRect(sheet_.dots(plot_mm_));
    if (array.force.empty()) return painter.restore();
    const QColor ink = inkOfArray(place);
    const planning::ForceCourse course = planning::courseOf(array);
    // of all simulations, and behind it of fewer: both share a row
    const std::pair<std::size_t, std::size_t> parts[] = {{0, course.whole},
                                                         {course.whole - 1, array.force.size()}};
    for (const auto& rows : parts) {
      const double strength = rows.second == course.whole ? 1.0 : 0.5;
      paintBand(array, rows, &planning::Band::low, &planning::Band::high, ink, 0.18 * strength);
      paintBand(array, rows, &planning::Band::lowerQuartile, &planning::Band::upperQuartile, ink,
                0.35 * strength);
      QPolygonF median;
      for (std::size_t i = rows.first; i < rows.second; ++i)
        median << chart_.at(array.force[i].depth_mm, array.force[i].force_mN.median);
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(ink, sheet_.dots({0, 0, 0.35, 0}).width(),
                          strength < 1.0 ? Qt::DotLine : Qt::SolidLine));
      painter.drawPolyline(median);
    }
    const double radius = sheet_.dots({0, 0, 0.45, 0}).width();
    painter.setPen(QPen(ink, sheet_.dots({0, 0, 0.2, 0}).width()));
    painter.setBrush(Qt::white);
    for (const planning::ForceCourse::Mark& each : course.ends)
      painter.drawEllipse(chart_.at(each.depth_mm, each.force_mN), radius, radius);
    painter.restore();
    if (plot_mm_.height() >= minCounted_mm) paintCounts(array, course);
  }

private:
  /// "n of N" at the first of the places for it, and at the deepest: a chart has no room for more.
  void paintCounts(const planning::ArrayPlan& array, const planning::ForceCourse& course) const
  {
    constexpr double width_mm = 16.0;
    for (const planning::ForceCourse::Mark* each :
         {&course.counts.front(), &course.counts.back()}) {
      const double x_mm = plot_mm_.left() + plot_mm_.width() * each->depth_mm / axes_.depth.high,
                   y_mm = chart_.top_mm(each->force_mN);
      sheet_.line(
          {x_mm - width_mm, std::max(plot_mm_.top(), y_mm - label_mm - 0.6), width_mm, label_mm},
          countText(each->draws, array.draws), ReportFace::label, Qt::AlignRight);
      if (course.counts.size() == 1) return;
    }
  }

  void paintBand(const planning::ArrayPlan& array, std::pair<std::size_t, std::size_t> rows,
                 double planning::Band::*low, double planning::Band::*high, QColor ink,
                 double opacity) const
  {
    QPolygonF area;
    for (std::size_t i = rows.first; i < rows.second; ++i)
      area << chart_.at(array.force[i].depth_mm, array.force[i].force_mN.*low);
    for (std::size_t i = rows.second; i-- > rows.first;)
      area << chart_.at(array.force[i].depth_mm, array.force[i].force_mN.*high);
    ink.setAlphaF(float(opacity));
    QPainter& painter = sheet_.painter();
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    painter.drawPolygon(area);
  }

  ReportSheet& sheet_;
  ReportChart chart_;
  QRectF plot_mm_, place_mm_;
  const Axes& axes_;
};

QString unitsText() { return tr("mN over depth in mm: median, 25–75 % and band; rings: ends"); }

int rowsOf(std::size_t count, int columns)
{
  return int((count + std::size_t(columns) - 1) / std::size_t(columns));
}

/// The first arrays, row by row, on the same axes.
void paintCharts(ReportSheet& sheet, const QRectF& place_mm,
                 const std::vector<planning::ArrayPlan>& arrays, std::size_t count, int columns)
{
  const Axes axes = axesOf(arrays, count);
  const double width_mm = place_mm.width() / columns;
  const double height_mm = place_mm.height() / rowsOf(count, columns);
  sheet.painter().save();
  sheet.painter().setRenderHint(QPainter::Antialiasing);
  for (std::size_t i = 0; i < count; ++i) {
    const int row = int(i) / columns, column = int(i) % columns;
    const QRectF place(place_mm.left() + column * width_mm, place_mm.top() + row * height_mm,
                       width_mm, height_mm);
    Chart(sheet, place, axes).paint(arrays[i], i);
  }
  sheet.painter().restore();
}

}  // namespace

void paintPlanCurves(ReportSheet& sheet, const QRectF& place_mm, const PlanReportContent& content)
{
  const auto& arrays = content.plan().arrays;
  const int columns = arrays.size() <= 2 ? 1 : place_mm.width() > broad_mm ? 3 : 2;
  const double room_mm = place_mm.height() - head_mm;
  const int rows = std::max(1, int(room_mm / minHeight_mm));
  const std::size_t count = std::min({arrays.size(), maxDrawnArrays, std::size_t(rows * columns)});
  double top_mm =
      sheet.heading(place_mm.left(), place_mm.top(), place_mm.width(), tr("Insertion force"));
  const auto write = [&](const QString& text) {
    sheet.line({place_mm.left(), top_mm, place_mm.width(), label_mm}, text, ReportFace::label);
    top_mm += label_mm;
  };
  write(unitsText());
  if (count < arrays.size())
    write(tr("Arrays 1 to %1; all %2 on the next page").arg(count).arg(arrays.size()));
  top_mm += 1.0;
  paintCharts(sheet, {place_mm.left(), top_mm, place_mm.width(), place_mm.bottom() - top_mm},
              arrays, count, columns);
}

void paintAllPlanCurves(ReportSheet& sheet, const QRectF& place_mm,
                        const PlanReportContent& content)
{
  constexpr std::size_t manyArrays = 15;  // more are in four columns
  constexpr double maxHeight_mm = 48.0;   // of a chart
  const auto& arrays = content.plan().arrays;
  const double top_mm = sheet.heading(place_mm.left(), place_mm.top(), place_mm.width(),
                                      tr("Insertion force of all arrays"));
  sheet.line({place_mm.left(), top_mm, place_mm.width(), label_mm}, unitsText(), ReportFace::label);
  const double first_mm = top_mm + label_mm + 1.0;
  const int columns = arrays.size() > manyArrays ? 4 : 3;
  const double height_mm =
      std::min(place_mm.bottom() - first_mm, maxHeight_mm * rowsOf(arrays.size(), columns));
  paintCharts(sheet, {place_mm.left(), first_mm, place_mm.width(), height_mm}, arrays,
              arrays.size(), columns);
}

}  // namespace perilymph::gui

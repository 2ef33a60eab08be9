// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/InsertionCurve.h"

#include <QCoreApplication>
#include <algorithm>

#include "gui/report/ReportChart.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/Theme.h"
#include "perilymph/figures/FixedInks.h"

namespace perilymph::gui {

namespace {

const QColor planInk(0x6B, 0x77, 0x80), thresholdInk(0xBE, 0x46, 0x00);

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

struct Thresholds {
  std::optional<double> felt_mN;
  std::optional<std::pair<double, double>> peaks_mN;
};

Thresholds thresholds()
{
  Thresholds known;
  if (const auto felt = analysis::forceFeltBySurgeons()) known.felt_mN = inMillinewtons(*felt);
  if (const auto peaks = analysis::peaksInPatients())
    known.peaks_mN = {1e3 * peaks->low, 1e3 * peaks->high};
  return known;
}

/// The curve over depth [mm], in mN.
QPolygonF curveOf(const ReportContent& content)
{
  const double start_mm = inMillimeters(content.scenario.startInside());
  QPolygonF curve;
  for (const analysis::CurvePoint& point : content.insertion.profile.curve)
    curve << QPointF(start_mm + 1e3 * point.travel, 1e3 * point.force);
  return curve;
}

/// The thresholds, with their labels at the left, where the forces are low.
void paintThresholds(ReportSheet& sheet, const ReportChart& chart, const Thresholds& known,
                     double deepest_mm, double highest_mN)
{
  QPainter& painter = sheet.painter();
  const QRectF plot = chart.plot_mm();
  const auto write = [&](const QString& text, double y_mm) {
    sheet.line({plot.left() + 1.0, y_mm, plot.width() - 2.0, ReportChart::label_mm}, text,
               ReportFace::label);
  };
  if (known.peaks_mN && known.peaks_mN->first < highest_mN) {
    const auto& [low, high] = *known.peaks_mN;
    QColor pale = thresholdInk;
    pale.setAlphaF(0.10f);
    painter.fillRect(QRectF(chart.at(0.0, std::min(high, highest_mN)), chart.at(deepest_mm, low)),
                     pale);
    write(tr("peaks in patients %1–%2 mN").arg(numberText(low, 0), numberText(high, 0)),
          chart.top_mm(0.5 * (low + std::min(high, highest_mN))) - 0.5 * ReportChart::label_mm);
  }
  if (known.felt_mN) {
    painter.setPen(QPen(thresholdInk, sheet.dots({0, 0, 0.25, 0}).width(), Qt::DashLine));
    painter.drawLine(chart.at(0.0, *known.felt_mN), chart.at(deepest_mm, *known.felt_mN));
    write(tr("felt from %1 mN").arg(numberText(*known.felt_mN, 0)),
          chart.top_mm(*known.felt_mN) - ReportChart::label_mm);
  }
}

void paintPlan(ReportSheet& sheet, const ReportChart& chart, const PlannedForce& plan)
{
  QPolygonF area, median;
  for (const PlannedForce::Point& each : plan.points) {
    area << chart.at(each.depth_mm, each.low_mN);
    median << chart.at(each.depth_mm, each.median_mN);
  }
  for (auto each = plan.points.rbegin(); each != plan.points.rend(); ++each)
    area << chart.at(each->depth_mm, each->high_mN);
  QPainter& painter = sheet.painter();
  QColor pale = planInk;
  pale.setAlphaF(0.25f);
  painter.setPen(Qt::NoPen);
  painter.setBrush(pale);
  painter.drawPolygon(area);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(planInk, sheet.dots({0, 0, 0.3, 0}).width(), Qt::DashLine));
  painter.drawPolyline(median);
}

}  // namespace

void paintInsertionCurve(ReportSheet& sheet, const QRectF& place_mm, const ReportContent& content)
{
  const QPolygonF curve = curveOf(content);
  const Thresholds known = thresholds();
  double deepest_mm = 1.0, lowest_mN = 0.0, highest_mN = known.felt_mN.value_or(0.0) * 1.2;
  for (const QPointF& each : curve) {
    deepest_mm = std::max(deepest_mm, each.x());
    // a fraction of a millinewton below zero does not need its own tick
    if (each.y() < -0.5) lowest_mN = std::min(lowest_mN, each.y());
    highest_mN = std::max(highest_mN, each.y());
  }
  if (content.plan)
    for (const PlannedForce::Point& each : content.plan->points) {
      deepest_mm = std::max(deepest_mm, each.depth_mm);
      highest_mN = std::max(highest_mN, each.high_mN);
    }
  double top_mm = sheet.heading(place_mm.left(), place_mm.top(), place_mm.width(),
                                tr("Insertion force, mN over depth, mm"));
  const QString legend = content.plan
                             ? tr("blue: this insertion; gray: median and band of the plan")
                             : tr("blue: this insertion; no plan of it is stored");
  sheet.line({place_mm.left(), top_mm, place_mm.width(), ReportChart::label_mm}, legend,
             ReportFace::label);
  top_mm += ReportChart::label_mm + 1.0;

  const figures::FigureAxis across = figures::axisOver({}, 0.0, deepest_mm),
                            up = figures::axisOver({}, lowest_mN, highest_mN);
  const ReportChart chart(sheet,
                          {place_mm.left(), top_mm - ReportChart::label_mm, place_mm.width(),
                           place_mm.bottom() - top_mm + ReportChart::label_mm},
                          across, up);
  QPainter& painter = sheet.painter();
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  chart.paintGrid();
  painter.setClipRect(sheet.dots(chart.plot_mm()));
  if (content.plan) paintPlan(sheet, chart, *content.plan);
  paintThresholds(sheet, chart, known, across.high, up.high);
  QPolygonF line;
  for (const QPointF& each : curve) line << chart.at(each.x(), each.y());
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colorOf(figures::ink::blue), sheet.dots({0, 0, 0.45, 0}).width()));
  painter.drawPolyline(line);
  painter.restore();
}

}  // namespace perilymph::gui

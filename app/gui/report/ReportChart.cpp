// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/ReportChart.h"

#include <algorithm>
#include <cmath>

#include "gui/text/Numbers.h"

namespace perilymph::gui {

namespace {

const QColor gridInk(0xD8, 0xDE, 0xE2);

}  // namespace

ReportChart::ReportChart(ReportSheet& sheet, const QRectF& place_mm,
                         const figures::FigureAxis& across, const figures::FigureAxis& up)
    : sheet_(sheet),
      place_mm_(place_mm),
      plot_mm_(place_mm.adjusted(axis_mm, label_mm + 0.6, -2.0, -label_mm - 1.2)),
      across_(across),
      up_(up)
{
}

QPointF ReportChart::at(double x, double y) const
{
  const QRectF plot = sheet_.dots(plot_mm_);
  return {plot.left() + plot.width() * x / across_.high,
          plot.bottom() - plot.height() * (y - up_.low) / (up_.high - up_.low)};
}

double ReportChart::top_mm(double y) const
{
  return plot_mm_.bottom() -
         plot_mm_.height() * std::clamp((y - up_.low) / (up_.high - up_.low), 0.0, 1.0);
}

int ReportChart::numberedLines() const
{
  const double apart_mm = plot_mm_.height() * up_.tick / (up_.high - up_.low);
  return apart_mm > 0.0 ? std::max(1, int(std::ceil(label_mm / apart_mm))) : 1;
}

void ReportChart::paintGrid() const
{
  QPainter& painter = sheet_.painter();
  const QPen pen(gridInk, sheet_.dots({0, 0, 0.12, 0}).width());
  const int every = numberedLines();
  int lines = 0;
  for (double y = up_.low; y <= up_.high * 1.001; y += up_.tick) {
    painter.setPen(pen);
    painter.drawLine(at(0.0, y), at(across_.high, y));
    if (lines++ % every != 0) continue;
    sheet_.line({place_mm_.left(), top_mm(y) - 0.5 * label_mm, axis_mm - 1.0, label_mm},
                numberText(y, up_.decimals), ReportFace::label, Qt::AlignRight);
  }
  for (double x = 0.0; x <= across_.high * 1.001; x += across_.tick) {
    painter.setPen(pen);
    painter.drawLine(at(x, up_.low), at(x, up_.high));
    const double x_mm = plot_mm_.left() + plot_mm_.width() * x / across_.high;
    sheet_.line({x_mm - 5.0, plot_mm_.bottom(), 10.0, label_mm}, numberText(x, across_.decimals),
                ReportFace::label, Qt::AlignHCenter);
  }
}

}  // namespace perilymph::gui

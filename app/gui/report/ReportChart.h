// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A small chart on a page of a report: two axes from 0, with a grid and numbers.

#include <QPointF>
#include <QRectF>

#include "gui/report/ReportSheet.h"
#include "perilymph/figures/Figure.h"

namespace perilymph::gui {

class ReportChart {
public:
  static constexpr double axis_mm = 8.0;   ///< Left of the plot, for its numbers.
  static constexpr double label_mm = 3.4;  ///< Height of a line of text.

  /// In a place [mm], with a line of text free above the plot and one for the numbers below it.
  ReportChart(ReportSheet& sheet, const QRectF& place_mm, const figures::FigureAxis& across,
              const figures::FigureAxis& up);

  const QRectF& plot_mm() const { return plot_mm_; }
  /// A point of the chart on the page [dots].
  QPointF at(double x, double y) const;
  /// Its height on the page [mm], within the plot.
  double top_mm(double y) const;
  void paintGrid() const;

private:
  /// A number is at every line, at every second, ..., so that they do not touch.
  int numberedLines() const;

  ReportSheet& sheet_;
  QRectF place_mm_, plot_mm_;
  const figures::FigureAxis& across_;
  const figures::FigureAxis& up_;
};

}  // namespace perilymph::gui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A page with two axes for flat views.

#include <string>
#include <utility>
#include <vector>

#include "AxisRange.h"
#include "perilymph/charts/ChartStyle.h"
#include "perilymph/figures/Drawing.h"

namespace perilymph::charts {

/// Margins of the plot [px].
struct SheetMargins {
  double left = 40.0, right = 8.0, top = 8.0, bottom = 22.0;
};

/// The plot of a drawing, in pixels from its upper left corner; values increase upward.
class PlotSheet {
public:
  /// Fills the page and the plot's background. If there is no space, the plot has 1 pixel.
  PlotSheet(double width, double height, const SheetMargins& margins, const AxisRange& x,
            const AxisRange& y, const ChartStyle& style);

  double x(double value) const;
  double y(double value) const;
  figures::PagePoint at(double xValue, double yValue) const { return {x(xValue), y(yValue)}; }
  double left() const { return left_; }
  double right() const { return right_; }
  double top() const { return top_; }
  double bottom() const { return bottom_; }

  /// Grid lines and numbers at the ticks; `unit` follows each number.
  void addXTicks(int every, const std::string& unit);
  void addYTicks(int decimals);

  template <class Mark>
  void add(Mark mark)
  {
    drawing_.marks.emplace_back(std::in_place_type<Mark>, std::move(mark));
  }
  /// Text in the size of labels.
  void write(figures::PagePoint at, std::string text, const figures::Ink& ink,
             figures::Anchor anchor = figures::Anchor::start);
  figures::Drawing take() { return std::move(drawing_); }

private:
  double left_, right_, top_, bottom_;
  AxisRange x_, y_;
  const figures::Palette& inks_;
  char decimalSign_;
  figures::Drawing drawing_;
};

/// Approximate width of a label [px]: a drawing has no font metrics.
double widthOfLabel(const std::string& label);

/// A number with fixed decimals; never "-0".
std::string written(double value, int decimals, char decimalSign);

}  // namespace perilymph::charts

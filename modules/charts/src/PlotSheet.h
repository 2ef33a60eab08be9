#pragma once

// A dark sheet with two axes that flat views are drawn on.

#include <string>
#include <utility>
#include <vector>

#include "AxisRange.h"
#include "perilymph/analysis/Drawing.h"

namespace perilymph::charts {

namespace ink {
inline constexpr analysis::Ink panel{{0x1A, 0x20, 0x26}, 1.0};
inline constexpr analysis::Ink ground{{0x12, 0x16, 0x1A}, 1.0};
inline constexpr analysis::Ink grid{{0x2A, 0x32, 0x3A}, 1.0};
inline constexpr analysis::Ink zero{{0x55, 0x61, 0x6B}, 1.0};
inline constexpr analysis::Ink text{{0xE8, 0xEC, 0xEF}, 1.0};
inline constexpr analysis::Ink quiet{{0x93, 0xA1, 0xAC}, 1.0};
inline constexpr analysis::Ink accent{{0x45, 0xC4, 0xB0}, 1.0};
inline constexpr analysis::Ink orange{{0xE6, 0x9F, 0x00}, 1.0};
inline constexpr analysis::Ink bone{{0xE9, 0xDC, 0xC0}, 1.0};
inline constexpr analysis::Ink lumen{{0xE9, 0xDC, 0xC0}, 0.13};
inline constexpr analysis::Ink membrane{{0xC7, 0x80, 0x8B}, 1.0};
inline constexpr analysis::Ink silicone{{0xDC, 0xE4, 0xE9}, 1.0};
inline constexpr analysis::Ink platinum{{0x5E, 0x6C, 0x77}, 1.0};

constexpr analysis::Ink faded(analysis::Ink ink, double opacity)
{
  ink.opacity = opacity;
  return ink;
}
}  // namespace ink

/// Pixels around the plot.
struct SheetMargins {
  double left = 40.0, right = 8.0, top = 8.0, bottom = 22.0;
};

/// The plot of a drawing, in pixels from its upper left corner; y grows upward in values.
class PlotSheet {
public:
  /// Fills the sheet and the plot's ground. A size without room for a plot gives a plot of 1 pixel.
  PlotSheet(double width, double height, const SheetMargins& margins, const AxisRange& x,
            const AxisRange& y);

  double x(double value) const;
  double y(double value) const;
  analysis::PagePoint at(double xValue, double yValue) const { return {x(xValue), y(yValue)}; }
  double left() const { return left_; }
  double right() const { return right_; }
  double top() const { return top_; }
  double bottom() const { return bottom_; }

  /// Grid lines and numbers at the ticks; `unit` stands behind each number.
  void addXTicks(int every, const std::string& unit);
  void addYTicks(int decimals);

  template <class Mark>
  void add(Mark mark)
  {
    drawing_.marks.emplace_back(std::in_place_type<Mark>, std::move(mark));
  }
  /// Words of the size of labels.
  void write(analysis::PagePoint at, std::string text, const analysis::Ink& ink,
             analysis::Anchor anchor = analysis::Anchor::start);
  analysis::Drawing take() { return std::move(drawing_); }

private:
  double left_, right_, top_, bottom_;
  AxisRange x_, y_;
  analysis::Drawing drawing_;
};

/// A number with so many decimals; never "-0".
std::string written(double value, int decimals);

}  // namespace perilymph::charts

// SPDX-License-Identifier: BSD-3-Clause
#include "PlotSheet.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "perilymph/figures/Lines.h"
#include "perilymph/figures/Strings.h"

namespace perilymph::charts {

using figures::Anchor;
using figures::Area;
using figures::PagePoint;
using figures::Stroke;

namespace {

std::vector<PagePoint> rectangle(double left, double top, double right, double bottom)
{
  return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

/// At the center of a pixel, so that a line of one pixel is sharp.
double sharp(double place) { return std::floor(place) + 0.5; }

}  // namespace

PlotSheet::PlotSheet(double width, double height, const SheetMargins& margins, const AxisRange& x,
                     const AxisRange& y, const ChartStyle& style)
    : left_(margins.left),
      right_(std::max(margins.left + 1.0, width - margins.right)),
      top_(margins.top),
      bottom_(std::max(margins.top + 1.0, height - margins.bottom)),
      x_(x),
      y_(y),
      inks_(figures::paletteOf(style.scheme)),
      decimalSign_(style.strings.decimalSign)
{
  drawing_.width = width;
  drawing_.height = height;
  add(Area{rectangle(0.0, 0.0, width, height), inks_.panel});
  add(Area{rectangle(left_, top_, right_, bottom_), inks_.ground});
}

double PlotSheet::x(double value) const
{
  return left_ + (value - x_.low) / (x_.high - x_.low) * (right_ - left_);
}

double PlotSheet::y(double value) const
{
  return bottom_ - (value - y_.low) / (y_.high - y_.low) * (bottom_ - top_);
}

void PlotSheet::addXTicks(int every, const std::string& unit)
{
  int count = 0;
  for (const double place : tickPlaces(x_)) {
    add(Stroke{{{sharp(x(place)), top_}, {sharp(x(place)), bottom_}}, inks_.grid, 1.0, 0.0});
    const bool isNamed = count++ % every == 0;
    if (!isNamed) continue;
    const bool isAtEnd = x(place) > right_ - 12.0;
    write({isAtEnd ? right_ : x(place), bottom_ + 15.0}, written(place, 0, decimalSign_) + unit,
          inks_.quiet, isAtEnd ? Anchor::end : Anchor::middle);
  }
}

void PlotSheet::addYTicks(int decimals)
{
  for (const double place : tickPlaces(y_)) {
    add(Stroke{{{left_, sharp(y(place))}, {right_, sharp(y(place))}}, inks_.grid, 1.0, 0.0});
    write({left_ - 6.0, y(place) + 4.0}, written(place, decimals, decimalSign_), inks_.quiet,
          Anchor::end);
  }
}

void PlotSheet::write(PagePoint at, std::string text, const figures::Ink& ink, Anchor anchor)
{
  add(figures::Label{at, std::move(text), figures::labelSize, ink, anchor,
                     figures::Direction::across, false});
}

double widthOfLabel(const std::string& label)
{
  return figures::widthOf(label, figures::labelSize);
}

std::string written(double value, int decimals, char decimalSign)
{
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  const std::string result = figures::withDecimalSign(text, decimalSign);
  const bool isZero = result.find_first_not_of("-0.,") == std::string::npos;
  std::string shown = isZero && result.front() == '-' ? result.substr(1) : result;
  if (!shown.empty() && shown.front() == '-') shown = "\u2212" + shown.substr(1);
  return shown;
}

}  // namespace perilymph::charts

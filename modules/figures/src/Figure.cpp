// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/figures/Figure.h"

#include <algorithm>
#include <cmath>

#include "perilymph/figures/Lines.h"
#include "perilymph/figures/Strings.h"

namespace perilymph::figures {

namespace {

constexpr double pageWidth = 480.0;
constexpr double left = 58.0, right = 14.0, top = 30.0, plotHeight = 250.0;
constexpr double titleSize = 11.0, textSize = 9.0, smallSize = 8.0, lineSpacing = 12.0;

std::string written(double value, int decimals)
{
  const std::string result = fixed(value, decimals);
  return result.find_first_not_of("-0.") == std::string::npos && result.front() == '-'
             ? result.substr(1)
             : result;
}

/// Maps values to page coordinates.
class Plot {
public:
  explicit Plot(const Figure& figure) : figure_(figure) {}

  double x(double value) const
  {
    const FigureAxis& axis = figure_.x;
    return left + (value - axis.low) / (axis.high - axis.low) * (pageWidth - left - right);
  }
  double y(double value) const
  {
    const FigureAxis& axis = figure_.y;
    const double inside = std::clamp(value, axis.low, axis.high);
    return top + (axis.high - inside) / (axis.high - axis.low) * plotHeight;
  }
  PagePoint at(double xValue, double yValue) const { return {x(xValue), y(yValue)}; }
  bool holds(double xValue) const { return xValue >= figure_.x.low && xValue <= figure_.x.high; }

  void axes(Drawing& page) const;
  void band(Drawing& page, const FigureBand& band) const;
  void level(Drawing& page, const FigureLevel& level) const;
  void curve(Drawing& page, const FigureCurve& curve) const;
  void values(Drawing& page, const FigureValues& values) const;
  void text(Drawing& page, const FigureText& text) const;

private:
  const Figure& figure_;
};

std::vector<double> ticksOf(const FigureAxis& axis)
{
  std::vector<double> ticks;
  const double first = std::ceil(axis.low / axis.tick - 1e-9);
  for (double count = first; count * axis.tick <= axis.high + 1e-9 * axis.tick; count += 1.0)
    ticks.push_back(count * axis.tick);
  return ticks;
}

void marker(Drawing& page, MarkerShape shape, PagePoint at, const Ink& ink)
{
  constexpr double size = 3.4;
  const Ink white{{255, 255, 255}, 1.0};
  switch (shape) {
    case MarkerShape::disk:
      page.marks.push_back(Disk{at, size, ink, ink});
      return;
    case MarkerShape::ring:
      page.marks.push_back(Disk{at, size, white, ink});
      return;
    case MarkerShape::square:
      page.marks.push_back(Area{{{at.x - size, at.y - size},
                                 {at.x + size, at.y - size},
                                 {at.x + size, at.y + size},
                                 {at.x - size, at.y + size}},
                                ink});
      return;
    case MarkerShape::diamond:
      page.marks.push_back(Area{{{at.x, at.y - 1.35 * size},
                                 {at.x + 1.35 * size, at.y},
                                 {at.x, at.y + 1.35 * size},
                                 {at.x - 1.35 * size, at.y}},
                                ink});
  }
}

void errorBar(Drawing& page, PagePoint low, PagePoint high, const Ink& ink)
{
  constexpr double cap = 3.0;
  page.marks.push_back(Stroke{{low, high}, ink, 1.1, 0.0});
  for (const PagePoint& end : {low, high})
    page.marks.push_back(Stroke{{{end.x - cap, end.y}, {end.x + cap, end.y}}, ink, 1.1, 0.0});
}

void Plot::axes(Drawing& page) const
{
  const double bottom = top + plotHeight;
  const double end = pageWidth - right;
  for (const double tick : ticksOf(figure_.x)) {
    page.marks.push_back(Stroke{{{x(tick), top}, {x(tick), bottom}}, ink::paleGrid, 0.6, 0.0});
    page.marks.push_back(Label{{x(tick), bottom + 12.0},
                               written(tick, figure_.x.decimals),
                               textSize,
                               ink::black,
                               Anchor::middle,
                               Direction::across,
                               false});
  }
  for (const double tick : ticksOf(figure_.y)) {
    page.marks.push_back(Stroke{{{left, y(tick)}, {end, y(tick)}}, ink::paleGrid, 0.6, 0.0});
    page.marks.push_back(Label{{left - 5.0, y(tick) + 3.0},
                               written(tick, figure_.y.decimals),
                               textSize,
                               ink::black,
                               Anchor::end,
                               Direction::across,
                               false});
  }
  if (figure_.y.low < 0.0 && figure_.y.high > 0.0)
    page.marks.push_back(Stroke{{{left, y(0.0)}, {end, y(0.0)}}, ink::gray, 0.9, 0.0});
  page.marks.push_back(Stroke{
      {{left, top}, {left, bottom}, {end, bottom}, {end, top}, {left, top}}, ink::black, 0.9, 0.0});
  page.marks.push_back(Label{{0.5 * (left + end), bottom + 26.0},
                             figure_.x.title,
                             textSize,
                             ink::black,
                             Anchor::middle,
                             Direction::across,
                             false});
  page.marks.push_back(Label{{14.0, top + 0.5 * plotHeight},
                             figure_.y.title,
                             textSize,
                             ink::black,
                             Anchor::middle,
                             Direction::upward,
                             false});
  page.marks.push_back(Label{{left, top - 11.0},
                             figure_.title,
                             titleSize,
                             ink::black,
                             Anchor::start,
                             Direction::across,
                             true});
}

void Plot::band(Drawing& page, const FigureBand& band) const
{
  Area area{{}, band.ink};
  for (std::size_t i = 0; i < band.x.size(); ++i)
    if (holds(band.x[i])) area.points.push_back(at(band.x[i], band.low[i]));
  for (std::size_t i = band.x.size(); i-- > 0;)
    if (holds(band.x[i])) area.points.push_back(at(band.x[i], band.high[i]));
  page.marks.push_back(area);
}

void Plot::level(Drawing& page, const FigureLevel& level) const
{
  const double end = pageWidth - right;
  page.marks.push_back(Stroke{{{left, y(level.y)}, {end, y(level.y)}}, level.ink, 0.9, level.dash});
  if (!level.label.empty())
    page.marks.push_back(Label{{left + 4.0, y(level.y) - 3.0},
                               level.label,
                               smallSize,
                               level.ink,
                               Anchor::start,
                               Direction::across,
                               false});
}

void Plot::curve(Drawing& page, const FigureCurve& curve) const
{
  Stroke stroke{{}, curve.ink, curve.width, curve.dash};
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    if (holds(curve.x[i])) stroke.points.push_back(at(curve.x[i], curve.y[i]));
  page.marks.push_back(stroke);
}

void Plot::values(Drawing& page, const FigureValues& values) const
{
  for (std::size_t i = 0; i < values.x.size(); ++i) {
    if (!holds(values.x[i])) continue;
    if (i < values.low.size() && values.high[i] > values.low[i])
      errorBar(page, at(values.x[i], values.low[i]), at(values.x[i], values.high[i]), values.ink);
    marker(page, values.shape, at(values.x[i], values.y[i]), values.ink);
  }
}

void Plot::text(Drawing& page, const FigureText& text) const
{
  constexpr double away = 7.0;
  if (!holds(text.x)) return;
  const PagePoint place = at(text.x, text.y);
  // above the point, below it at the upper edge; before it in the right half of the figure
  const double y = place.y > top + 2.0 * away ? place.y - away : place.y + away + textSize;
  const bool isRight = place.x > 0.5 * (left + pageWidth - right);
  page.marks.push_back(Label{{place.x, y},
                             text.text,
                             smallSize,
                             text.ink,
                             isRight ? Anchor::end : Anchor::start,
                             Direction::across,
                             false});
}

/// The legend below the axes.
double legend(Drawing& page, const Figure& figure, double y)
{
  const double begin = left, sample = 22.0;
  const auto row = [&](const std::string& label) {
    page.marks.push_back(Label{{begin + sample + 6.0, y + 3.0},
                               label,
                               textSize,
                               ink::black,
                               Anchor::start,
                               Direction::across,
                               false});
    y += lineSpacing;
  };
  for (const FigureCurve& curve : figure.curves) {
    if (curve.label.empty()) continue;
    page.marks.push_back(
        Stroke{{{begin, y}, {begin + sample, y}}, curve.ink, curve.width, curve.dash});
    row(curve.label);
  }
  for (const FigureBand& band : figure.bands) {
    if (band.label.empty()) continue;
    page.marks.push_back(Area{
        {{begin, y - 4.0}, {begin + sample, y - 4.0}, {begin + sample, y + 4.0}, {begin, y + 4.0}},
        band.ink});
    row(band.label);
  }
  for (const FigureValues& values : figure.values) {
    if (values.label.empty()) continue;
    const PagePoint at{begin + 0.5 * sample, y};
    if (!values.low.empty()) errorBar(page, {at.x, y + 5.0}, {at.x, y - 5.0}, values.ink);
    marker(page, values.shape, at, values.ink);
    row(values.label);
  }
  return y;
}

}  // namespace

FigureAxis axisOver(Sentence title, double low, double high)
{
  if (!(high > low)) high = low + 1.0;
  const double rough = (high - low) / 6.0;
  double unit = 1.0;
  int decimals = 0;
  while (unit > rough && decimals < 9) {
    unit /= 10.0;
    ++decimals;
  }
  while (unit * 10.0 <= rough) unit *= 10.0;
  double tick = unit;
  for (const double factor : {2.0, 5.0, 10.0})
    if (tick < rough) tick = factor * unit;
  FigureAxis axis;
  axis.title = std::move(title);
  axis.tick = tick;
  axis.low = std::floor(low / tick + 1e-9) * tick;
  axis.high = std::ceil(high / tick - 1e-9) * tick;
  axis.decimals = tick >= 10.0 * unit ? std::max(0, decimals - 1) : decimals;
  return axis;
}

Drawing draw(const Figure& figure)
{
  Drawing page;
  page.width = pageWidth;
  const Plot plot(figure);
  plot.axes(page);
  for (const FigureBand& band : figure.bands) plot.band(page, band);
  for (const FigureLevel& level : figure.levels) plot.level(page, level);
  for (const FigureCurve& curve : figure.curves) plot.curve(page, curve);
  for (const FigureValues& values : figure.values) plot.values(page, values);
  for (const FigureText& text : figure.texts) plot.text(page, text);
  double y = legend(page, figure, top + plotHeight + 44.0);
  for (const std::string& note : figure.notes)
    for (const std::string& line : linesOf(note, smallSize, pageWidth - left - right)) {
      page.marks.push_back(Label{
          {left, y + 4.0}, line, smallSize, ink::gray, Anchor::start, Direction::across, false});
      y += lineSpacing - 1.0;
    }
  page.height = y + 6.0;
  return page;
}

}  // namespace perilymph::figures

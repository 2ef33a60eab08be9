// SPDX-License-Identifier: BSD-3-Clause
#include "ChartOverlay.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkContext2D.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "ChartColors.h"
#include "TextStyle.h"

namespace perilymph::charts {

vtkStandardNewMacro(ChartOverlay)

    /// The plot area in pixels, and its ranges.
    struct ChartOverlay::Area {
  float left, bottom, right, top;
  double xLow, xHigh, yLow, yHigh;

  float x(double value) const
  {
    return left + static_cast<float>((value - xLow) / (xHigh - xLow)) * (right - left);
  }
  float y(double value) const
  {
    return bottom + static_cast<float>((value - yLow) / (yHigh - yLow)) * (top - bottom);
  }
};

namespace {

/// A horizontal or vertical line as a filled rectangle on whole pixels: sharp without antialiasing.
void bar(vtkContext2D& painter, float x, float y, float width, float height)
{
  painter.DrawRect(std::round(x), std::round(y), std::max(1.0f, std::round(width)),
                   std::max(1.0f, std::round(height)));
}

void fillWith(vtkContext2D& painter, const vtkColor4ub& color)
{
  painter.GetPen()->SetLineType(vtkPen::NO_PEN);
  painter.GetBrush()->SetColor(color);
  painter.GetBrush()->SetTexture(nullptr);
}

constexpr float swatchWidth = 20.0f;  // of a legend, at pixel ratio 1
constexpr float legendGap = 16.0f;    // between entries

/// A disk with a soft edge, drawn as three shells: software rendering does not antialias.
void disc(vtkContext2D& painter, float x, float y, float radius, const vtkColor4ub& color)
{
  painter.GetPen()->SetLineType(vtkPen::NO_PEN);
  for (const auto& [grow, opacity] :
       {std::pair{0.7f, 70}, std::pair{0.35f, 120}, std::pair{0.0f, 255}}) {
    painter.GetBrush()->SetColor(color);
    painter.GetBrush()->SetOpacity(static_cast<unsigned char>(opacity));
    painter.DrawEllipse(x, y, radius + grow, radius + grow);
  }
}

}  // namespace

void ChartOverlay::setScale(double pixelRatio)
{
  if (scale_ != static_cast<float>(pixelRatio)) widths_.clear();
  scale_ = static_cast<float>(pixelRatio);
  Modified();
}

bool ChartOverlay::Paint(vtkContext2D* painter)
{
  const vtkAxis& xAxis = *chart_->GetAxis(vtkAxis::BOTTOM);
  const vtkAxis& yAxis = *chart_->GetAxis(vtkAxis::LEFT);
  const auto* origin = const_cast<vtkAxis&>(xAxis).GetPoint1();
  const auto* right = const_cast<vtkAxis&>(xAxis).GetPoint2();
  const auto* top = const_cast<vtkAxis&>(yAxis).GetPoint2();
  const Area area{origin[0],
                  origin[1],
                  right[0],
                  top[1],
                  const_cast<vtkAxis&>(xAxis).GetMinimum(),
                  const_cast<vtkAxis&>(xAxis).GetMaximum(),
                  const_cast<vtkAxis&>(yAxis).GetMinimum(),
                  const_cast<vtkAxis&>(yAxis).GetMaximum()};
  if (area.right <= area.left || area.top <= area.bottom) return true;

  paintExpected(*painter, area);
  paintTrends(*painter, area);
  paintZero(*painter, area);
  paintThreshold(*painter, area);
  paintMarks(*painter, area);
  paintBars(*painter, area);
  paintNow(*painter, area);
  paintRing(*painter, area);
  paintLegend(*painter, area);
  return true;
}

void ChartOverlay::setText(vtkContext2D& painter, const vtkColor4ub& color, int justification) const
{
  vtkTextProperty& text = *painter.GetTextProp();
  setTypeface(text);
  text.SetFontSize(static_cast<int>(std::lround(figures::labelSize * scale_)));
  text.SetColor(color.GetRed() / 255.0, color.GetGreen() / 255.0, color.GetBlue() / 255.0);
  text.SetOpacity(1.0);
  text.SetBold(false);
  text.SetOrientation(0.0);
  text.SetJustification(justification);
  text.SetVerticalJustificationToCentered();
}

void ChartOverlay::paintZero(vtkContext2D& painter, const Area& area) const
{
  if (!(area.yLow < 0.0 && area.yHigh > 0.0)) return;
  fillWith(painter, colorOf(inks_->zero));
  bar(painter, area.left, area.y(0.0), area.right - area.left, scale_);
}

void ChartOverlay::paintThreshold(vtkContext2D& painter, const Area& area) const
{
  if (!threshold || threshold->y < area.yLow || threshold->y > area.yHigh) return;
  const float y = area.y(threshold->y);
  fillWith(painter, threshold->color);
  const float dash = 4.0f * scale_;
  for (float x = area.left; x < area.right; x += 2.0f * dash)
    bar(painter, x, y, std::min(dash, area.right - x), scale_);
}

void ChartOverlay::paintExpected(vtkContext2D& painter, const Area& area) const
{
  const auto x = [&](double travel_mm) {
    return std::clamp(area.x(travel_mm), area.left, area.right);
  };
  const auto y = [&](double force_mN) {
    return std::clamp(area.y(force_mN), area.bottom, area.top);
  };
  vtkColor4ub light = colorOf(inks_->blue);
  light.SetAlpha(60);
  fillWith(painter, light);
  for (std::size_t i = 1; i < expected.size(); ++i) {
    const ExpectedForce &from = expected[i - 1], &to = expected[i];
    painter.DrawQuad(x(from.travel_mm), y(from.low_mN), x(from.travel_mm), y(from.high_mN),
                     x(to.travel_mm), y(to.high_mN), x(to.travel_mm), y(to.low_mN));
  }
  fillWith(painter, colorOf(inks_->blue));
  const float dot = 2.0f * scale_;
  for (std::size_t i = 1; i < expected.size(); ++i) {
    const float left = x(expected[i - 1].travel_mm), right = x(expected[i].travel_mm);
    const float from = y(expected[i - 1].median_mN), to = y(expected[i].median_mN);
    for (float at = left; at < right; at += 2.0f * dot)
      bar(painter, at, from + (to - from) * (at - left) / (right - left), dot, dot);
  }
}

void ChartOverlay::paintMarks(vtkContext2D& painter, const Area& area) const
{
  const float row = legendRow_px * scale_, gap = 4.0f * scale_, dash = 2.0f * scale_;
  std::array<float, 3> ends{};  // of the labels in each row
  for (const auto& [place, label] : marks) {
    if (place < area.xLow || place > area.xHigh) continue;
    const float x = area.x(place), width = widthOf(painter, label) + gap;
    fillWith(painter, colorOf(inks_->zero));
    for (float y = area.bottom; y < area.top; y += 3.0f * dash)
      bar(painter, x, y, scale_, std::min(dash, area.top - y));
    // beside its line, left of it at the right edge, and below where there is another one
    const float left = x + gap + width > area.right ? x - width - gap : x + gap;
    const auto* const free = std::ranges::find_if(ends, [left](float end) { return end <= left; });
    if (free == ends.end()) continue;
    const auto level = std::distance(ends.cbegin(), free);
    ends[std::size_t(level)] = left + width;
    setText(painter, colorOf(inks_->text), VTK_TEXT_LEFT);
    painter.DrawString(left, area.top - (0.6f + float(level)) * row, label);
  }
}

void ChartOverlay::paintBars(vtkContext2D& painter, const Area& area) const
{
  for (const ReferencePoint& point : bars) {
    if (point.travel_mm > area.xHigh || point.travel_mm < area.xLow) continue;
    const float x = area.x(point.travel_mm);
    const float low = std::max(area.bottom, area.y(point.mean_mN - point.sd_mN));
    const float high = std::min(area.top, area.y(point.mean_mN + point.sd_mN));
    const float cap = 4.0f * scale_;
    vtkColor4ub quiet = colorOf(inks_->text);
    quiet.SetAlpha(200);
    fillWith(painter, quiet);
    bar(painter, x - 0.5f * scale_, low, scale_, high - low);
    bar(painter, x - cap, low, 2.0f * cap, scale_);
    bar(painter, x - cap, high, 2.0f * cap, scale_);
    disc(painter, x, area.y(point.mean_mN), 4.0f * scale_, colorOf(inks_->text));
    disc(painter, x, area.y(point.mean_mN), 2.4f * scale_, colorOf(inks_->ground));
  }
}

void ChartOverlay::paintNow(vtkContext2D& painter, const Area& area) const
{
  if (now) disc(painter, area.x(now->x), area.y(now->y), 4.0f * scale_, now->color);
}

void ChartOverlay::paintTrends(vtkContext2D& painter, const Area& area) const
{
  const auto x = [&](double value) { return std::clamp(area.x(value), area.left, area.right); };
  const auto y = [&](double value) { return std::clamp(area.y(value), area.bottom, area.top); };
  for (const Trend& trend : trends) {
    vtkColor4ub light = trend.color;
    light.SetAlpha(60);
    fillWith(painter, light);
    for (std::size_t i = 1; i < trend.points.size(); ++i) {
      const TrendPoint &from = trend.points[i - 1], &to = trend.points[i];
      painter.DrawQuad(x(from.x), y(from.low), x(from.x), y(from.high), x(to.x), y(to.high),
                       x(to.x), y(to.low));
    }
    painter.GetPen()->SetLineType(vtkPen::SOLID_LINE);
    painter.GetPen()->SetColor(trend.color);
    painter.GetPen()->SetWidth(lineWidth * scale_);
    for (std::size_t i = 1; i < trend.points.size(); ++i) {
      const TrendPoint &from = trend.points[i - 1], &to = trend.points[i];
      if (std::min(from.value, to.value) < area.yLow || std::max(from.value, to.value) > area.yHigh)
        continue;
      painter.DrawLine(x(from.x), y(from.value), x(to.x), y(to.value));
    }
    painter.GetPen()->SetLineType(vtkPen::NO_PEN);
  }
}

void ChartOverlay::paintRing(vtkContext2D& painter, const Area& area) const
{
  if (!ringed) return;
  fillWith(painter, ringed->color);
  const float inner = 8.0f * scale_, outer = 10.0f * scale_;
  painter.DrawEllipseWedge(area.x(ringed->x), area.y(ringed->y), outer, outer, inner, inner, 0.0f,
                           360.0f);
}

void ChartOverlay::paintSwatch(vtkContext2D& painter, const LegendEntry& entry, float x,
                               float y) const
{
  fillWith(painter, entry.color);
  if (entry.swatch == Swatch::line) {
    bar(painter, x, y - scale_, swatchWidth * scale_, 2.0f * scale_);
    return;
  }
  if (entry.swatch == Swatch::mark) {
    const std::array<float, 2> middle{x + 0.5f * swatchWidth * scale_, y};
    painter.GetPen()->SetLineType(vtkPen::SOLID_LINE);
    painter.GetPen()->SetColor(entry.color);
    painter.GetPen()->SetWidth(8.0f * scale_);  // the size of a mark
    std::array<float, 2> place = middle;
    std::array<unsigned char, 4> color{entry.color.GetRed(), entry.color.GetGreen(),
                                       entry.color.GetBlue(), entry.color.GetAlpha()};
    painter.DrawMarkers(entry.shape, false, place.data(), 1, color.data(), 4);
    painter.GetPen()->SetLineType(vtkPen::NO_PEN);
    return;
  }
  if (entry.swatch == Swatch::level) {
    for (float at = x; at < x + swatchWidth * scale_; at += 8.0f * scale_)
      bar(painter, at, y, 4.0f * scale_, scale_);
    return;
  }
  if (entry.swatch != Swatch::bar) {
    const float dash = (entry.swatch == Swatch::dashes ? 6.0f : 2.0f) * scale_;
    const float end = x + swatchWidth * scale_;
    for (float at = x; at < end; at += (entry.swatch == Swatch::dashes ? 1.6f : 2.0f) * dash)
      bar(painter, at, y - scale_, std::min(dash, end - at), 2.0f * scale_);
    return;
  }
  const float middle = x + 0.5f * swatchWidth * scale_;
  bar(painter, middle - 0.5f * scale_, y - 6.0f * scale_, scale_, 12.0f * scale_);
  disc(painter, middle, y, 3.5f * scale_, entry.color);
  disc(painter, middle, y, 2.0f * scale_, colorOf(inks_->ground));
}

float ChartOverlay::widthOf(vtkContext2D& painter, const std::string& label) const
{
  if (const auto known = widths_.find(label); known != widths_.end()) return known->second;
  constexpr std::size_t maxWidths = 1000;  // labels of one chart; more are those of former ones
  if (widths_.size() >= maxWidths) widths_.clear();
  float bounds[4];  // left, bottom, width, height
  setText(painter, colorOf(inks_->text), VTK_TEXT_LEFT);
  painter.ComputeStringBounds(label, bounds);
  return widths_[label] = bounds[2];
}

std::string ChartOverlay::fitted(vtkContext2D& painter, const std::string& label, float width) const
{
  if (widthOf(painter, label) <= width) return label;
  std::string part = label;
  while (!part.empty() && widthOf(painter, part + "…") > width) {
    // a whole character of UTF-8
    while (part.size() > 1 && (static_cast<unsigned char>(part.back()) & 0xC0u) == 0x80u)
      part.pop_back();
    part.pop_back();
  }
  return part + "…";
}

std::vector<std::string> ChartOverlay::wrapped(vtkContext2D& painter, const std::string& label,
                                               float width) const
{
  std::vector<std::string> lines{label};
  while (widthOf(painter, lines.back()) > width) {
    const std::string whole = lines.back();
    std::size_t end = whole.rfind(' ');
    while (end != std::string::npos && end > 0 && widthOf(painter, whole.substr(0, end)) > width)
      end = whole.rfind(' ', end - 1);
    if (end == std::string::npos || end == 0) break;  // one word, which is cut
    lines.back() = whole.substr(0, end);
    lines.push_back(whole.substr(end + 1));
  }
  return lines;
}

int ChartOverlay::legendRows(vtkContext2D& painter, float width) const
{
  int rows = 0;
  placeLegend(
      painter, width,
      [&rows](const LegendEntry&, const std::string&, float, int row, bool) { rows = row + 1; });
  return rows;
}

void ChartOverlay::placeLegend(
    vtkContext2D& painter, float width,
    const std::function<void(const LegendEntry&, const std::string&, float, int, bool)>& line) const
{
  const float swatch = (swatchWidth + 7.0f) * scale_;
  float x = 0.0f;
  int row = 0;
  for (const LegendEntry& entry : legend) {
    const auto lines = wrapped(painter, entry.text, width - swatch);
    const float entryWidth = swatch + widthOf(painter, lines.front());
    if (x > 0.0f && (lines.size() > 1 || x + entryWidth > width)) {
      x = 0.0f;
      ++row;
    }
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (i > 0) ++row;
      line(entry, fitted(painter, lines[i], width - swatch), x, row, i == 0);
    }
    x += lines.size() > 1 ? width : entryWidth + legendGap * scale_;
  }
}

void ChartOverlay::paintLegend(vtkContext2D& painter, const Area& area) const
{
  const float width = area.right - area.left;
  const float first_y =
      area.top + (11.0f + legendRow_px * float(legendRows(painter, width) - 1)) * scale_;
  placeLegend(
      painter, width,
      [&](const LegendEntry& entry, const std::string& text, float x, int row, bool isFirst) {
        const float left = area.left + x, y = first_y - float(row) * legendRow_px * scale_;
        if (isFirst) paintSwatch(painter, entry, left, y);
        setText(painter, colorOf(inks_->text), VTK_TEXT_LEFT);
        painter.DrawString(left + (swatchWidth + 7.0f) * scale_, y, text);
      });
}

}  // namespace perilymph::charts

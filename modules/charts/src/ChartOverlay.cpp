#include "ChartOverlay.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkContext2D.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

#include "ChartStyle.h"
#include "perilymph/charts/Typeface.h"

namespace perilymph::charts {

vtkStandardNewMacro(ChartOverlay)

    /// The plot area in pixels, and what it shows.
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

/// A horizontal or vertical line as a filled rectangle on whole pixels: sharp without smoothing.
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

/// A disc with a soft rim, drawn as three shells: software rendering does not smooth edges.
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

  paintZero(*painter, area);
  paintThreshold(*painter, area);
  paintBars(*painter, area);
  paintNow(*painter, area);
  paintLegend(*painter, area);
  return true;
}

void ChartOverlay::setText(vtkContext2D& painter, const vtkColor4ub& color, int justification) const
{
  vtkTextProperty& text = *painter.GetTextProp();
  setTypeface(text);
  text.SetFontSize(static_cast<int>(std::lround(style::labelSize * scale_)));
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
  fillWith(painter, style::zeroLine);
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
  setText(painter, threshold->color, VTK_TEXT_RIGHT);
  painter.DrawString(area.right - 5.0f * scale_, y + 9.0f * scale_, threshold->text);
}

void ChartOverlay::paintBars(vtkContext2D& painter, const Area& area) const
{
  for (const ReferencePoint& point : bars) {
    if (point.travel_mm > area.xHigh || point.travel_mm < area.xLow) continue;
    const float x = area.x(point.travel_mm);
    const float low = std::max(area.bottom, area.y(point.mean_N - point.sd_N));
    const float high = std::min(area.top, area.y(point.mean_N + point.sd_N));
    const float cap = 4.0f * scale_;
    vtkColor4ub quiet = style::text;
    quiet.SetAlpha(200);
    fillWith(painter, quiet);
    bar(painter, x - 0.5f * scale_, low, scale_, high - low);
    bar(painter, x - cap, low, 2.0f * cap, scale_);
    bar(painter, x - cap, high, 2.0f * cap, scale_);
    disc(painter, x, area.y(point.mean_N), 4.0f * scale_, style::text);
    disc(painter, x, area.y(point.mean_N), 2.4f * scale_, style::ground);
  }
}

void ChartOverlay::paintNow(vtkContext2D& painter, const Area& area) const
{
  if (now) disc(painter, area.x(now->x), area.y(now->y), 4.0f * scale_, now->color);
}

void ChartOverlay::paintSwatch(vtkContext2D& painter, const LegendEntry& entry, float x,
                               float y) const
{
  fillWith(painter, entry.color);
  if (entry.swatch == Swatch::line) {
    bar(painter, x, y - scale_, swatchWidth * scale_, 2.0f * scale_);
    return;
  }
  const float middle = x + 0.5f * swatchWidth * scale_;
  bar(painter, middle - 0.5f * scale_, y - 6.0f * scale_, scale_, 12.0f * scale_);
  disc(painter, middle, y, 3.5f * scale_, entry.color);
  disc(painter, middle, y, 2.0f * scale_, style::ground);
}

void ChartOverlay::paintLegend(vtkContext2D& painter, const Area& area) const
{
  const bool isAbove = legendPlace == LegendPlace::above;
  float x = area.left + (isAbove ? 0.0f : 12.0f * scale_);
  float y = isAbove ? area.top + 11.0f * scale_ : area.top - 18.0f * scale_;
  for (const LegendEntry& entry : legend) {
    paintSwatch(painter, entry, x, y);
    setText(painter, style::text, VTK_TEXT_LEFT);
    const float words = x + (swatchWidth + 7.0f) * scale_;
    painter.DrawString(words, y, entry.text);
    if (!isAbove) {
      y -= 17.0f * scale_;
      continue;
    }
    float bounds[4];  // left, bottom, width, height
    painter.ComputeStringBounds(entry.text, bounds);
    x = words + bounds[2] + 16.0f * scale_;
  }
}

}  // namespace perilymph::charts

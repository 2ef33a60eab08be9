// SPDX-License-Identifier: BSD-3-Clause
#include "ChartFrame.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkContext2D.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkPlot.h>
#include <vtkPlotLine.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>
#include <vtkVersionMacros.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "ChartColors.h"
#include "TextStyle.h"
#include "perilymph/figures/Strings.h"

namespace perilymph::charts {
namespace {

void setColor(vtkTextProperty& text, const vtkColor4ub& color)
{
  text.SetColor(color.GetRed() / 255.0, color.GetGreen() / 255.0, color.GetBlue() / 255.0);
}

std::string tickLabel(double value, int decimals, char decimalSign)
{
  if (std::abs(value) < 1e-12) value = 0.0;  // no "-0.00"
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return figures::withDecimalSign(text, decimalSign);
}

}  // namespace

ChartLine::ChartLine(vtkChartXY& chart, const vtkColor4ub& color, float width) : width_(width)
{
  x_->SetName("x");
  y_->SetName("y");
  table_->AddColumn(x_);
  table_->AddColumn(y_);
  plot_ = chart.AddPlot(vtkChart::LINE);
  plot_->SetInputData(table_, 0, 1);
  plot_->SetColor(color.GetRed(), color.GetGreen(), color.GetBlue(), color.GetAlpha());
  plot_->SetWidth(width);
  plot_->SetVisible(false);
}

ChartLine::~ChartLine() = default;

void ChartLine::setDash(double on, double off)
{
  dashOn_ = on;
  dashOff_ = off;
  // pairs of points instead of one line through all: VTK's own dashes need OpenGL's old profile
  vtkPlotLine::SafeDownCast(plot_)->SetPolyLine(on <= 0.0);
}

template <class Add>
void ChartLine::addDashes(const std::array<double, 2>& from, const std::array<double, 2>& to,
                          double phase, Add add) const
{
  const double period = dashOn_ + dashOff_, width = to[0] - from[0];
  const auto yAt = [&](double x) {
    return width > 0.0 ? from[1] + (x - from[0]) / width * (to[1] - from[1]) : to[1];
  };
  double x = from[0];
  do {
    const double inPeriod = std::fmod(x + phase, period) + (x + phase < 0.0 ? period : 0.0);
    const bool isOn = inPeriod < dashOn_;
    // a little further than the dash's end, so that rounding never stops at it
    const double end = std::min(to[0], x + (isOn ? dashOn_ : period) - inPeriod + 1e-6 * period);
    if (isOn) {
      add(x, width > 0.0 ? yAt(x) : from[1]);
      add(end, yAt(end));
    }
    x = end;
  } while (x < to[0]);
}

void ChartLine::set(const std::vector<float>& x, const std::vector<float>& y, double phase)
{
  x_->Reset();
  y_->Reset();
  const auto add = [this](double xValue, double yValue) {
    x_->InsertNextValue(static_cast<float>(xValue));
    y_->InsertNextValue(static_cast<float>(yValue));
  };
  if (dashOn_ <= 0.0)
    for (std::size_t i = 0; i < x.size(); ++i) add(x[i], y[i]);
  else
    for (std::size_t i = 0; i + 1 < x.size(); ++i)
      addDashes({x[i], y[i]}, {x[i + 1], y[i + 1]}, phase, add);
  const vtkIdType count = x_->GetNumberOfValues();
  x_->Modified();
  y_->Modified();
  table_->Modified();
  setVisible(count > 1);  // a line plot without points issues a warning
}

void ChartLine::setVisible(bool visible)
{
  plot_->SetVisible(visible && x_->GetNumberOfValues() > 1);
}

void ChartLine::setScale(double pixelRatio)
{
  plot_->SetWidth(static_cast<float>(width_ * pixelRatio));
}

ChartFrame::ChartFrame(const std::string& xTitle, const std::string& yTitle,
                       const ChartStyle& style)
    : inks_(figures::paletteOf(style.scheme)), decimalSign_(style.strings.decimalSign)
{
  overlay_->setInks(inks_);
  renderer_->SetBackground(inks_.panel.rgb[0] / 255.0, inks_.panel.rgb[1] / 255.0,
                           inks_.panel.rgb[2] / 255.0);
  renderer_->AddActor(actor_);
  actor_->GetScene()->SetRenderer(renderer_);
  legendSpace_->chart = chart_;
  legendSpace_->overlay = overlay_;
  actor_->GetScene()->AddItem(legendSpace_);
  actor_->GetScene()->AddItem(chart_);
  actor_->GetScene()->AddItem(overlay_);
  overlay_->setChart(chart_);

  chart_->SetRenderEmpty(true);
  chart_->SetAutoAxes(false);  // it would hide the axes until there is a curve
  for (const int position : {vtkAxis::RIGHT, vtkAxis::TOP})
    chart_->GetAxis(position)->SetVisible(false);
  chart_->SetLayoutStrategy(vtkChart::FILL_RECT);  // of LegendSpace
  chart_->SetShowLegend(false);
  chart_->SetForceAxesToBounds(false);
  chart_->ForceAxesToBoundsOff();
  chart_->SetBorders(8, 8, 8, 8);
  vtkNew<vtkBrush> ground;
  // VTK 9.1 fills the plot with it, VTK 9.3 titles and labels too.
  constexpr bool isPlotOnly = VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0);
  ground->SetColor(colorOf(isPlotOnly ? inks_.ground : inks_.panel));
  chart_->SetBackgroundBrush(ground);
  styleAxis(vtkAxis::BOTTOM, xTitle);
  styleAxis(vtkAxis::LEFT, yTitle);
  setScale(1.0);
}

ChartFrame::~ChartFrame() = default;

vtkStandardNewMacro(LegendSpace)

    bool LegendSpace::Paint(vtkContext2D* painter)
{
  constexpr double sides_px = 78.0;  // both axes' labels and borders beside the plot
  const double width = GetScene()->GetSceneWidth() - sides_px * pixelRatio;
  const int rows = overlay->legendRows(*painter, static_cast<float>(width));
  const double above_px = ChartOverlay::legendRow_px * double(std::max(0, rows - 1));
  const vtkRectf below(0.0f, 0.0f, static_cast<float>(GetScene()->GetSceneWidth()),
                       static_cast<float>(GetScene()->GetSceneHeight() - above_px * pixelRatio));
  if (below == chart->GetSize()) return true;
  chart->SetSize(below);
  chart->Modified();
  return true;
}

void ChartFrame::attachTo(vtkRenderWindow& window)
{
  window.SetMultiSamples(0);
  window.SetLineSmoothing(true);
  window.AddRenderer(renderer_);
}

void ChartFrame::styleAxis(int position, const std::string& title)
{
  vtkAxis& axis = *chart_->GetAxis(position);
  axis.SetTitle(title);
  axis.SetBehavior(vtkAxis::FIXED);
  axis.SetTicksVisible(false);
  axis.GetPen()->SetColor(colorOf(inks_.grid));
  axis.GetGridPen()->SetColor(colorOf(inks_.grid));
  axis.SetGridVisible(true);
  for (vtkTextProperty* text : {axis.GetLabelProperties(), axis.GetTitleProperties()}) {
    setTypeface(*text);
    setColor(*text, colorOf(inks_.quiet));
    text->SetBold(false);
    text->SetItalic(false);
  }
}

void ChartFrame::setScale(double pixelRatio)
{
  const int size = static_cast<int>(std::lround(figures::labelSize * pixelRatio));
  for (const int position : {vtkAxis::BOTTOM, vtkAxis::LEFT}) {
    vtkAxis& axis = *chart_->GetAxis(position);
    axis.GetLabelProperties()->SetFontSize(size);
    axis.GetTitleProperties()->SetFontSize(size);
    axis.GetGridPen()->SetWidth(static_cast<float>(pixelRatio));
    axis.GetPen()->SetWidth(static_cast<float>(pixelRatio));
  }
  chart_->SetHiddenAxisBorder(static_cast<int>(std::lround(20.0 * pixelRatio)));
  legendSpace_->pixelRatio = pixelRatio;
  overlay_->setScale(pixelRatio);
}

void ChartFrame::setTitles(const std::string& x, const std::string& y)
{
  chart_->GetAxis(vtkAxis::BOTTOM)->SetTitle(x);
  chart_->GetAxis(vtkAxis::LEFT)->SetTitle(y);
}

void ChartFrame::setXRange(const AxisRange& range, int decimals)
{
  std::vector<std::string> labels;
  for (const double place : tickPlaces(range))
    labels.push_back(tickLabel(place, decimals, decimalSign_));
  setRange(vtkAxis::BOTTOM, range, labels);
}

void ChartFrame::setYRange(const AxisRange& range, int decimals)
{
  std::vector<std::string> labels;
  for (const double place : tickPlaces(range))
    labels.push_back(tickLabel(place, decimals, decimalSign_));
  setRange(vtkAxis::LEFT, range, labels);
}

void ChartFrame::setXLabels(const AxisRange& range, const std::vector<std::string>& labels)
{
  setRange(vtkAxis::BOTTOM, range, labels);
}

void ChartFrame::setRange(int position, const AxisRange& range,
                          const std::vector<std::string>& labels)
{
  vtkNew<vtkDoubleArray> places;
  vtkNew<vtkStringArray> label;
  std::size_t index = 0;
  for (const double place : tickPlaces(range)) {
    places->InsertNextValue(place);
    label->InsertNextValue(index < labels.size() ? labels[index] : std::string());
    ++index;
  }
  vtkAxis& axis = *chart_->GetAxis(position);
  axis.SetUnscaledRange(range.low, range.high);
  axis.SetCustomTickPositions(places, label);
  overlay_->Modified();
}

}  // namespace perilymph::charts

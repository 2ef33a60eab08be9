// SPDX-License-Identifier: BSD-3-Clause
#include "ChartFrame.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkPen.h>
#include <vtkPlot.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <algorithm>
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

void ChartLine::set(const std::vector<float>& x, const std::vector<float>& y)
{
  const vtkIdType count = static_cast<vtkIdType>(x.size());
  x_->SetNumberOfValues(count);
  y_->SetNumberOfValues(count);
  std::copy(x.begin(), x.end(), x_->GetPointer(0));
  std::copy(y.begin(), y.end(), y_->GetPointer(0));
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
    : inks_(figures::inksOf(style.scheme)), decimalSign_(style.strings.decimalSign)
{
  overlay_->setInks(inks_);
  renderer_->SetBackground(inks_.panel.rgb[0] / 255.0, inks_.panel.rgb[1] / 255.0,
                           inks_.panel.rgb[2] / 255.0);
  renderer_->AddActor(actor_);
  actor_->GetScene()->SetRenderer(renderer_);
  actor_->GetScene()->AddItem(chart_);
  actor_->GetScene()->AddItem(overlay_);
  overlay_->setChart(chart_);

  chart_->SetRenderEmpty(true);
  chart_->SetAutoAxes(false);  // it would hide the axes until there is a curve
  for (const int position : {vtkAxis::RIGHT, vtkAxis::TOP})
    chart_->GetAxis(position)->SetVisible(false);
  chart_->SetShowLegend(false);
  chart_->SetForceAxesToBounds(false);
  chart_->ForceAxesToBoundsOff();
  chart_->SetBorders(8, 8, 8, 8);
  vtkNew<vtkBrush> ground;
  ground->SetColor(colorOf(inks_.ground));
  chart_->SetBackgroundBrush(ground);
  styleAxis(vtkAxis::BOTTOM, xTitle);
  styleAxis(vtkAxis::LEFT, yTitle);
  setScale(1.0);
}

ChartFrame::~ChartFrame() = default;

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
  // Above the plot stands the legend; 20 pixels are VTK's own border at ratio 1.
  chart_->SetHiddenAxisBorder(static_cast<int>(std::lround(20.0 * pixelRatio)));
  overlay_->setScale(pixelRatio);
}

void ChartFrame::setXRange(const AxisRange& range)
{
  std::vector<std::string> labels;
  for (const double place : tickPlaces(range)) labels.push_back(tickLabel(place, 0, decimalSign_));
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

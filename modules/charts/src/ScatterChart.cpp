// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/charts/ScatterChart.h"

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPlotPoints.h>
#include <vtkTable.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "ChartColors.h"
#include "ChartFrame.h"

namespace perilymph::charts {

namespace {

/// Marks are smaller where there are many (choice, high).
constexpr double mark_px = 9.0, smallMark_px = 6.0;
constexpr std::size_t manyPoints = 3000;
constexpr int ticksOfAnAxis = 7;
/// Opacity of a mark: dense clouds stay readable.
constexpr unsigned char markAlpha = 190;

/// Shapes tell the groups apart without their colors; the last one is a smaller disk. A cross is on
/// points that are crossed out.
constexpr std::array<int, ScatterChart::distinctGroups> shapes{
    vtkPlotPoints::CIRCLE, vtkPlotPoints::SQUARE, vtkPlotPoints::DIAMOND, vtkPlotPoints::PLUS,
    vtkPlotPoints::CIRCLE};
constexpr std::array<double, ScatterChart::distinctGroups> sizes{1.0, 1.0, 1.0, 1.0, 0.6};

std::array<figures::Ink, ScatterChart::distinctGroups> inksOfGroups(const figures::Palette& inks)
{
  return {inks.accent, inks.orange, inks.blue, inks.membrane, inks.text};
}

AxisRange rangeOf(double low, double high)
{
  if (!(high > low)) {
    const double half = std::max(0.5, 0.05 * std::fabs(low));
    low -= half;
    high += half;
  }
  // from a whole tick to a whole tick
  const double tick = nextNice((high - low) / ticksOfAnAxis);
  return {tick * std::floor(low / tick), tick * std::ceil(high / tick), tick};
}

int decimalsOf(const AxisRange& range)
{
  return std::clamp(static_cast<int>(std::ceil(-std::log10(range.tick) - 1e-9)), 0, 6);
}

}  // namespace

/// Points with their table.
class ScatterMarks {
public:
  ScatterMarks(vtkChartXY& chart, const vtkColor4ub& color, int shape, double size) : size_(size)
  {
    x_->SetName("x");
    y_->SetName("y");
    table_->AddColumn(x_);
    table_->AddColumn(y_);
    plot_ = vtkPlotPoints::SafeDownCast(chart.AddPlot(vtkChart::POINTS));
    plot_->SetInputData(table_, 0, 1);
    plot_->SetMarkerStyle(shape);
    plot_->SetColor(color.GetRed(), color.GetGreen(), color.GetBlue(), color.GetAlpha());
    plot_->SetSelectable(false);
    plot_->SetVisible(false);
    setSize(mark_px, 1.0);
  }

  void set(const std::vector<float>& x, const std::vector<float>& y)
  {
    const auto count = static_cast<vtkIdType>(std::min(x.size(), y.size()));
    x_->SetNumberOfValues(count);
    y_->SetNumberOfValues(count);
    for (vtkIdType i = 0; i < count; ++i) {
      x_->SetValue(i, x[static_cast<std::size_t>(i)]);
      y_->SetValue(i, y[static_cast<std::size_t>(i)]);
    }
    x_->Modified();
    y_->Modified();
    table_->Modified();
    plot_->SetVisible(count > 0);  // a plot without points issues a warning
  }

  void setSize(double size_px, double pixelRatio)
  {
    plot_->SetMarkerSize(static_cast<float>(size_ * size_px * pixelRatio));
    plot_->SetWidth(static_cast<float>(1.5 * pixelRatio));
  }

private:
  double size_;  // relative to the others
  vtkNew<vtkTable> table_;
  vtkNew<vtkFloatArray> x_, y_;
  vtkPlotPoints* plot_;  // owned by the chart
};

struct ScatterChart::Content {
  explicit Content(const ChartStyle& style)
      : inks(figures::paletteOf(style.scheme)), frame({}, {}, style)
  {
    const auto colors = inksOfGroups(inks);
    for (std::size_t i = 0; i < distinctGroups; ++i) {
      vtkColor4ub color = colorOf(colors[i]);
      color.SetAlpha(markAlpha);
      marks.push_back(std::make_unique<ScatterMarks>(frame.chart(), color, shapes[i], sizes[i]));
    }
    crosses = std::make_unique<ScatterMarks>(frame.chart(), colorOf(inks.text),
                                             vtkPlotPoints::CROSS, 1.0);
  }

  const ScatterGroup* groupOf(std::uint32_t id, std::size_t& index) const;
  void showPoints();

  const figures::Palette& inks;
  ChartFrame frame;
  std::vector<std::unique_ptr<ScatterMarks>> marks;
  std::unique_ptr<ScatterMarks> crosses;
  std::string crossedLabel;
  double pixelRatio = 1.0;
  std::vector<ScatterGroup> groups;
  std::optional<std::uint32_t> selected;
  AxisRange x, y;
  bool isChanged = true;
};

const ScatterGroup* ScatterChart::Content::groupOf(std::uint32_t id, std::size_t& index) const
{
  for (const ScatterGroup& group : groups) {
    const auto found = std::find(group.ids.begin(), group.ids.end(), id);
    if (found == group.ids.end()) continue;
    index = static_cast<std::size_t>(found - group.ids.begin());
    return &group;
  }
  return nullptr;
}

void ScatterChart::Content::showPoints()
{
  std::size_t count = 0;
  std::vector<float> crossedX, crossedY;
  for (const ScatterGroup& group : groups) {
    count += group.ids.size();
    for (std::size_t i = 0; i < group.isCrossed.size(); ++i)
      if (group.isCrossed[i]) {
        crossedX.push_back(group.x[i]);
        crossedY.push_back(group.y[i]);
      }
  }
  const double size_px = count > manyPoints ? smallMark_px : mark_px;
  for (const auto& each : marks) each->setSize(size_px, pixelRatio);
  crosses->setSize(size_px, pixelRatio);
  crosses->set(crossedX, crossedY);
  for (std::size_t i = 0; i < distinctGroups; ++i) {
    std::vector<float> allX, allY;
    for (std::size_t k = i; k < groups.size(); k += distinctGroups) {
      allX.insert(allX.end(), groups[k].x.begin(), groups[k].x.end());
      allY.insert(allY.end(), groups[k].y.begin(), groups[k].y.end());
    }
    marks[i]->set(allX, allY);
  }
  ChartOverlay& overlay = frame.overlay();
  overlay.legend.clear();
  const auto colors = inksOfGroups(inks);
  for (std::size_t i = 0; i < groups.size(); ++i)
    if (!groups[i].label.empty())
      overlay.legend.push_back({Swatch::mark, colorOf(colors[i % distinctGroups]), groups[i].label,
                                shapes[i % distinctGroups]});
  if (!crossedX.empty() && !crossedLabel.empty())
    overlay.legend.push_back(
        {Swatch::mark, colorOf(inks.text), crossedLabel, vtkPlotPoints::CROSS});
  overlay.trends.clear();
  for (std::size_t i = 0; i < groups.size(); ++i)
    if (!groups[i].trend.empty())
      overlay.trends.push_back({groups[i].trend, colorOf(colors[i % distinctGroups])});

  std::size_t index = 0;
  const ScatterGroup* group = selected ? groupOf(*selected, index) : nullptr;
  overlay.ringed.reset();
  if (group != nullptr) overlay.ringed = Dot{group->x[index], group->y[index], colorOf(inks.text)};
  overlay.Modified();
  frame.setXRange(x, decimalsOf(x));
  frame.setYRange(y, decimalsOf(y));
}

ScatterChart::ScatterChart(const ChartStyle& style) : content_(std::make_unique<Content>(style)) {}

ScatterChart::~ScatterChart() = default;

void ScatterChart::attachTo(vtkRenderWindow& window) { content_->frame.attachTo(window); }

void ScatterChart::setScale(double pixelRatio)
{
  content_->frame.setScale(pixelRatio);
  content_->pixelRatio = pixelRatio;
  content_->isChanged = true;
}

void ScatterChart::setTitles(const std::string& x, const std::string& y)
{
  content_->frame.setTitles(x, y);
  content_->isChanged = true;
}

void ScatterChart::setRanges(double lowX, double highX, double lowY, double highY)
{
  content_->x = rangeOf(lowX, highX);
  content_->y = rangeOf(lowY, highY);
  content_->isChanged = true;
}

void ScatterChart::setCrossedLabel(const std::string& label)
{
  content_->crossedLabel = label;
  content_->isChanged = true;
}

void ScatterChart::setGroups(std::vector<ScatterGroup> groups)
{
  for (ScatterGroup& group : groups) {
    ScatterGroup finite{std::move(group.label), {}, {}, {}, {}, std::move(group.trend)};
    const std::size_t count = std::min({group.x.size(), group.y.size(), group.ids.size()});
    finite.x.reserve(count);
    finite.y.reserve(count);
    finite.ids.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      if (!std::isfinite(group.x[i]) || !std::isfinite(group.y[i])) continue;
      finite.x.push_back(group.x[i]);
      finite.y.push_back(group.y[i]);
      finite.ids.push_back(group.ids[i]);
      if (i < group.isCrossed.size()) finite.isCrossed.push_back(group.isCrossed[i]);
    }
    group = std::move(finite);
  }
  content_->groups = std::move(groups);
  content_->isChanged = true;
}

void ScatterChart::setSelected(std::optional<std::uint32_t> id)
{
  content_->selected = id;
  content_->isChanged = true;
}

std::optional<std::uint32_t> ScatterChart::pick(double x, double y, double reach) const
{
  vtkAxis& bottom = *content_->frame.chart().GetAxis(vtkAxis::BOTTOM);
  vtkAxis& left = *content_->frame.chart().GetAxis(vtkAxis::LEFT);
  const double left_px = bottom.GetPoint1()[0], right_px = bottom.GetPoint2()[0];
  const double bottom_px = left.GetPoint1()[1], top_px = left.GetPoint2()[1];
  const AxisRange &xs = content_->x, &ys = content_->y;
  const double perX = (right_px - left_px) / (xs.high - xs.low);
  const double perY = (top_px - bottom_px) / (ys.high - ys.low);
  double nearest = reach * reach;
  std::optional<std::uint32_t> found;
  for (const ScatterGroup& group : content_->groups)
    for (std::size_t i = 0; i < group.ids.size(); ++i) {
      const double dx = left_px + (static_cast<double>(group.x[i]) - xs.low) * perX - x;
      const double dy = bottom_px + (static_cast<double>(group.y[i]) - ys.low) * perY - y;
      const double square = dx * dx + dy * dy;
      if (!(square <= nearest)) continue;
      nearest = square;
      found = group.ids[i];
    }
  return found;
}

bool ScatterChart::update()
{
  if (!content_->isChanged) return false;
  content_->isChanged = false;
  content_->showPoints();
  return true;
}

vtkChartXY& ScatterChart::chart() { return content_->frame.chart(); }

}  // namespace perilymph::charts

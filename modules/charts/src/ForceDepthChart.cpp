// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/charts/ForceDepthChart.h"

#include <vtkChartXY.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "ChartColors.h"
#include "ChartFrame.h"
#include "TravelColumns.h"
#include "perilymph/analysis/Reference.h"
#include "perilymph/figures/Strings.h"

namespace perilymph::charts {
namespace {

constexpr AxisRange usualTravel_mm{0.0, 17.0, 4.0};
/// Slightly below zero: a free array has forces of some millinewtons of either sign at the
/// tweezers. Soft arrays stay below 50 mN, the published one reaches 150.
constexpr AxisRange usualForces_mN[] = {
    {-5.0, 50.0, 10.0}, {-10.0, 100.0, 20.0}, {-10.0, 200.0, 50.0}};

const AxisRange& usualForce_mN(double high_mN)
{
  const auto* const found = std::ranges::find_if(
      usualForces_mN, [high_mN](const AxisRange& range) { return high_mN <= range.high; });
  return found == std::end(usualForces_mN) ? *std::prev(found) : *found;
}

constexpr double ghostDash_mm = 0.35;  ///< 7 px at the usual range and size.

vtkColor4ub faded(vtkColor4ub color, unsigned char alpha)
{
  color.SetAlpha(alpha);
  return color;
}

}  // namespace

struct ForceDepthChart::Content {
  explicit Content(const ChartStyle& given)
      : strings(given.strings),
        inks(figures::paletteOf(given.scheme)),
        frame(strings.travel, strings.axialForce, given),
        ghostLine(frame.chart(), colorOf(inks.blue), thinWidth),
        outLine(frame.chart(), faded(colorOf(inks.accent), 150), thinWidth),
        inLine(frame.chart(), colorOf(inks.accent), lineWidth)
  {
    ghostLine.setDash(ghostDash_mm, ghostDash_mm);
  }

  ChartStrings strings;
  const figures::Palette& inks;
  Result<Force> felt = analysis::forceFeltBySurgeons();
  ChartFrame frame;
  ChartLine ghostLine, outLine, inLine;
  TravelColumns columns;
  std::vector<float> x, y;  // memory of one curve

  bool hasGhost = false;
  double ghostTravel_mm = 0.0, ghostLow_mN = 0.0, ghostHigh_mN = 0.0;
  std::string ghostLabel;
  std::vector<ReferencePoint> reference;
  std::string referenceLabel;
  std::vector<ExpectedForce> expected;
  std::string expectedLabel;
  std::vector<std::pair<double, std::string>> travelMarks;
  bool showsGhost = true, showsReference = true, showsThreshold = true;

  bool isChanged = true;
  AxisRange travel_mm = usualTravel_mm;
  AxisRange force_mN = usualForces_mN[0];

  void setRanges();
  void setMarks();
};

void ForceDepthChart::Content::setRanges()
{
  double low_mN = 0.0, high_mN = 0.0, left_mm = 0.0, right_mm = 0.0;
  const auto include = [&](double travelLow, double travelHigh, double forceLow, double forceHigh) {
    left_mm = std::min(left_mm, travelLow);
    right_mm = std::max(right_mm, travelHigh);
    low_mN = std::min(low_mN, forceLow);
    high_mN = std::max(high_mN, forceHigh);
  };
  if (!columns.isEmpty())
    include(columns.lowestTravel_mm(), columns.highestTravel_mm(), columns.lowestForce_mN(),
            columns.highestForce_mN());
  if (hasGhost && showsGhost) include(0.0, ghostTravel_mm, ghostLow_mN, ghostHigh_mN);
  for (const ExpectedForce& point : expected)
    include(0.0, point.travel_mm, point.low_mN, point.high_mN);
  if (showsReference)
    for (const ReferencePoint& point : reference)
      include(0.0, point.travel_mm, point.mean_mN - point.sd_mN, point.mean_mN + point.sd_mN);

  // Tremor at the start must not move the axis.
  if (left_mm > -0.5) left_mm = 0.0;
  travel_mm = grown(usualTravel_mm, left_mm, right_mm);
  force_mN = grown(usualForce_mN(high_mN), low_mN, high_mN);
  frame.setXRange(travel_mm);
  frame.setYRange(force_mN, 0);
}

void ForceDepthChart::Content::setMarks()
{
  ChartOverlay& overlay = frame.overlay();
  overlay.legend.clear();
  overlay.legend.push_back({Swatch::line, colorOf(inks.accent), strings.thisInsertion});
  if (hasGhost && showsGhost)
    overlay.legend.push_back({Swatch::dashes, colorOf(inks.blue), ghostLabel});
  if (!reference.empty() && showsReference)
    overlay.legend.push_back({Swatch::bar, colorOf(inks.text), referenceLabel});

  if (!expected.empty())
    overlay.legend.push_back({Swatch::dots, colorOf(inks.blue), expectedLabel});

  overlay.expected = expected;
  overlay.marks = travelMarks;
  overlay.bars = showsReference ? reference : std::vector<ReferencePoint>();
  overlay.threshold.reset();
  if (showsThreshold && felt) {
    overlay.threshold = Threshold{inMillinewtons(*felt), colorOf(inks.orange)};
    const std::string number = figures::fixed(inMillinewtons(*felt), 0);
    overlay.legend.push_back(
        {Swatch::level, colorOf(inks.orange), figures::filled(strings.feltBySurgeons, {number})});
  }
  overlay.now.reset();
  if (!columns.isEmpty())
    overlay.now = Dot{columns.lastTravel_mm(), columns.lastForce_mN(), colorOf(inks.accent)};
  overlay.Modified();
}

ForceDepthChart::ForceDepthChart(const ChartStyle& style)
    : content_(std::make_unique<Content>(style))
{
  update();
}

ForceDepthChart::~ForceDepthChart() = default;

void ForceDepthChart::attachTo(vtkRenderWindow& window) { content_->frame.attachTo(window); }

void ForceDepthChart::append(Length travel, Force axial)
{
  content_->columns.append(inMillimeters(travel), inMillinewtons(axial));
  content_->isChanged = true;
}

void ForceDepthChart::clear()
{
  content_->columns.clear();
  content_->isChanged = true;
}

void ForceDepthChart::setGhost(const std::vector<std::pair<Length, Force>>& curve,
                               std::string label)
{
  TravelColumns columns;
  for (const auto& [travel, force] : curve)
    columns.append(inMillimeters(travel), inMillinewtons(force));
  content_->hasGhost = !columns.isEmpty();
  content_->ghostTravel_mm = columns.highestTravel_mm();
  content_->ghostLow_mN = columns.lowestForce_mN();
  content_->ghostHigh_mN = columns.highestForce_mN();
  content_->ghostLabel = std::move(label);
  columns.curve(Direction::in, content_->x, content_->y);
  content_->ghostLine.set(content_->x, content_->y);
  content_->isChanged = true;
}

void ForceDepthChart::setReference(std::vector<ReferencePoint> points, std::string label)
{
  content_->reference = std::move(points);
  content_->referenceLabel = std::move(label);
  content_->isChanged = true;
}

void ForceDepthChart::setExpected(std::vector<ExpectedForce> points, std::string label)
{
  content_->expected = std::move(points);
  content_->expectedLabel = std::move(label);
  content_->isChanged = true;
}

void ForceDepthChart::setTravelMarks(std::vector<std::pair<double, std::string>> marks)
{
  content_->travelMarks = std::move(marks);
  content_->isChanged = true;
}

void ForceDepthChart::setVisible(ChartLayer layer, bool visible)
{
  switch (layer) {
    case ChartLayer::ghost:
      content_->showsGhost = visible;
      break;
    case ChartLayer::reference:
      content_->showsReference = visible;
      break;
    case ChartLayer::threshold:
      content_->showsThreshold = visible;
      break;
  }
  content_->isChanged = true;
}

void ForceDepthChart::setScale(double pixelRatio)
{
  content_->frame.setScale(pixelRatio);
  content_->inLine.setScale(pixelRatio);
  content_->outLine.setScale(pixelRatio);
  content_->ghostLine.setScale(pixelRatio);
  content_->isChanged = true;
}

bool ForceDepthChart::update()
{
  Content& now = *content_;
  if (!now.isChanged) return false;
  now.isChanged = false;

  now.columns.curve(Direction::in, now.x, now.y);
  now.inLine.set(now.x, now.y);
  now.columns.curve(Direction::out, now.x, now.y);
  now.outLine.set(now.x, now.y);
  now.ghostLine.setVisible(now.hasGhost && now.showsGhost);
  now.setRanges();
  now.setMarks();
  return true;
}

vtkChartXY& ForceDepthChart::chart() { return content_->frame.chart(); }

}  // namespace perilymph::charts

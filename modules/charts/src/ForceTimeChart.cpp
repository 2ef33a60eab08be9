// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/charts/ForceTimeChart.h"

#include <vtkChartXY.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ChartColors.h"
#include "ChartFrame.h"

namespace perilymph::charts {
namespace {

/// Time is divided into slots of about one pixel; for each the minimum and maximum are kept.
constexpr int slots = 400;
constexpr double slotTime_s = inSeconds(ForceTimeChart::span) / slots;
constexpr int components = 3;
constexpr double dash_s = 0.12, dot_s = 0.04;  ///< 8 and 3 px at the usual width.
constexpr AxisRange usualForce_mN{-20.0, 60.0, 20.0};

}  // namespace

struct ForceTimeChart::Content {
  /// Minimum and maximum of each component within one time slot.
  struct Slot {
    long long number = -1;  ///< Number of slots since time zero; -1: empty.
    std::array<float, components> low{}, high{};
  };

  explicit Content(const ChartStyle& given)
      : strings(given.strings),
        inks(figures::paletteOf(given.scheme)),
        frame("", strings.force, given),
        lines{ChartLine{frame.chart(), colorOf(inks.accent), lineWidth},
              ChartLine{frame.chart(), colorOf(inks.orange), thinWidth},
              ChartLine{frame.chart(), colorOf(inks.blue), thinWidth}}
  {
    lines[1].setDash(dot_s, dot_s);
    lines[2].setDash(dash_s, 0.6 * dash_s);
  }

  ChartStrings strings;
  const figures::Palette& inks;
  ChartFrame frame;
  std::array<ChartLine, components> lines;
  std::array<Slot, slots + 1> ring{};
  double now_s = -1.0;
  long long newest = -1;
  bool isChanged = true;
  std::vector<float> x, y;  // memory of one line

  void setRange();
  void setLine(std::size_t component);
};

void ForceTimeChart::Content::setRange()
{
  float low = 0.0f, high = 0.0f;
  for (const Slot& slot : ring) {
    if (slot.number < 0 || slot.number < newest - slots) continue;
    low = std::min(low, *std::min_element(slot.low.begin(), slot.low.end()));
    high = std::max(high, *std::max_element(slot.high.begin(), slot.high.end()));
  }
  frame.setYRange(grown(usualForce_mN, low, high, 5), 0);
  frame.setXLabels({-inSeconds(span), 0.0, inSeconds(span)}, {"−5 s", strings.now});
}

void ForceTimeChart::Content::setLine(std::size_t component)
{
  x.clear();
  y.clear();
  for (long long number = std::max(0LL, newest - slots); number <= newest; ++number) {
    const Slot& slot = ring[static_cast<std::size_t>(number % (slots + 1))];
    if (slot.number != number) continue;
    const float time_s = static_cast<float>(static_cast<double>(number - newest) * slotTime_s);
    x.push_back(time_s);
    y.push_back(slot.low[component]);
    if (slot.high[component] == slot.low[component]) continue;
    x.push_back(time_s + 0.5f * static_cast<float>(slotTime_s));
    y.push_back(slot.high[component]);
  }
  lines[component].set(x, y, static_cast<double>(newest) * slotTime_s);
}

ForceTimeChart::ForceTimeChart(const ChartStyle& style) : content_(std::make_unique<Content>(style))
{
  const ChartStrings& strings = content_->strings;
  const figures::Palette& inks = content_->inks;
  ChartOverlay& overlay = content_->frame.overlay();
  overlay.legend = {{Swatch::line, colorOf(inks.accent), strings.axial},
                    {Swatch::dots, colorOf(inks.orange), strings.lateral},
                    {Swatch::dashes, colorOf(inks.blue), strings.vertical}};
  update();
}

ForceTimeChart::~ForceTimeChart() = default;

void ForceTimeChart::attachTo(vtkRenderWindow& window) { content_->frame.attachTo(window); }

void ForceTimeChart::append(Duration time, const ForceComponents& force)
{
  const std::array<double, components> value_mN{
      inMillinewtons(force.axial), inMillinewtons(force.lateral), inMillinewtons(force.vertical)};
  for (const double value : value_mN)
    if (!std::isfinite(value)) return;
  const double time_s = inSeconds(time);
  if (!(time_s >= 0.0 && time_s < 1e9)) return;
  if (time_s < content_->now_s) clear();

  const long long number = static_cast<long long>(time_s / slotTime_s);
  Content::Slot& slot = content_->ring[static_cast<std::size_t>(number % (slots + 1))];
  const bool isNew = slot.number != number;
  slot.number = number;
  for (std::size_t i = 0; i < components; ++i) {
    const float value = static_cast<float>(value_mN[i]);
    slot.low[i] = isNew ? value : std::min(slot.low[i], value);
    slot.high[i] = isNew ? value : std::max(slot.high[i], value);
  }
  content_->newest = number;
  content_->now_s = time_s;
  content_->isChanged = true;
}

void ForceTimeChart::clear()
{
  content_->ring.fill(Content::Slot{});
  content_->now_s = -1.0;
  content_->newest = -1;
  content_->isChanged = true;
}

void ForceTimeChart::setScale(double pixelRatio)
{
  content_->frame.setScale(pixelRatio);
  for (ChartLine& line : content_->lines) line.setScale(pixelRatio);
  content_->isChanged = true;
}

bool ForceTimeChart::update()
{
  if (!content_->isChanged) return false;
  content_->isChanged = false;
  content_->setRange();
  for (std::size_t i = 0; i < components; ++i) content_->setLine(i);
  return true;
}

vtkChartXY& ForceTimeChart::chart() { return content_->frame.chart(); }

}  // namespace perilymph::charts

// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/ForceProfile.h"

#include <algorithm>
#include <cmath>

#include "perilymph/session/Highlights.h"

namespace perilymph::analysis {

namespace {

/// Moving average over five points, fewer at the ends.
std::vector<CurvePoint> smoothed(const std::vector<CurvePoint>& curve)
{
  constexpr std::size_t half = 2;
  std::vector<CurvePoint> result = curve;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    // At the ends the window shrinks symmetrically, so that a straight line is preserved.
    const std::size_t reach = std::min({half, i, curve.size() - 1 - i});
    double sum = 0.0;
    for (std::size_t j = i - reach; j <= i + reach; ++j) sum += curve[j].force;
    result[i].force = sum / static_cast<double>(2 * reach + 1);
  }
  return result;
}

enum class Extremum { maximum, minimum };

/// The largest local extremum with low <= travel <= high.
std::optional<CurvePoint> strongest(const std::vector<CurvePoint>& curve, Extremum kind, double low,
                                    double high)
{
  const double sign = kind == Extremum::maximum ? 1.0 : -1.0;
  const double slack = 1e-6 * profileStep().si();  // travels are multiples with rounding errors
  std::optional<CurvePoint> best;
  for (std::size_t i = 1; i + 1 < curve.size(); ++i) {
    if (curve[i].travel < low - slack || curve[i].travel > high + slack) continue;
    if (sign * (curve[i].force - curve[i - 1].force) <= 0.0) continue;
    std::size_t next = i + 1;
    while (next < curve.size() && curve[next].force == curve[i].force) ++next;
    if (next == curve.size() || sign * (curve[i].force - curve[next].force) <= 0.0) continue;
    if (!best || sign * (curve[i].force - best->force) > 0.0) best = curve[i];
  }
  return best;
}

}  // namespace

void ForceProfiler::add(const haptics::TickRecord& record)
{
  const haptics::TickOutput& now = record.output;
  ++profile_.ticks;
  if (now.status & haptics::notConverged) ++profile_.ticksNotConverged;
  // Idle: the array was reset to its start, which is not work of the hand.
  if (now.workflow == haptics::Workflow::idle) {
    before_.reset();
    stop_.add(now);
    return;
  }
  follow(now);
  before_ = now;
}

void ForceProfiler::followRest(const haptics::TickOutput& now)
{
  const bool isOver = now.workflow == haptics::Workflow::finished;
  if (ended_) {
    rest_.add(now.time, now.axialForce);
    isWithdrawn_ = isWithdrawn_ || !isOver;
    const bool isDue = now.time >= *ended_ + shortRest().si() - timeRounding;
    if (isDue && !isWithdrawn_ && !profile_.forceAfter1s) profile_.forceAfter1s = rest_.mean();
    return;
  }
  // the line is only computed where the deepest tick may have been
  const bool isDeeper = now.depth > profile_.deepest;
  if (isDeepest_ && !isDeeper) profile_.endForce = stop_.value();
  isDeepest_ = isDeeper;
  stop_.add(now);
  if (!isOver || now.depth <= 0.5 * profile_.deepest) return;
  ended_ = now.time;
  isDeepest_ = false;
  profile_.endForce = stop_.value();
}

void ForceProfiler::follow(const haptics::TickOutput& now)
{
  const bool isFirst = !before_.has_value();
  if (haptics::raisesPeak(now, profile_.peak.force)) {
    profile_.peak = {now.travel, now.axialForce};
    profile_.peakDepth = now.depth;
  }
  profile_.wallForceMax = std::max(profile_.wallForceMax, now.wallForceMax);
  profile_.partitionForceMax = std::isnan(now.partitionForce)
                                   ? now.partitionForce
                                   : std::max(profile_.partitionForceMax, now.partitionForce);
  followRest(now);
  profile_.deepest = std::max(profile_.deepest, now.depth);
  profile_.finalTravel = now.travel;
  profile_.finalDepth = now.depth;
  profile_.finalAngle = now.angularDepth;
  profile_.deepestAngle = std::max(profile_.deepestAngle, now.angularDepth);
  // The tick of the arrival is no longer Inserting, but its motion still is of the hand.
  const bool isMoving = now.workflow == haptics::Workflow::inserting;
  if (isMoving || (!isFirst && before_->workflow == haptics::Workflow::inserting))
    profile_.duration = now.time;

  if (!isFirst)
    for (std::size_t i = 0; i < 3; ++i)
      profile_.work -=
          0.5 * (now.force_W[i] + before_->force_W[i]) * (now.proxy_W[i] - before_->proxy_W[i]);

  // A point per step where the tip first passes it.
  const double step = profileStep().si();
  const double slack = 1e-6 * step;
  if (isFirst && profile_.curve.empty())
    nextPoint_ = static_cast<long>(std::ceil((now.travel - slack) / step));
  while (static_cast<double>(nextPoint_) * step <= now.travel + slack) {
    const double travel = static_cast<double>(nextPoint_) * step;
    double force = now.axialForce;
    if (!isFirst && now.travel > before_->travel) {
      const double fraction =
          std::clamp((travel - before_->travel) / (now.travel - before_->travel), 0.0, 1.0);
      force = before_->axialForce + fraction * (now.axialForce - before_->axialForce);
    }
    profile_.curve.push_back({travel, force});
    ++nextPoint_;
  }
}

ForceProfile ForceProfiler::profile() const
{
  ForceProfile result = profile_;
  if (isDeepest_) result.endForce = stop_.value();
  const BasalTurn turn = findBasalTurn(result.curve);
  result.basalTurnPeak = turn.peak;
  result.basalTurnDip = turn.dip;
  return result;
}

BasalTurn findBasalTurn(const std::vector<CurvePoint>& curve, const BasalTurnWindow& window)
{
  const std::vector<CurvePoint> smooth = smoothed(curve);
  BasalTurn turn;
  turn.peak = strongest(smooth, Extremum::maximum, window.peakLow.si(), window.peakHigh.si());
  if (turn.peak)
    turn.dip = strongest(smooth, Extremum::minimum, turn.peak->travel, window.dipHigh.si());
  return turn;
}

}  // namespace perilymph::analysis

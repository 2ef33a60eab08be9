// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/FullInsertion.h"

#include <algorithm>
#include <cmath>

#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/session/Insertion.h"

namespace perilymph::analysis {

namespace {

/// Adds the force at each multiple of the spacing that the tip passes for the first time.
class ProfilePoints {
public:
  explicit ProfilePoints(Length spacing) : spacing_(spacing.si()) {}

  void add(std::vector<DepthForce>& profile, double depth, double force)
  {
    if (!(spacing_ > 0.0)) return;
    if (hasBegun_ && depth > depth_) {
      for (; static_cast<double>(next_) * spacing_ <= depth; ++next_) {
        const double place = static_cast<double>(next_) * spacing_;
        const double fraction = (place - depth_) / (depth - depth_);
        profile.push_back({meters(place), newtons(force_ + fraction * (force - force_))});
      }
    }
    if (!hasBegun_) next_ = static_cast<long>(std::ceil(std::max(depth, 0.0) / spacing_));
    if (hasBegun_ && depth < depth_) return;  // the force at the first passage counts
    hasBegun_ = true;
    depth_ = depth;
    force_ = force;
  }

private:
  double spacing_;
  bool hasBegun_ = false;
  long next_ = 0;
  double depth_ = 0.0, force_ = 0.0;
};

}  // namespace

FullInsertion insertFully(const session::InsertionParameters& given,
                          std::shared_ptr<const anatomy::ScalaTympani> anatomy,
                          Length profileSpacing, const std::atomic<bool>& isAsked)
{
  session::InsertionParameters parameters = given;
  parameters.withdraws = false;
  FullInsertion result;
  auto insertion = session::Insertion::prepare(
      parameters,
      std::make_unique<device::ScriptedDevice>(parameters.speed.si(), parameters.timeStep.si()),
      anatomy);
  if (!insertion) {
    result.reason = insertion.error().message;
    return result;
  }

  haptics::TickOutput last;
  ProfilePoints points(profileSpacing);
  const auto each = [&](const haptics::TickRecord& record) {
    const haptics::TickOutput& now = last = record.output;
    ++result.ticks;
    if ((now.status & haptics::notConverged) != 0) ++result.ticksNotConverged;
    const bool isMoving =
        now.workflow == haptics::Workflow::inserting || now.workflow == haptics::Workflow::finished;
    if (!isMoving) return !isAsked;
    if (now.axialForce > result.peak.force.si())
      result.peak = {meters(now.depth), newtons(now.axialForce)};
    result.maxMembraneForce = newtons(std::max(result.maxMembraneForce.si(), now.membraneForce));
    result.maxDepth = meters(std::max(result.maxDepth.si(), now.depth));
    points.add(result.profile, now.depth, now.axialForce);
    return !isAsked;
  };
  const auto ran =
      (*insertion)->runToEnd(each, session::maxTicks(parameters, (*insertion)->model()));
  if (isAsked) return result;
  result.end = ran ? endOf(last) : InsertionEnd::fault;
  if (!ran) result.reason = ran.error().message;
  result.depth = meters(last.depth);
  result.endForce = newtons(last.axialForce);
  (*insertion)->refresh();
  result.contacts = contactPositions(*anatomy, parameters.array, (*insertion)->latest());
  if (!result.contacts.empty()) result.apical = result.contacts.front().angle;
  result.coverage = cochlearCoverage(result.contacts);
  return result;
}

}  // namespace perilymph::analysis

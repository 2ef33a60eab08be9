// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/FullInsertion.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/session/Insertion.h"

namespace perilymph::analysis {

namespace {

/// Depth from which a tip counts as inside (choice, high).
constexpr Length enteredDepth = millimeters(0.1);
/// Travel of the tweezers beyond the stop without arrival that counts as buckling: a bow of 5 mm on
/// the 20 mm in front of the opening (choice, high).
constexpr Length maxLag = millimeters(3);

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

const char* nameOf(InsertionEnd end) noexcept
{
  switch (end) {
    case InsertionEnd::finished:
      return "finished";
    case InsertionEnd::slippedOut:
      return "slipped out";
    case InsertionEnd::buckled:
      return "buckled";
    case InsertionEnd::fault:
      return "fault";
    case InsertionEnd::refused:
      break;
  }
  return "refused";
}

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

  const Eigen::Vector3d out_W = anatomy->entry().out_W;
  std::optional<Eigen::Vector3d> start_W;  // of the tweezers
  std::optional<InsertionEnd> end;
  bool hasEntered = false;
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
    const Eigen::Vector3d base_W(now.proxy_W[0], now.proxy_W[1], now.proxy_W[2]);
    if (!start_W) start_W = base_W;
    const double pushed = (*start_W - base_W).dot(out_W);
    hasEntered = hasEntered || now.depth > enteredDepth.si();
    if (hasEntered && now.depth <= 0.0) end = InsertionEnd::slippedOut;
    if (pushed > parameters.stopTravel.si() + maxLag.si()) end = InsertionEnd::buckled;
    return !end && !isAsked;
  };
  // Twice the time for the travel, plus a second to start.
  const double ticks =
      (2.0 * parameters.stopTravel.si() / parameters.speed.si() + 1.0) / parameters.timeStep.si();
  const auto ran = (*insertion)->runToEnd(each, static_cast<std::uint64_t>(ticks));
  if (isAsked) return result;
  const bool hasArrived = ran && last.workflow == haptics::Workflow::finished;
  result.end = !ran         ? InsertionEnd::fault
               : hasArrived ? InsertionEnd::finished
                            : end.value_or(InsertionEnd::buckled);
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

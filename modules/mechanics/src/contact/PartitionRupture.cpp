// SPDX-License-Identifier: BSD-3-Clause
#include "contact/PartitionRupture.h"

#include <algorithm>
#include <cmath>

#include "perilymph/anatomy/ScalaVestibuli.h"

namespace perilymph::mechanics {
namespace {

/// Force of each node on the partition, into contacts.onPartition: in an open part what it was found
/// to be, elsewhere the part of the wall's force that pushes the array down. False if all are 0.
bool setForces(const InsertionModel& model, const InsertionState& state,
               ContactSet& contacts) noexcept
{
  bool isAny = false;
  std::ranges::fill(contacts.onPartition, 0.0);
  for (std::size_t k = 0; k < contacts.touches; ++k) {
    const std::size_t i = contacts.touching[k];
    double& force = contacts.onPartition[i];
    if (!(state.normalForce[i] > 0.0) || state.isBeside[i] != 0 || state.track[i].inLeadIn ||
        !model.partitionRange.holds(state.track[i].angle))
      continue;
    const bool isOpen = !contacts.open.empty() && contacts.open[i].isOpen;
    force = isOpen ? contacts.open[i].onPartition
                   : std::max(-state.normalForce[i] * state.wallNormal_W[i].z(), 0.0);
    isAny = isAny || force > 0.0;
  }
  return isAny;
}

double radiusAt(const PartitionModel& partition, double angle) noexcept
{
  const Eigen::Vector3d center = partition.both->center_W(angle);
  return std::sqrt(center.x() * center.x() + center.y() * center.y());
}

/// Moves the edges of a range, within the partition. False if they stay.
bool setEdges(const PartitionModel& partition, double begin, double end,
              RupturedRange& range) noexcept
{
  const RupturedRange before = range;
  // what is torn up to the partition's end has its edge there beyond it
  const double firstRadius = radiusAt(partition, partition.range.begin);
  range.begin = std::max(begin, partition.range.begin - PartitionModel::edge / firstRadius);
  range.end = std::min(end, partition.range.end);
  range.beginRadius = radiusAt(partition, range.begin);
  range.endRadius = radiusAt(partition, range.end);
  return range.begin != before.begin || range.end != before.end;
}

/// Joins ranges that touch.
void joinRanges(PartitionState& state) noexcept
{
  for (std::size_t k = 0; k + 1 < state.count;) {
    RupturedRange& range = state.ranges[k];
    const RupturedRange& next = state.ranges[k + 1];
    if (range.end < next.begin) {
      ++k;
      continue;
    }
    range.end = next.end;
    range.endRadius = next.endRadius;
    for (std::size_t j = k + 1; j + 1 < state.count; ++j) state.ranges[j] = state.ranges[j + 1];
    --state.count;
  }
}

constexpr double beginsAt = 12.0 * pi / 180.0;  // [rad]
constexpr double beforeEnd = 5.0 * pi / 180.0;  // [rad]; Membrane.cpp

}  // namespace

PartitionRange partitionRangeOf(const anatomy::ScalaTympani& scala)
{
  return {beginsAt, scala.lastAngle().si() - beforeEnd};
}

PartitionModel::PartitionModel(const anatomy::ScalaTympani& tympani, Force breakingForce)
    : vestibuli(anatomy::vestibuliOf(tympani)),
      both(anatomy::bothScalaeOf(tympani)),
      strength(breakingForce.si()),
      range(partitionRangeOf(tympani))
{
}

void PartitionModel::prepare() const
{
  vestibuli->prepare();
  both->prepare();
}

bool openPartition(const PartitionModel& partition, double angle, double width,
                   PartitionState& state) noexcept
{
  if (!partition.range.holds(angle)) return false;
  const double radius = radiusAt(partition, angle);
  const double half = (PartitionModel::edge + 0.5 * width) / radius;
  const double growth = PartitionModel::growth / radius;
  std::size_t place = 0;
  for (; place < state.count; ++place) {
    RupturedRange& range = state.ranges[place];
    if (angle < range.begin - half) break;
    if (angle > range.end + half) continue;
    // its nearer edge moves on
    const bool isBegin = angle - range.begin < range.end - angle;
    if (!setEdges(partition, range.begin - (isBegin ? growth : 0.0),
                  range.end + (isBegin ? 0.0 : growth), range))
      return false;
    joinRanges(state);
    return true;
  }
  if (state.count == maxRuptures) return false;
  for (std::size_t k = state.count; k > place; --k) state.ranges[k] = state.ranges[k - 1];
  ++state.count;
  state.ranges[place] = {};
  setEdges(partition, angle - half, angle + half, state.ranges[place]);
  joinRanges(state);
  return true;
}

PartitionContact contactWithPartition(const InsertionModel& model, const InsertionState& state,
                                      ContactSet& contacts) noexcept
{
  PartitionContact largest;
  if (!setForces(model, state, contacts)) return largest;
  const double h = model.spacing;
  const std::size_t n = state.position_W.size();
  for (std::size_t at = 0; at < contacts.touches; ++at) {
    const std::size_t i = contacts.touching[at];
    if (!(contacts.onPartition[i] > 0.0)) continue;
    const double width = 2.0 * model.radius[i];
    const double half = 0.5 * std::max(width, h);
    const auto far = static_cast<std::size_t>(half / h + 0.5);
    const std::size_t last = std::min(i + far, n - 1);
    PartitionContact contact{0.0, 0.0, width};
    for (std::size_t k = i - std::min(far, i); k <= last; ++k) {
      const double apart = h * static_cast<double>(k > i ? k - i : i - k);
      const double weight = std::clamp((half - apart) / h + 0.5, 0.0, 1.0);
      contact.force += weight * contacts.onPartition[k];
      contact.angle += weight * contacts.onPartition[k] * state.track[k].angle;
    }
    if (contact.force > largest.force) largest = contact;
  }
  if (largest.force > 0.0) largest.angle /= largest.force;
  return largest;
}

void rupturePartition(const PartitionModel& partition, const PartitionContact& contact,
                      InsertionState& state) noexcept
{
  if (contact.force < partition.strength) return;
  const bool isFirst = !state.partition.isRuptured();
  if (openPartition(partition, contact.angle, contact.width, state.partition) && isFirst)
    state.partition.first = {state.tick, contact.angle, contact.force, state.readings.depth};
}

}  // namespace perilymph::mechanics

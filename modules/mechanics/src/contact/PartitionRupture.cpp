// SPDX-License-Identifier: BSD-3-Clause
#include "contact/PartitionRupture.h"

#include <algorithm>
#include <cmath>

#include "contact/OpenPartition.h"
#include "perilymph/anatomy/ScalaVestibuli.h"

namespace perilymph::mechanics {
namespace {

/// The contact that loads the partition most.
struct PartitionContact {
  double force = 0.0;  ///< [N]
  double angle = 0.0;  ///< Mean over the contact, weighted by force [rad].
  double width = 0.0;  ///< Width of the array there [m].
};

/// Bound of the force on the partition at each node into contacts.open, exact where it is open.
/// Returns their sum [N].
double boundForces(const InsertionState& state, ContactSet& contacts) noexcept
{
  double sum = 0.0;
  for (std::size_t i = 0; i < state.normalForce.size(); ++i) {
    OpenNode& node = contacts.open[i];
    if (!node.isOpen) {
      node.onPartition = 0.0;
      if (state.normalForce[i] > 0.0 && state.isBeside[i] == 0 && !state.track[i].inLeadIn)
        node.onPartition = std::max(-state.normalForce[i] * state.wallNormal_W[i].z(), 0.0);
    }
    sum += node.onPartition;
  }
  return sum;
}

/// The largest force within a length of the array's width. Each node's force is spread over the
/// spacing of nodes.
PartitionContact largestContact(const InsertionModel& model, const InsertionState& state,
                                const ContactSet& contacts) noexcept
{
  PartitionContact largest;
  const double h = model.spacing;
  const std::size_t n = state.position_W.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!(contacts.open[i].onPartition > 0.0)) continue;
    const double width = 2.0 * model.radius[i];
    const double half = 0.5 * std::max(width, h);
    const auto far = static_cast<std::size_t>(half / h + 0.5);
    const std::size_t last = std::min(i + far, n - 1);
    PartitionContact contact{0.0, 0.0, width};
    for (std::size_t k = i - std::min(far, i); k <= last; ++k) {
      const double apart = h * static_cast<double>(k > i ? k - i : i - k);
      const double weight = std::clamp((half - apart) / h + 0.5, 0.0, 1.0);
      contact.force += weight * contacts.open[k].onPartition;
      contact.angle += weight * contacts.open[k].onPartition * state.track[k].angle;
    }
    if (contact.force > largest.force) largest = contact;
  }
  if (largest.force > 0.0) largest.angle /= largest.force;
  return largest;
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
  range.begin = std::max(begin, partition.firstAngle);
  range.end = std::min(end, partition.lastAngle);
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

// The first sections are eased into the straight lead-in (12 degrees), and the membrane ends before
// the apex (Membrane.cpp: 5 degrees): nothing ruptures there.
constexpr double beginsAt = 12.0 * pi / 180.0;  // [rad]
constexpr double beforeEnd = 5.0 * pi / 180.0;  // [rad]

}  // namespace

PartitionModel::PartitionModel(const anatomy::ScalaTympani& tympani, Force breakingForce)
    : vestibuli(anatomy::vestibuliOf(tympani)),
      both(anatomy::bothScalaeOf(tympani)),
      strength(breakingForce.si()),
      firstAngle(beginsAt),
      lastAngle(tympani.lastAngle().si() - beforeEnd)
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
  if (!(angle > partition.firstAngle && angle < partition.lastAngle)) return false;
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

void rupturePartition(const InsertionModel& model, InsertionState& state, const RodKinematics& rod,
                      ContactSet& contacts) noexcept
{
  const double strength = model.partition->strength;
  if (state.isSettling || boundForces(state, contacts) < strength) return;
  if (largestContact(model, state, contacts).force < strength) return;
  for (std::size_t i = 0; i < state.position_W.size(); ++i) {
    OpenNode& node = contacts.open[i];
    if (!(node.onPartition > 0.0)) continue;
    model.parts.lumen->follow(state.position_W[i], state.track[i]);
    if (!node.isOpen) node.onPartition = forceOnPartition(model, state, rod, i);
  }
  const PartitionContact contact = largestContact(model, state, contacts);
  if (contact.force < strength) return;
  const bool isFirst = !state.partition.isRuptured();
  if (openPartition(*model.partition, contact.angle, contact.width, state.partition) && isFirst)
    state.partition.first = {state.tick, contact.angle, contact.force, state.readings.depth};
}

}  // namespace perilymph::mechanics

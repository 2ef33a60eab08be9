// SPDX-License-Identifier: BSD-3-Clause
#include "points/HalfSpaces.h"

#include <Eigen/Geometry>

namespace perilymph::mechanics {
namespace {

// Half a micronewton on the published wall; tolerance for planes regarded as equal.
constexpr double allowance = 1e-9;  // [m]
constexpr double singular = 1e-13;  // determinant of unit vectors: 0.3 microradians apart
constexpr int maxRounds = 16;

}  // namespace

void HalfSpaces::add(const HalfSpace& space) noexcept
{
  if (count_ < capacity) {
    items_[static_cast<std::size_t>(count_++)] = space;
    return;
  }
  HalfSpace* farthest = &items_[0];
  for (HalfSpace& item : items_)
    if (item.distance > farthest->distance) farthest = &item;
  if (space.distance < farthest->distance) *farthest = space;
}

int HalfSpaces::maxViolated(const Eigen::Vector3d& place) const noexcept
{
  int index = -1;
  double max_m = allowance;
  for (int i = 0; i < count_; ++i) {
    const double outside = at(i).bound - at(i).normal.dot(place);
    if (outside > max_m) {
      max_m = outside;
      index = i;
    }
  }
  return index;
}

/// Point nearest to the goal on all planes of the set; false if a plane would have to pull.
bool HalfSpaces::holds(const Holding& set, const Eigen::Vector3d& goal,
                       Eigen::Vector3d& place) const noexcept
{
  const HalfSpace& first = at(set.index[0]);
  const double x = first.bound - first.normal.dot(goal);
  if (set.count == 1) {
    if (x < 0.0) return false;
    place = goal + x * first.normal;
    return true;
  }
  const HalfSpace& second = at(set.index[1]);
  const double y = second.bound - second.normal.dot(goal);
  const double xy = first.normal.dot(second.normal);
  if (set.count == 2) {
    const double determinant = 1.0 - xy * xy;
    if (determinant < singular) return false;
    const double onFirst = (x - xy * y) / determinant;
    const double onSecond = (y - xy * x) / determinant;
    if (onFirst < 0.0 || onSecond < 0.0) return false;
    place = goal + onFirst * first.normal + onSecond * second.normal;
    return true;
  }
  // three planes intersect in one point; their multipliers follow from Cramer's rule
  const HalfSpace& third = at(set.index[2]);
  const double z = third.bound - third.normal.dot(goal);
  const double xz = first.normal.dot(third.normal);
  const double yz = second.normal.dot(third.normal);
  const double determinant = 1.0 - xy * xy - xz * xz - yz * yz + 2.0 * xy * xz * yz;
  if (determinant < singular) return false;
  const double onFirst =
      (x * (1.0 - yz * yz) + y * (xz * yz - xy) + z * (xy * yz - xz)) / determinant;
  const double onSecond =
      (x * (xz * yz - xy) + y * (1.0 - xz * xz) + z * (xy * xz - yz)) / determinant;
  const double onThird =
      (x * (xy * yz - xz) + y * (xy * xz - yz) + z * (1.0 - xy * xy)) / determinant;
  if (onFirst < 0.0 || onSecond < 0.0 || onThird < 0.0) return false;
  place = goal + onFirst * first.normal + onSecond * second.normal + onThird * third.normal;
  return true;
}

Allowed HalfSpaces::project(const Eigen::Vector3d& goal, Eigen::Vector3d& place) const noexcept
{
  place = goal;
  Holding now;
  for (int round = 0; round < maxRounds; ++round) {
    const int added = maxViolated(place);
    if (added < 0) return now.count > 0 ? Allowed::heldBack : Allowed::yes;

    // the added one with none, one or two of the previous: the first set with nonnegative
    // multipliers that violates none of the others is the solution for these
    Holding best;
    const auto attempt = [&](int one, int two) {
      if (best.count > 0) return;
      Holding set;
      set.index[0] = added;
      set.count = 1;
      for (const int index : {one, two})
        if (index >= 0) set.index[static_cast<std::size_t>(set.count++)] = index;
      Eigen::Vector3d there;
      if (!holds(set, goal, there)) return;
      for (int k = 0; k < now.count; ++k) {
        const HalfSpace& other = at(now.index[static_cast<std::size_t>(k)]);
        if (other.bound - other.normal.dot(there) > allowance) return;
      }
      best = set;
      place = there;
    };
    attempt(-1, -1);
    for (int k = 0; k < now.count; ++k) attempt(now.index[static_cast<std::size_t>(k)], -1);
    for (int k = 0; k < now.count; ++k)
      for (int l = k + 1; l < now.count; ++l)
        attempt(now.index[static_cast<std::size_t>(k)], now.index[static_cast<std::size_t>(l)]);
    if (best.count == 0) return Allowed::nowhere;
    now = best;
  }
  return Allowed::nowhere;
}

}  // namespace perilymph::mechanics

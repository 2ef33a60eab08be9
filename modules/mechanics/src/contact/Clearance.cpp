// SPDX-License-Identifier: BSD-3-Clause
#include "contact/Clearance.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "contact/Heights.h"
#include "lanes/Lanes.h"

namespace perilymph::mechanics {
namespace {

// A node farther outside than this cannot enter within a step (faster than any hand).
constexpr double farthestOutside = 2e-3;  // [m]
constexpr double justBehind = 1e-6;       // [m]
// Maximum angle around the modiolus of the duct right behind the opening.
constexpr double farthestTurn = 0.8;  // [rad]

void setSquaredMotions(const StepStart& start, const InsertionState& state,
                       std::vector<double>& squaredMotion) noexcept
{
  inLanes(0, state.position_W.size(), [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const Triple<T> moved = load<T>(state.position_W, i) - load<T>(start.position_W, i);
    store(dot(moved, moved), squaredMotion, i);
  });
}

void setNear(bool isNear, std::size_t i, ContactSet& contacts) noexcept
{
  contacts.wall[i].isNear = isNear;
  contacts.isNear[i] = isNear ? 1 : 0;
}

/// Contact of a node from outside with the bone beside the opening: a plane that supports its
/// center line.
void seeBone(const InsertionModel& model, const InsertionState& state, std::size_t i,
             ContactSet& contacts) noexcept
{
  const double inside = (model.entry.origin_W - state.position_W[i]).dot(model.entry.out_W);
  anatomy::WallPoint& wall = contacts.wall[i];
  setNear(inside > 0.0, i, contacts);
  wall.clearance = 0.0;
  wall.onMembrane = false;
  wall.distance = model.radius[i] - inside;
  wall.normal_W = model.entry.out_W;
  wall.shapeOperator_W.setZero();
  contacts.isKnown[i] = 0;
  contacts.seen[i].trustRadius = 0.0;
}

/// Whether the wall that was found earlier holds at a position, to which it is extrapolated: for a
/// node near the wall within its trust radius, for one that was distant in this step while it cannot
/// touch.
bool isStillSeen(const Eigen::Vector3d& at_W, ContactSet& contacts, std::size_t i) noexcept
{
  anatomy::WallPoint& wall = contacts.wall[i];
  const SeenWall& seen = contacts.seen[i];
  const Eigen::Vector3d moved = at_W - seen.from_W;
  const double squared = moved[0] * moved[0] + moved[1] * moved[1] + moved[2] * moved[2];
  if (!(seen.trustRadius > 0.0))
    return contacts.isKnown[i] != 0 && !wall.isNear && wall.clearance > 0.0 &&
           squared < wall.clearance * wall.clearance;
  if (!(squared < seen.trustRadius * seen.trustRadius)) return false;
  const Eigen::Vector3d turned = seen.hessian_W * moved;
  wall.distance = seen.distance + (seen.normal_W + 0.5 * turned).dot(moved);
  wall.normal_W = seen.normal_W + turned;
  // an earlier trial of this step may have left the node where it cannot touch
  setNear(true, i, contacts);
  wall.clearance = 0.0;
  contacts.isKnown[i] = 1;
  return true;
}

/// Keeps what a query found.
void keepSeen(const Eigen::Vector3d& at_W, const anatomy::WallPoint& wall, SeenWall& seen) noexcept
{
  seen.from_W = at_W;
  seen.trustRadius = wall.isNear ? wall.trustRadius : 0.0;
  if (!(seen.trustRadius > 0.0)) return;
  seen.distance = wall.distance;
  seen.normal_W = wall.normal_W;
  seen.hessian_W = wall.hessian_W;
}

}  // namespace

void findWall(const InsertionModel& model, const StepStart& start, InsertionState& state,
              ContactSet& contacts) noexcept
{
  const std::size_t n = state.position_W.size();
  setSquaredMotions(start, state, contacts.squaredMotion);
  for (std::size_t i = 0; i < n; ++i) {
    const double clearance = state.clearance[i];
    contacts.isRequested[i] = 0;
    if (state.isBeside[i] != 0) {
      seeBone(model, state, i, contacts);
      continue;
    }
    if (contacts.squaredMotion[i] < clearance * clearance && i + 1 < n) {
      if (contacts.isNear[i] != 0) setNear(false, i, contacts);
      contacts.isKnown[i] = 0;
      continue;
    }
    if (isStillSeen(state.position_W[i], contacts, i)) {
      // the tip's angle is a reading, and the place of a membrane depends on it
      if (i + 1 == n || model.membrane)
        model.parts.lumen->follow(state.position_W[i], state.track[i]);
      continue;
    }
    contacts.isRequested[i] = 1;
    contacts.isKnown[i] = 1;
    contacts.wall[i].isNear = false;
    contacts.wall[i].trustRadius = 0.0;
  }

  // neighboring nodes in one query
  for (std::size_t first = 0; first < n;) {
    std::size_t count = 0;
    while (first + count < n && contacts.isRequested[first + count] != 0) ++count;
    if (count > 0)
      model.parts.lumen->nearestWall(std::span(state.position_W).subspan(first, count),
                                     std::span(contacts.reach).subspan(first, count),
                                     std::span(state.track).subspan(first, count),
                                     std::span(contacts.wall).subspan(first, count));
    for (std::size_t i = first; i < first + count; ++i) {
      contacts.isNear[i] = contacts.wall[i].isNear ? 1 : 0;
      keepSeen(state.position_W[i], contacts.wall[i], contacts.seen[i]);
    }
    first += count + 1;
  }
}

void findBone(const InsertionModel& model, InsertionState& state, ContactSet& contacts) noexcept
{
  setHeights(state.position_W, model.entry.origin_W, model.entry.out_W, contacts.height);
  placeLaterTurnsBehind(state.track, contacts.height);
  for (std::size_t i = 0; i < state.position_W.size(); ++i) {
    const double height = contacts.height[i];
    const double radius = model.radius[i];
    const bool isFar = height < -radius || height > farthestOutside;
    if (isFar && state.isBeside[i] == 0) continue;
    if (height > 0.0) state.isBeside[i] = 0;
    // a node farther inside keeps the state it had when it passed the plane
    if (isFar || state.isBeside[i] != 0) continue;
    const bool isInside = height <= 0.0;
    if (isInside && !(state.normalForce[i] > 0.0)) continue;
    const Eigen::Vector3d from_W = state.position_W[i] - model.entry.origin_W;
    const double squared = from_W.squaredNorm() - height * height;
    if (squared < 4.0 * radius * radius) continue;
    // the wall at the node, or right behind the plane if the node is still outside
    const Eigen::Vector3d behind_W =
        state.position_W[i] - (std::max(height, 0.0) + justBehind) * model.entry.out_W;
    const anatomy::LumenTrack start = model.parts.lumen->startTrack();
    anatomy::LumenTrack track = isInside ? state.track[i] : start;
    anatomy::WallPoint wall;
    model.parts.lumen->nearestWall({&behind_W, 1}, {&radius, 1}, {&track, 1}, {&wall, 1});
    // the plane also intersects other turns of the duct; before the first turn there is no wall
    const double turned = track.angle - start.angle;
    const bool isElsewhere = turned < -farthestTurn || (!isInside && turned > farthestTurn);
    if (isElsewhere || (wall.isNear && wall.distance < -radius)) state.isBeside[i] = 1;
  }
}

void keepClearance(const ContactSet& contacts, InsertionState& state) noexcept
{
  for (std::size_t i = 0; i < state.clearance.size(); ++i) {
    double& left = state.clearance[i];
    if (state.isBeside[i] != 0) {
      left = 0.0;
      continue;
    }
    if (contacts.isKnown[i] == 0) {
      left -= std::sqrt(contacts.squaredMotion[i]);
      continue;
    }
    if (contacts.isNear[i] != 0) {
      left = 0.0;
      continue;
    }
    const double since = (state.position_W[i] - contacts.seen[i].from_W).norm();
    left = std::max(contacts.wall[i].clearance - since, 0.0);
  }
}

}  // namespace perilymph::mechanics

// SPDX-License-Identifier: BSD-3-Clause
#include "contact/Clearance.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "contact/Heights.h"
#include "lanes/Flags.h"
#include "lanes/Lanes.h"

namespace perilymph::mechanics {
namespace {

// A node farther outside than this cannot enter within a step (faster than any hand).
constexpr double farthestOutside = 2e-3;  // [m]
constexpr double justBehind = 1e-6;       // [m]
// Maximum angle around the modiolus of the duct right behind the opening.
constexpr double farthestTurn = 0.8;  // [rad]

/// Contact of a node from outside with the bone beside the opening: a plane that supports its
/// center line.
void seeBone(const InsertionModel& model, const InsertionState& state, std::size_t i,
             ContactSet& contacts) noexcept
{
  const double inside = (model.entry.origin_W - state.position_W[i]).dot(model.entry.out_W);
  contacts.isNear[i] = inside > 0.0 ? yes : no;
  contacts.isKnown[i] = no;
  contacts.distance[i] = model.radius[i] - inside;
  contacts.normal_W.set(i, model.entry.out_W);
  contacts.seen.trustRadius[i] = 0.0;
  anatomy::WallPoint& wall = contacts.wall[i];
  wall.clearance = 0.0;
  wall.onMembrane = false;
  wall.shapeOperator_W.setZero();
}

/// The motion of a node, or of four, since its wall was found, and what the distance has become: to second
/// order, in the order in which Eigen multiplies a matrix with a vector.
template <class T>
struct FollowedWall {
  T squared;  ///< Square of that motion [m^2].
  T distance;
  Triple<T> normal_W;

  PERILYMPH_IN_LANES FollowedWall(const SeenWalls& seen, const Triple<T>& at_W,
                                  std::size_t i) noexcept
  {
    const Triple<T> moved = at_W - load<T>(seen.from_W, i);
    squared = dot(moved, moved);
    const Triple<T> last = load<T>(seen.hessian_W[2], i);
    const Triple<T> turned{dot(load<T>(seen.hessian_W[0], i), moved),
                           dot(load<T>(seen.hessian_W[1], i), moved),
                           last.x * moved.x + (last.y * moved.y + last.z * moved.z)};
    const Triple<T> normal = load<T>(seen.normal_W, i);
    distance = load<T>(seen.distance, i) + dot(normal + (T{} + 0.5) * turned, moved);
    normal_W = normal + turned;
  }
};

/// Finds what needs no query, of every node but the tip: those that are farther from the wall than they
/// moved in this step, and those near it within the trust radius of what was seen, to which the wall is
/// extrapolated.
void followWalls(const StepStart& start, const InsertionState& state, ContactSet& contacts) noexcept
{
  inLanes(0, state.position_W.size() - 1, [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const Triple<T> at_W = load<T>(state.position_W, i);
    const Triple<T> moved = at_W - load<T>(start.position_W, i);
    const T squaredMotion = dot(moved, moved);
    store(squaredMotion, contacts.squaredMotion, i);
    const T clearance = load<T>(state.clearance, i);
    const T trust = load<T>(contacts.seen.trustRadius, i);
    const auto isAway = squaredMotion < clearance * clearance;
    const auto isFree = load<T>(contacts.isBeside, i) == no;
    if (inAll(isAway & isFree)) {
      store(T(T{} + yes), contacts.isFollowed, i);
      store(T{}, contacts.isNear, i);
      store(T{}, contacts.isKnown, i);
      return;
    }
    const FollowedWall<T> wall(contacts.seen, at_W, i);
    const auto isSeen = (trust > 0.0) & (wall.squared < trust * trust);
    store(oneOf(isSeen, wall.distance, load<T>(contacts.distance, i)), contacts.distance, i);
    store(oneOf(isSeen, wall.normal_W, load<T>(contacts.normal_W, i)), contacts.normal_W, i);
    const auto isFollowed = isFree & (isAway | isSeen);
    const T isNear = flagsOf<T>(isSeen & (isAway == 0));
    store(flagsOf<T>(isFollowed), contacts.isFollowed, i);
    store(oneOf(isFollowed, isNear, load<T>(contacts.isNear, i)), contacts.isNear, i);
    store(oneOf(isFollowed, isNear, load<T>(contacts.isKnown, i)), contacts.isKnown, i);
  });
}

/// Whether no query is needed at a node that followWalls() left: at the tip as at the others; elsewhere
/// one that was found distant in this step cannot touch yet.
bool isStillSeen(const InsertionState& state, std::size_t i, ContactSet& contacts) noexcept
{
  const SeenWalls& seen = contacts.seen;
  const Eigen::Vector3d& at_W = state.position_W[i];
  const Triple<double> at{at_W[0], at_W[1], at_W[2]};
  const FollowedWall<double> wall(seen, at, i);
  const double trust = seen.trustRadius[i], clearance = contacts.wall[i].clearance;
  if (!(trust > 0.0))
    return contacts.isKnown[i] == yes && contacts.isNear[i] == no && clearance > 0.0 &&
           wall.squared < clearance * clearance;
  if (!(wall.squared < trust * trust)) return false;
  contacts.distance[i] = wall.distance;
  contacts.normal_W.set(i, {wall.normal_W.x, wall.normal_W.y, wall.normal_W.z});
  contacts.isNear[i] = contacts.isKnown[i] = yes;
  return true;
}

/// Keeps what a query found.
void keepSeen(const Eigen::Vector3d& at_W, std::size_t i, ContactSet& contacts) noexcept
{
  const anatomy::WallPoint& wall = contacts.wall[i];
  SeenWalls& seen = contacts.seen;
  contacts.isNear[i] = wall.isNear ? yes : no;
  seen.from_W.set(i, at_W);
  seen.trustRadius[i] = wall.isNear ? wall.trustRadius : 0.0;
  if (!wall.isNear) return;
  contacts.distance[i] = wall.distance;
  contacts.normal_W.set(i, wall.normal_W);
  if (!(seen.trustRadius[i] > 0.0)) return;
  seen.distance[i] = wall.distance;
  seen.normal_W.set(i, wall.normal_W);
  for (int row = 0; row < 3; ++row)
    seen.hessian_W[static_cast<std::size_t>(row)].set(i, wall.hessian_W.row(row));
}

/// Finds the nodes of which findBone() looks at the place: near the plane of the opening, or beside it.
void setNearPlane(const InsertionModel& model, ContactSet& contacts) noexcept
{
  inLanes(0, contacts.height.size(), [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const T height = load<T>(contacts.height, i);
    const auto isNear = (height >= -load<T>(model.radius, i)) & (height <= farthestOutside);
    store(flagsOf<T>(isNear | (load<T>(contacts.isBeside, i) == yes)), contacts.isNearPlane, i);
  });
}

}  // namespace

void findWall(const InsertionModel& model, const StepStart& start, InsertionState& state,
              ContactSet& contacts) noexcept
{
  const std::size_t tip = state.position_W.size() - 1;
  followWalls(start, state, contacts);
  // the tip's angle is a reading, and the place of a membrane depends on it
  const auto follow = [&](std::size_t i) {
    model.parts.lumen->follow(state.position_W[i], state.track[i]);
  };
  contacts.squaredMotion[tip] = (state.position_W[tip] - start.position_W[tip]).squaredNorm();
  contacts.isFollowed[tip] = no;
  if (model.membrane)
    forEachNode(contacts.isNear, yes, [&](std::size_t i) {
      if (contacts.isFollowed[i] == yes) follow(i);
    });
  // neighboring nodes in one query
  std::size_t first = 0, end = 0;
  const auto query = [&] {
    if (first == end) return;
    const std::size_t count = end - first;
    model.parts.lumen->nearestWall(std::span(state.position_W).subspan(first, count),
                                   std::span(contacts.reach).subspan(first, count),
                                   std::span(state.track).subspan(first, count),
                                   std::span(contacts.wall).subspan(first, count));
    for (std::size_t i = first; i < end; ++i) keepSeen(state.position_W[i], i, contacts);
  };
  forEachNode(contacts.isFollowed, no, [&](std::size_t i) {
    if (state.isBeside[i] != 0) {
      seeBone(model, state, i, contacts);
      return;
    }
    if (isStillSeen(state, i, contacts)) {
      if (i == tip || model.membrane) follow(i);
      return;
    }
    contacts.isKnown[i] = yes;
    contacts.wall[i].isNear = false;
    contacts.wall[i].trustRadius = 0.0;
    if (i != end) {
      query();
      first = i;
    }
    end = i + 1;
  });
  query();
}

void findBone(const InsertionModel& model, InsertionState& state, ContactSet& contacts) noexcept
{
  setHeights(state.position_W, model.entry.origin_W, model.entry.out_W, contacts.height);
  placeLaterTurnsBehind(state.track, contacts.height);
  std::ranges::copy(state.isBeside, contacts.isBeside.begin());
  setNearPlane(model, contacts);
  forEachNode(contacts.isNearPlane, yes, [&](std::size_t i) {
    const double height = contacts.height[i];
    const double radius = model.radius[i];
    const bool isFar = height < -radius || height > farthestOutside;
    if (isFar && state.isBeside[i] == 0) return;
    if (height > 0.0) contacts.isBeside[i] = state.isBeside[i] = 0;
    // a node farther inside keeps the state it had when it passed the plane
    if (isFar || state.isBeside[i] != 0) return;
    const bool isInside = height <= 0.0;
    if (isInside && !(state.normalForce[i] > 0.0)) return;
    const Eigen::Vector3d from_W = state.position_W[i] - model.entry.origin_W;
    const double squared = from_W.squaredNorm() - height * height;
    if (squared < 4.0 * radius * radius) return;
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
    if (isElsewhere || (wall.isNear && wall.distance < -radius))
      contacts.isBeside[i] = state.isBeside[i] = 1;
  });
}

void keepClearance(ContactSet& contacts, InsertionState& state) noexcept
{
  inLanesInPlace(0, state.clearance.size(), [&](auto lane, std::size_t i) PERILYMPH_KERNEL {
    using T = decltype(lane);
    const auto isFree = load<T>(contacts.isBeside, i) == no;
    const auto isKnown = load<T>(contacts.isKnown, i) == yes;
    const auto isNear = load<T>(contacts.isNear, i) == yes;
    const T left = load<T>(state.clearance, i) - root(load<T>(contacts.squaredMotion, i));
    store(oneOf(isFree, oneOf(isKnown, T{}, left), T{}), state.clearance, i);
    store(oneOf(isFree, oneOf(isKnown, oneOf(isNear, T{}, T(T{} + yes)), T{}), T{}),
          contacts.isDistant, i);
  });
  forEachNode(contacts.isDistant, yes, [&](std::size_t i) {
    const double since = (state.position_W[i] - contacts.seen.from_W[i]).norm();
    state.clearance[i] = std::max(contacts.wall[i].clearance - since, 0.0);
  });
}

}  // namespace perilymph::mechanics

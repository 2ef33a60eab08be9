// SPDX-License-Identifier: BSD-3-Clause
#include "contact/OpenPartition.h"

#include <algorithm>
#include <cmath>

#include "contact/Contact.h"

namespace perilymph::mechanics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Distance at which a wall is found from everywhere in the scalae.
constexpr double everywhere = 10e-3;  // [m]
// Nodes this far beyond an open part are looked at, too: a hand moves them by less in a step.
constexpr double margin = 0.5e-3;  // [m]

/// The wall of one lumen on a node.
struct WallContact {
  double energy = 0.0;                  ///< [J]
  double force = 0.0;                   ///< [N]
  double slope = 0.0;                   ///< [N/m]
  double onMembrane = 0.0;              ///< Part of the force [N].
  Vector3d force_W = Vector3d::Zero();  ///< On the node: minus the gradient of the energy [N].
};

anatomy::WallPoint wallIn(const anatomy::ScalaTympani& duct, const Vector3d& at_W, double reach,
                          anatomy::LumenTrack track) noexcept
{
  anatomy::WallPoint wall;
  duct.nearestWall({&at_W, 1}, {&reach, 1}, {&track, 1}, {&wall, 1});
  return wall;
}

/// The wall of bone at a penetration.
WallContact onBone(const InsertionModel& model, std::size_t i, const anatomy::WallPoint& wall,
                   double half) noexcept
{
  WallContact contact;
  const double penetration = half - wall.distance;
  if (!wall.isNear || penetration <= 0.0) return contact;
  const double onset = model.parts.wall.lining.si();
  const NormalForce push = normalForce(penetration, model.wallStiffness[i], onset);
  contact.energy = energyOf(penetration, model.wallStiffness[i], onset);
  contact.force = push.force;
  contact.slope = push.slope;
  contact.force_W = push.force * wall.normal_W;
  return contact;
}

/// The wall of one scala, partly membrane. The membrane is as soft from above as from below.
WallContact onOwnSide(const InsertionModel& model, const InsertionState& state, std::size_t i,
                      const anatomy::WallPoint& wall, double half) noexcept
{
  WallContact contact = onBone(model, i, wall, half);
  if (!(contact.force > 0.0)) return contact;
  const bool isAbove = state.partition.isAbove[i] != 0;
  if (!model.membrane) {
    contact.onMembrane = !isAbove && wall.onMembrane ? contact.force : 0.0;
    return contact;
  }
  Vector3d upward_W = wall.normal_W;
  if (isAbove) upward_W[2] = -upward_W[2];
  const MembraneFraction membrane =
      model.membrane->fractionAt(state.position_W[i], model.radius[i], state.track[i], upward_W);
  const SoftContactForce soft = softContactForce(half - wall.distance, model.wallStiffness[i],
                                                 membrane.fraction, model.parts);
  contact.energy += membrane.fraction * soft.byFraction;
  contact.force = soft.normal.force;
  contact.slope = soft.normal.slope;
  contact.onMembrane = soft.onMembrane;
  contact.force_W = soft.normal.force * wall.normal_W - soft.byFraction * membrane.gradient_W;
  return contact;
}

/// Reach of a node toward a wall, found once per step.
double reachOf(const InsertionModel& model, const InsertionState& state, const RodKinematics& rod,
               std::size_t i, const anatomy::WallPoint& wall, const SectionReach& before,
               SectionReach& reach) noexcept
{
  if (!model.isOval) return model.radius[i];
  if (!wall.isNear) return model.radius[i];
  if (!reach.isKnown) reach = reachToward(model, state, rod, i, wall.normal_W, before);
  return reach.length;
}

/// Adds the positive semidefinite part of [a b; b c] in the directions n and t.
void addPositive(double a, double b, double c, const Vector3d& n, const Vector3d& t,
                 SymmetricBlock<double>& block) noexcept
{
  const double middle = 0.5 * (a + c);
  const double spread = std::sqrt(0.25 * (a - c) * (a - c) + b * b);
  const double low = middle - spread, high = middle + spread;
  if (high <= 0.0) return;
  if (low < 0.0) {
    const double scale = high / (high - low);
    a = scale * (a - low);
    b = scale * b;
    c = scale * (c - low);
  }
  const Matrix3d m =
      a * n * n.transpose() + b * (n * t.transpose() + t * n.transpose()) + c * t * t.transpose();
  block += SymmetricBlock<double>{m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
}

/// Adds stiffness along the normal, and its rotation on a concave wall.
void addTurning(double force, const anatomy::WallPoint& wall,
                SymmetricBlock<double>& block) noexcept
{
  const Matrix3d& k = wall.shapeOperator_W;
  block += SymmetricBlock<double>{force * k(0, 0), force * k(0, 1), force * k(0, 2),
                                  force * k(1, 1), force * k(1, 2), force * k(2, 2)};
}

}  // namespace

IntactFraction PartitionState::at(double angle) const noexcept
{
  for (std::size_t k = 0; k < count; ++k) {
    const RupturedRange& range = ranges[k];
    if (!(angle > range.begin && angle < range.end)) continue;
    const auto ramp = [](double from, double perEdge) {
      const double x = std::min(from * perEdge, 1.0);
      return IntactFraction{x * x * (3.0 - 2.0 * x), 6.0 * x * (1.0 - x) * perEdge,
                            x < 1.0 ? (6.0 - 12.0 * x) * perEdge * perEdge : 0.0};
    };
    const IntactFraction a = ramp(angle - range.begin, range.beginRadius / PartitionModel::edge);
    const IntactFraction b = ramp(range.end - angle, range.endRadius / PartitionModel::edge);
    return {1.0 - a.value * b.value, a.value * b.slope - a.slope * b.value,
            -a.bend * b.value + 2.0 * a.slope * b.slope - a.value * b.bend};
  }
  return {};
}

double PartitionState::lengthAbove(double spacing) const noexcept
{
  double length = 0.0;
  for (std::size_t i = 0; i < isAbove.size(); ++i)
    if (isAbove[i] != 0) length += i + 1 == isAbove.size() ? 0.5 * spacing : spacing;
  return length;
}

void findSides(const InsertionModel& model, InsertionState& state, ContactSet& contacts) noexcept
{
  PartitionState& partition = state.partition;
  for (std::size_t i = 0; i < state.position_W.size(); ++i) {
    OpenNode& node = contacts.open[i];
    node = OpenNode{};
    if (state.isBeside[i] != 0) continue;
    const Vector3d& at_W = state.position_W[i];
    model.parts.lumen->follow(at_W, state.track[i]);
    const double angle = state.track[i].angle;
    node.isOpen = partition.isAbove[i] != 0;
    for (std::size_t k = 0; k < partition.count; ++k) {
      const RupturedRange& range = partition.ranges[k];
      if (angle > range.begin - margin / range.beginRadius &&
          angle < range.end + margin / range.endRadius)
        node.isOpen = true;
    }
    if (!node.isOpen || !(partition.at(angle).value < 1.0)) continue;
    const auto& tympani = static_cast<const anatomy::ScalaTympani&>(*model.parts.lumen);
    const double below = wallIn(tympani, at_W, everywhere, state.track[i]).distance;
    const double above =
        wallIn(*model.partition->vestibuli, at_W, everywhere, state.track[i]).distance;
    if (below != above) partition.isAbove[i] = above > below ? 1 : 0;
  }
}

bool openContact(const InsertionModel& model, InsertionState& state, const RodKinematics& rod,
                 std::size_t i, ContactSet& contacts) noexcept
{
  OpenNode& node = contacts.open[i];
  const Vector3d& at_W = state.position_W[i];
  model.parts.lumen->follow(at_W, state.track[i]);
  const anatomy::LumenTrack& track = state.track[i];
  const IntactFraction whole = state.partition.at(track.angle);

  anatomy::WallPoint own = wallAt(contacts, i);
  WallContact side, both;
  double ownReach = model.radius[i];
  if (whole.value > 0.0) {
    if (state.partition.isAbove[i] != 0)
      own = wallIn(*model.partition->vestibuli, at_W, model.radius[i], track);
    ownReach = reachOf(model, state, rod, i, own, state.section[i], contacts.section[i]);
    side = onOwnSide(model, state, i, own, ownReach);
  }
  anatomy::WallPoint around;
  if (whole.value < 1.0) {
    around = wallIn(*model.partition->both, at_W, model.radius[i], track);
    both = onBone(model, i, around, reachOf(model, state, rod, i, around, {}, node.both));
  }
  node.onPartition = 0.0;
  if (!(side.force > 0.0) && !(both.force > 0.0)) return false;

  // E = w E_side + (1 - w) E_both
  const double open = 1.0 - whole.value;
  const double stored = side.energy - both.energy;
  const double r = std::max(at_W.x() * track.direction[0] + at_W.y() * track.direction[1], 1e-4);
  const Vector3d forward_W(-track.direction[1], track.direction[0], 0.0);
  const double perLength = 1.0 / r;
  const double edge = stored * whole.slope * perLength;
  const Vector3d force_W = whole.value * side.force_W + open * both.force_W - edge * forward_W;
  const double normal = whole.value * (side.force_W.z() - both.force_W.z());
  node.onPartition = std::sqrt(normal * normal + edge * edge);
  state.wallForce_W[i] += force_W;
  state.membraneForce[i] = whole.value * side.onMembrane;
  state.normalForce[i] = force_W.norm();
  state.wallNormal_W[i] =
      state.normalForce[i] > 1e-9 ? Vector3d(force_W / state.normalForce[i]) : Vector3d::Zero();
  if (model.isOval) {
    const double excess = std::fabs(model.halfWithin[i] - model.halfAcross[i]);
    const double a = contacts.section[i].isKnown ? contacts.section[i].rate : 0.0;
    const double b = node.both.isKnown ? node.both.rate : 0.0;
    state.wallTorque[i] = {-whole.value * side.force * a - open * both.force * b,
                           whole.value * (side.slope * a * a + side.force * excess) +
                               open * (both.slope * b * b + both.force * excess)};
  }

  SymmetricBlock<double>& block = node.stiffness;
  block = {};
  if (side.force > 0.0) {
    const double steep = std::max(own.normal_W.norm(), 1e-6);
    const Vector3d n = own.normal_W / steep;
    const Vector3d along = forward_W - forward_W.dot(n) * n;
    const double size = std::max(along.norm(), 1e-6);
    const double perEdge = size * perLength;
    addPositive(whole.value * side.slope * steep * steep,
                -side.force * steep * whole.slope * perEdge,
                std::fabs(stored * whole.bend) * perEdge * perEdge, n, along / size, block);
    addTurning(whole.value * side.force, own, block);
  }
  if (both.force > 0.0) {
    addPositive(open * both.slope, 0.0, 0.0, around.normal_W, forward_W, block);
    addTurning(open * both.force, around, block);
  }
  return true;
}

}  // namespace perilymph::mechanics

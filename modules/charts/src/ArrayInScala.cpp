// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/charts/ArrayInScala.h"

#include <algorithm>
#include <cmath>

#include "perilymph/foundation/Units.h"

namespace perilymph::charts {
namespace {

constexpr double perMilli = 1e3;

Eigen::Vector3d nodeOf(const haptics::Snapshot& now, std::size_t i)
{
  return {now.node_W[i][0], now.node_W[i][1], now.node_W[i][2]};
}

}  // namespace

ArrayInScala::ArrayInScala(const anatomy::ScalaTympani& scala, const electrode::ArrayDesign& array)
    : scala_(scala), array_(array)
{
  nodes_.reserve(mechanics::maxNodes);
  nodes_W_.reserve(mechanics::maxNodes);
}

NodePlace ArrayInScala::place(const Eigen::Vector3d& node_W, anatomy::LumenTrack& track,
                              Eigen::Vector3d& across_W, Eigen::Vector3d& duct_W) const
{
  const anatomy::Entry entry = scala_.entry();
  constexpr double reach = 0.0;  // the angle is needed, not the wall
  anatomy::WallPoint wall;
  scala_.nearestWall({&node_W, 1}, {&reach, 1}, {&track, 1}, {&wall, 1});

  NodePlace found;
  found.isInside = anatomy::behindOpening(entry, node_W, track) > 0.0;
  if (track.inLeadIn) {
    // the first section moves along the straight axis
    const Eigen::Vector3d first_W = scala_.center_W(0.0);
    const Eigen::Vector3d perForward = entry.out_W / entry.out_W.y();
    const Eigen::Vector3d off_W = node_W - node_W.y() * perForward - first_W;
    found.angle_deg = inDegrees(radians(node_W.y() * perForward.norm() / first_W.x()));
    found.across_mm = perMilli * off_W.x();
    found.up_mm = perMilli * off_W.z();
    across_W = Eigen::Vector3d::UnitX();
    duct_W = Eigen::Vector3d::UnitY();
    return found;
  }
  const Eigen::Vector3d center_W = scala_.center_W(track.angle);
  found.angle_deg = inDegrees(radians(track.angle));
  across_W = {track.direction[0], track.direction[1], 0.0};
  duct_W = {-track.direction[1], track.direction[0], 0.0};
  found.across_mm = perMilli * (node_W.head<2>().norm() - center_W.head<2>().norm());
  found.up_mm = perMilli * (node_W.z() - center_W.z());
  return found;
}

void ArrayInScala::follow(const haptics::Snapshot& now)
{
  nodes_.clear();
  nodes_W_.clear();
  torn_deg_.clear();
  const std::size_t count = std::min<std::size_t>(now.nodes, mechanics::maxNodes);
  if (count < 2) return;
  for (std::size_t i = 0; i < count; ++i)
    if (!nodeOf(now, i).allFinite()) return;

  for (std::size_t k = 0; k < std::min<std::size_t>(now.ruptures, now.ruptured.size()); ++k)
    torn_deg_.push_back(
        {inDegrees(radians(now.ruptured[k][0])), inDegrees(radians(now.ruptured[k][1]))});
  anatomy::LumenTrack track = scala_.startTrack();
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d node_W = nodeOf(now, i);
    Eigen::Vector3d across_W, duct_W;
    NodePlace found = place(node_W, track, across_W, duct_W);
    found.isAbove = now.isAbove[i];
    found.fromTip_mm = inMillimeters(array_.length) * (1.0 - double(i) / double(count - 1));

    const std::size_t before = i == 0 ? 0 : i - 1;
    const std::size_t after = std::min(count - 1, i + 1);
    const Eigen::Vector3d along_W = (nodeOf(now, after) - nodeOf(now, before)).normalized();
    found.along = {along_W.dot(across_W), along_W.z(), along_W.dot(duct_W)};

    const Eigen::Vector3d force_W(now.wallForce_W[i][0], now.wallForce_W[i][1],
                                  now.wallForce_W[i][2]);
    const double normal = static_cast<double>(now.normalForce[i]);
    if (force_W.allFinite() && std::isfinite(normal) && normal > 0.0) {
      // a tip may hit the wall head on: there the whole force counts
      const Eigen::Vector3d push_W =
          i + 1 < count ? Eigen::Vector3d(force_W - force_W.dot(along_W) * along_W) : force_W;
      found.normal_mN = perMilli * normal;
      found.pushAcross_mN = perMilli * push_W.dot(across_W);
      found.pushUp_mN = perMilli * push_W.z();
    }
    nodes_.push_back(found);
    nodes_W_.push_back(node_W);
  }
}

NodePlace ArrayInScala::at(double fromTip_mm) const
{
  const double length_mm = inMillimeters(array_.length);
  const double last = static_cast<double>(nodes_.size() - 1);
  const double index = std::clamp(last * (1.0 - fromTip_mm / length_mm), 0.0, last);
  const std::size_t i = std::min(nodes_.size() - 2, static_cast<std::size_t>(index));
  const double fraction = index - static_cast<double>(i);
  const NodePlace& a = nodes_[i];
  const NodePlace& b = nodes_[i + 1];
  NodePlace between = fraction < 0.5 ? a : b;
  const auto mixed = [fraction](double from, double to) { return from + fraction * (to - from); };
  between.fromTip_mm = mixed(a.fromTip_mm, b.fromTip_mm);
  between.angle_deg = mixed(a.angle_deg, b.angle_deg);
  between.across_mm = mixed(a.across_mm, b.across_mm);
  between.up_mm = mixed(a.up_mm, b.up_mm);
  between.along = (a.along + fraction * (b.along - a.along)).normalized();
  return between;
}

}  // namespace perilymph::charts

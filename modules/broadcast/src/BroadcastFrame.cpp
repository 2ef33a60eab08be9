// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/broadcast/BroadcastFrame.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace perilymph::broadcast {

namespace {

Eigen::Vector3d node(const haptics::Snapshot& now, std::uint32_t i)
{
  const auto& place = now.node_W[i];
  return Eigen::Vector3d(place[0], place[1], place[2]);
}

std::array<double, 3> numbers(const Eigen::Vector3d& vector)
{
  return {vector.x(), vector.y(), vector.z()};
}

/// A pose whose z axis is given; rotation about it is chosen as the smallest from W's axes.
Pose pose(const std::array<double, 3>& place_W, const Eigen::Vector3d& axis_W)
{
  Pose result;
  result.place_W = place_W;
  if (!(axis_W.norm() > 0.0)) return result;
  const Eigen::Matrix3d turned =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis_W).toRotationMatrix();
  for (int i = 0; i < 3; ++i) result.axis_W[static_cast<std::size_t>(i)] = numbers(turned.col(i));
  return result;
}

bool hasFiniteNodes(const haptics::Snapshot& now)
{
  return std::all_of(now.node_W.begin(), now.node_W.begin() + now.nodes, [](const auto& place) {
    return std::all_of(place.begin(), place.end(), [](float x) { return std::isfinite(x); });
  });
}

/// Nodes, and the section at each of them: they divide the array's length evenly.
void copyShape(const haptics::Snapshot& now, const electrode::ArrayDesign& array,
               BroadcastFrame& frame)
{
  frame.nodes = now.nodes;
  std::copy_n(now.node_W.begin(), now.nodes, frame.node_W.begin());
  if (array.diameter.fromTip.empty()) return;
  const double last = now.nodes - 1;
  for (std::uint32_t i = 0; i < now.nodes; ++i) {
    const auto section = array.sectionAt((1.0 - i / last) * array.length);
    frame.halfWidth[i] = {static_cast<float>(0.5 * section.within.si()),
                          static_cast<float>(0.5 * section.across.si())};
  }
}

}  // namespace

Eigen::Vector3d directionIn(const Placement& placement, const Eigen::Vector3d& vector_W)
{
  Eigen::Vector3d vector_R = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& axis = placement.axis_R[i];
    vector_R += vector_W[static_cast<Eigen::Index>(i)] * Eigen::Vector3d(axis[0], axis[1], axis[2]);
  }
  return vector_R;
}

Eigen::Vector3d pointIn(const Placement& placement, const Eigen::Vector3d& point_W)
{
  const auto& origin = placement.origin_R;
  return Eigen::Vector3d(origin[0], origin[1], origin[2]) + directionIn(placement, point_W);
}

BroadcastFrame broadcastFrame(const haptics::Snapshot& now, const electrode::ArrayDesign& array)
{
  BroadcastFrame frame;
  frame.tick = now.tick;
  frame.force_W = now.output.force_W;
  frame.axialForce = now.output.axialForce;
  frame.time = now.output.time;
  frame.travel = now.output.travel;
  frame.depth = now.output.depth;
  frame.tipAngle = now.output.angularDepth;
  frame.tip.place_W = now.output.tip_W;
  frame.tweezers.place_W = now.output.proxy_W;
  if (now.nodes < 2 || !hasFiniteNodes(now)) return frame;
  copyShape(now, array, frame);
  const std::uint32_t last = now.nodes - 1;
  frame.tip = pose(numbers(node(now, last)), node(now, last) - node(now, last - 1));
  frame.tweezers =
      pose(now.output.proxy_W, {now.baseAxis_W[0], now.baseAxis_W[1], now.baseAxis_W[2]});

  // From the tip along the nodes: both lists are sorted by distance.
  std::uint32_t end = last;
  double passed = 0.0;  // from the tip to node `end` [m]
  for (const Length place : array.contactsFromTip) {
    if (frame.contacts == maxContacts) break;
    double step = (node(now, end) - node(now, end - 1)).norm();
    while (end > 1 && passed + step < place.si()) {
      passed += step;
      --end;
      step = (node(now, end) - node(now, end - 1)).norm();
    }
    const double along = step > 0.0 ? std::clamp((place.si() - passed) / step, 0.0, 1.0) : 0.0;
    frame.contact_W[frame.contacts] =
        numbers(node(now, end) + along * (node(now, end - 1) - node(now, end)));
    ++frame.contacts;
  }
  return frame;
}

}  // namespace perilymph::broadcast

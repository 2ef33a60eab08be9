// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Position of the array in the scala's own coordinates, for flat views.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::charts {

/// One node of the array, in its half-plane through the modiolar axis.
struct NodePlace {
  double fromTip_mm = 0.0;
  bool isInside = false;  ///< Past the plane of the opening.
  bool isAbove = false;   ///< Above the cochlear partition, in the scala vestibuli.
  /// Angle from the round window, full turns included. Negative in the straight lead-in, as if the
  /// circle of the first section continued.
  double angle_deg = 0.0;
  double across_mm = 0.0;  ///< From the section's center, positive toward the outer wall.
  double up_mm = 0.0;      ///< From the section's center, positive toward the apex.
  double normal_mN = 0.0;  ///< Normal force of the wall, 0 or more.
  /// Components of the wall's force perpendicular to the array, so without friction; at the tip the
  /// whole force [mN].
  double pushAcross_mN = 0.0, pushUp_mN = 0.0;
  /// Direction of the array toward the tip: across, up, and along the duct.
  Eigen::Vector3d along = Eigen::Vector3d::Zero();
};

/// Tracks an array through a scala. Keeps a reference to the scala, which must outlive it.
class ArrayInScala {
public:
  ArrayInScala(const anatomy::ScalaTympani& scala, const electrode::ArrayDesign& array);

  /// Locates every node. A snapshot with fewer than 2 nodes or with a non-finite one results in
  /// none.
  void follow(const haptics::Snapshot& now);

  const std::vector<NodePlace>& nodes() const { return nodes_; }  ///< Base first, tip last.
  /// Their positions [m]: as many as nodes().
  const std::vector<Eigen::Vector3d>& nodes_W() const { return nodes_W_; }
  /// Linear interpolation between nodes; the tip for 0 or less. Requires nodes.
  NodePlace at(double fromTip_mm) const;
  /// Angles from the round window between which the cochlear partition is torn [degrees].
  const std::vector<std::array<double, 2>>& torn_deg() const { return torn_deg_; }
  /// Whether the tip is past the plane of the opening.
  bool isInside() const { return !nodes_.empty() && nodes_.back().isInside; }

  const anatomy::ScalaTympani& scala() const { return scala_; }
  const electrode::ArrayDesign& array() const { return array_; }

private:
  NodePlace place(const Eigen::Vector3d& node_W, anatomy::LumenTrack& track,
                  Eigen::Vector3d& across_W, Eigen::Vector3d& duct_W) const;

  const anatomy::ScalaTympani& scala_;
  electrode::ArrayDesign array_;
  std::vector<NodePlace> nodes_;
  std::vector<Eigen::Vector3d> nodes_W_;
  std::vector<std::array<double, 2>> torn_deg_;
};

}  // namespace perilymph::charts

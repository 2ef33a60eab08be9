#pragma once

// Where the array lies in the scala, in the scala's own coordinates: what flat views are drawn
// from.

#include <Eigen/Core>
#include <vector>

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::charts {

/// One node of the array in the half-plane through the modiolar axis that it lies in.
struct NodePlace {
  double fromTip_mm = 0.0;
  bool isInside = false;  ///< Past the plane of the opening.
  /// From the round window, turns counted. Before it, along the straight lead-in: negative, as if
  /// the first section's circle went on.
  double angle_deg = 0.0;
  double across_mm = 0.0;  ///< From the section's center, positive toward the outer wall.
  double up_mm = 0.0;      ///< From the section's center, positive toward the apex.
  double normal_mN = 0.0;  ///< Normal force of the wall, 0 or more.
  /// Force of the wall without what runs along the array, so without friction; at the tip all of
  /// it [mN].
  double pushAcross_mN = 0.0, pushUp_mN = 0.0;
  /// Direction of the array toward the tip: across and up as above, and along the duct.
  Eigen::Vector3d along = Eigen::Vector3d::Zero();
};

/// Follows an array through a scala. Keeps the scala by reference: it must outlive this.
class ArrayInScala {
public:
  ArrayInScala(const anatomy::ScalaTympani& scala, const electrode::ArrayDesign& array);

  /// Finds every node. A snapshot with fewer than 2 nodes, or with one that is not finite, leaves
  /// none.
  void follow(const haptics::Snapshot& now);

  const std::vector<NodePlace>& nodes() const { return nodes_; }  ///< Base first, tip last.
  /// Where they are [m]: as many as nodes().
  const std::vector<Eigen::Vector3d>& nodes_W() const { return nodes_W_; }
  /// Between nodes, by straight lines; the tip's place for 0 or less. Only where nodes() has some.
  NodePlace at(double fromTip_mm) const;
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
};

}  // namespace perilymph::charts

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Geometry of the rod in one iteration, and its section properties in this step.

#include <Eigen/Core>
#include <vector>

namespace perilymph::mechanics {

/// The start of a time step, relative to which motion is computed.
struct StepStart {
  explicit StepStart(std::size_t nodes = 0) : position_W(nodes) {}

  std::vector<Eigen::Vector3d> position_W;  ///< Position of each node [m].
};

/// Bending stiffness and rest curvature at each node for the position of the stylet in this step.
struct SectionStiffness {
  explicit SectionStiffness(std::size_t nodes = 0)
      : bending(nodes), bendingExcess(nodes), restBend(nodes)
  {
  }

  std::vector<double> bending;        ///< EI at each node, the smaller one [N.m^2].
  std::vector<double> bendingExcess;  ///< Amount by which the larger EI exceeds it [N.m^2].
  std::vector<double> restBend;       ///< Spacing times rest curvature at each node.
};

/// A link of the rod between two nodes.
struct RodEdge {
  Eigen::Vector3d tangent_W = Eigen::Vector3d::Zero();  ///< Unit, toward the tip.
  double length = 0.0;                                  ///< [m]
  double inverseLength = 0.0;                           ///< 1 / length [1/m]
  double tension = 0.0;                                 ///< [N]
};

/// Edges, bends and twist of the rod in the current iteration, and at the start of the step,
/// relative to which damping and twist are computed.
struct RodKinematics {
  explicit RodKinematics(std::size_t nodes = 0)
      : edge(nodes),
        inverseSum(nodes),
        lengthBefore(nodes),
        bendBefore_W(nodes, Eigen::Vector3d::Zero()),
        restBend_W(nodes, Eigen::Vector3d::Zero()),
        stiffer_W(nodes, Eigen::Vector3d::Zero()),
        twist(nodes),
        twistRate_W(nodes, Eigen::Vector3d::Zero()),
        curlAcross_W(nodes, Eigen::Vector3d::Zero())
  {
  }

  std::vector<RodEdge> edge;                  ///< Edge i, between nodes i and i + 1.
  std::vector<double> inverseSum;             ///< 1 / (1 + cosine of the angle) at each node.
  std::vector<double> lengthBefore;           ///< Length of each edge at the start of the step [m].
  std::vector<Eigen::Vector3d> bendBefore_W;  ///< At each node at the start of the step.
  std::vector<Eigen::Vector3d> restBend_W;    ///< Rest bend at each node, with its direction.
  std::vector<Eigen::Vector3d> stiffer_W;     ///< Direction of the larger EI at each node.
  std::vector<double> twist;  ///< Twist of the edge after each node against the one before [rad].
  /// Gradient of the twist at each node by the motion of the next node relative to the previous one
  /// [1/m].
  std::vector<Eigen::Vector3d> twistRate_W;
  std::vector<Eigen::Vector3d> curlAcross_W;  ///< Each edge's tangent cross its curl.
  double twistTorque = 0.0;  ///< Torque of the array on the hand about its axis [N.m].
};

/// The symmetric tridiagonal system for the rotation of every edge about its axis.
struct TwistSystem {
  explicit TwistSystem(std::size_t nodes = 0) : torque(nodes), stiffness(nodes), beside(nodes) {}

  std::vector<double> torque;     ///< On each edge [N.m].
  std::vector<double> stiffness;  ///< Torsional stiffness of each edge [N.m].
  std::vector<double> beside;     ///< Coupling of each edge and the one before [N.m].
};

}  // namespace perilymph::mechanics

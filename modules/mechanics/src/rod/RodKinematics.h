// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Geometry of the rod in one iteration, and its section properties in this step.

#include <Eigen/Core>
#include <array>
#include <limits>
#include <vector>

#include "lanes/Lanes.h"
#include "perilymph/mechanics/InsertionModel.h"

namespace perilymph::mechanics {

/// The start of a time step, relative to which motion is computed.
struct StepStart {
  explicit StepStart(std::size_t nodes = 0)
      : position_W(nodes, Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()))
  {
  }

  std::vector<Eigen::Vector3d> position_W;  ///< Position of each node [m]; not a number: not yet.
};

/// Where the nodes are expected at the end of a time step.
struct Prediction {
  explicit Prediction(std::size_t nodes = 0) : position_W(nodes) {}

  std::vector<Eigen::Vector3d> position_W;  ///< Position of each node [m].
  bool goesOn = false;                      ///< They were expected to continue as before.
};

/// Stiffness of edges and joints of the length h, and rest curvature, for the position of the stylet
/// in this step.
struct SectionStiffness {
  explicit SectionStiffness(std::size_t nodes = 0)
      : stretching(nodes),
        bending(nodes),
        bendingExcess(nodes),
        twisting(nodes),
        restBend(nodes),
        restMoment(nodes),
        relaxing(nodes),
        heldAlong(nodes),
        heldAcross(nodes),
        setAlong(nodes),
        setAcross(nodes)
  {
    for (auto& [stiffness, moment] : yielding) {
      stiffness.resize(nodes);
      moment.assign(nodes, 1.0);
    }
    for (auto& square : elasticSquare) square.resize(nodes);
  }

  std::vector<double> stretching;     ///< EA / h of each edge [N/m].
  std::vector<double> bending;        ///< EI / h at each node, of the smaller EI [N.m].
  std::vector<double> bendingExcess;  ///< Amount by which the larger EI / h exceeds it [N.m].
  std::vector<double> twisting;       ///< GJ / h at each node [N.m].
  std::vector<double> restBend;       ///< Spacing times rest curvature at each node.
  std::vector<double> restMoment;     ///< EI / h times rest bend [N.m].
  std::vector<double> relaxing;       ///< Fraction of EI that belongs to the carrier.
  bool holds = false;                 ///< Bends relax or wires yield: the next two are set ...
  std::size_t branches = 0;           ///< ... and, if some can yield, the two after them.
  std::array<std::size_t, yieldingBranches> branch{};  ///< Those that can, of `yielding`.
  std::vector<double> heldAlong;   ///< Rest bend with what Maxwell elements hold, toward the curl.
  std::vector<double> heldAcross;  ///< The same perpendicular to it.
  std::vector<double> setAlong;    ///< The part of heldAlong that wires hold by what they yielded.
  std::vector<double> setAcross;   ///< The same of heldAcross.
  std::array<YieldingBranch, yieldingBranches> yielding;  ///< If something yields.
  /// Square of the largest bend at which each of them is elastic.
  std::array<std::vector<double>, yieldingBranches> elasticSquare;
  /// What they were computed for; not a number: not yet.
  double styletWithdrawal = std::numeric_limits<double>::quiet_NaN();  ///< [m]
  double released = 0.0;  ///< Fraction of the rest curvature that the array has taken on.
};

/// Edges, bends and twist of the rod in the current iteration, and at the start of the step,
/// relative to which damping and twist are computed. Edge i is the link between nodes i and i + 1.
struct RodKinematics {
  explicit RodKinematics(std::size_t nodes = 0)
      : tangent_W(nodes),
        length(nodes),
        inverseLength(nodes),
        tension(nodes),
        inverseSum(nodes),
        lengthBefore(nodes),
        bendBefore_W(nodes),
        restBend_W(nodes),
        stiffer_W(nodes),
        bendAlong_W(nodes),
        bendAcross_W(nodes),
        set_W(nodes),
        wireOffset_W{Axes(nodes), Axes(nodes), Axes(nodes)},
        wireSlip(nodes),
        twist(nodes),
        twistRate_W(nodes + 1),
        curlAcross_W(nodes),
        onLast_W(nodes),
        onNext_W(nodes),
        onNode_W(nodes)
  {
  }

  Axes tangent_W;                     ///< Unit vector of each edge, toward the tip.
  std::vector<double> length;         ///< Length of each edge [m].
  std::vector<double> inverseLength;  ///< 1 / length [1/m]
  std::vector<double> tension;        ///< Tension of each edge [N].
  std::vector<double> inverseSum;     ///< 1 / (1 + cosine of the angle) at each node.
  std::vector<double> lengthBefore;   ///< Length of each edge at the start of the step [m].
  Axes bendBefore_W;                  ///< Bend at each node at the start of the step.
  Axes restBend_W;                    ///< Rest bend at each node, with its direction.
  Axes stiffer_W;                     ///< Direction of the larger EI at each node.
  Axes bendAlong_W;                   ///< Unit: axis of each node toward its curl, if bends relax.
  Axes bendAcross_W;                  ///< Unit: perpendicular to it and to the array.
  Axes set_W;                         ///< What wires hold of the rest bend.
  std::array<Axes, yieldingBranches>
      wireOffset_W;              ///< Bend of each branch of wires beyond that of the joint.
  std::vector<double> wireSlip;  ///< Work of yielding at each node in a step [J].
  std::vector<double> twist;  ///< Twist of the edge after each node against the one before [rad].
  /// Gradient of the twist at each node by the motion of the next node relative to the previous one
  /// [1/m].
  Axes twistRate_W;
  Axes curlAcross_W;         ///< Each edge's tangent cross its curl.
  Axes onLast_W;             ///< Force of each bent joint, subtracted from the node before [N] ...
  Axes onNext_W;             ///< ... from the node after, with the tension of the edge ...
  Axes onNode_W;             ///< ... and added to the node itself: zero at both ends of the array.
  double twistTorque = 0.0;  ///< Torque of the array on the hand about its axis [N.m].
};

/// A bending stiffness of each joint in one direction.
struct DirectedStiffness {
  explicit DirectedStiffness(std::size_t nodes = 0)
      : stiffness(nodes), byLast_W(nodes), byNext_W(nodes)
  {
  }

  std::vector<double> stiffness;  ///< [N.m]
  Axes byLast_W;  ///< Gradient of the bend in that direction by the node before a joint [1/m] ...
  Axes byNext_W;  ///< ... and by the node after it.
};

/// What the stiffness of each edge and joint follows from (rod/RodStiffness.h); 0 where there is none, at
/// both ends and one beyond.
struct JointStiffness {
  explicit JointStiffness(std::size_t nodes = 0)
      : along(nodes + 1),
        sideways(nodes + 1),
        byNext(nodes + 1),
        byLast(nodes + 1),
        byBoth(nodes + 1),
        cosine(nodes + 1),
        twisting(nodes + 1),
        excess(nodes + 1)
  {
    for (DirectedStiffness& each : yielded) each = DirectedStiffness(nodes + 1);
  }

  std::vector<double> along;  ///< Stiffness of each edge along itself, with damping [N/m].
  std::vector<double>
      sideways;  ///< By how much that across it, from its tension, exceeds this [N/m].
  std::vector<double> byNext;  ///< That of each joint by the motion of the node after it [N/m] ...
  std::vector<double> byLast;  ///< ... of the node before it ...
  std::vector<double> byBoth;  ///< ... and of both.
  std::vector<double> cosine;  ///< Cosine of the angle between the two edges.
  std::vector<double> twisting;  ///< GJ / h [N.m].
  DirectedStiffness excess;      ///< What an oval section has more in its stiffer direction.
  std::array<DirectedStiffness, yieldingBranches> yielded;  ///< What branches that yield lack ...
  std::array<bool, yieldingBranches> yields{};              ///< ... if any joint of them does.
};

/// The symmetric tridiagonal system for the rotation of every edge about its axis.
struct TwistSystem {
  explicit TwistSystem(std::size_t nodes = 0)
      : torque(nodes),
        stiffness(nodes),
        beside(nodes),
        turn(nodes),
        torqueByNext(nodes),
        stiffnessByNext(nodes)
  {
  }

  std::vector<double> torque;           ///< On each edge [N.m].
  std::vector<double> stiffness;        ///< Torsional stiffness of each edge [N.m].
  std::vector<double> beside;           ///< Coupling of each edge and the one before [N.m].
  std::vector<double> turn;             ///< Rotation of each edge in this step [rad]; the first: 0.
  std::vector<double> torqueByNext;     ///< Part of `torque` from the joint after an edge [N.m].
  std::vector<double> stiffnessByNext;  ///< The same of `stiffness` [N.m].
};

}  // namespace perilymph::mechanics

#pragma once

// Room for the intermediate results of one step, allocated once with the state. Nothing in it
// outlives a step.

#include <Eigen/Core>
#include <vector>

#include "perilymph/anatomy/Lumen.h"
#include "perilymph/mechanics/BandMatrix.h"
#include "perilymph/mechanics/RimContact.h"

namespace perilymph::mechanics {

/// A link of the rod between two nodes.
struct RodEdge {
  Eigen::Vector3d tangent_W = Eigen::Vector3d::Zero();  ///< Unit, toward the tip.
  double length = 0.0;                                  ///< [m]
  double perLength = 0.0;                               ///< 1 / length [1/m]
  double tension = 0.0;                                 ///< [N]
};

/// How far an oval section reaches toward the wall, where it first was near it in this step.
struct SectionReach {
  bool isKnown = false;
  double length = 0.0;  ///< [m]
  double rate = 0.0;    ///< By a turn of the section [m].
};

struct StepRoom {
  explicit StepRoom(std::size_t nodes = 0)
      : matrix(nodes > 0 ? nodes - 1 : 0),
        right(matrix.blocks()),
        force_W(nodes),
        before_W(nodes),
        curlBefore_W(nodes),
        trackBefore(nodes),
        start_W(nodes),
        trial_W(matrix.blocks()),
        edge(nodes),
        bending(nodes),
        bendingMore(nodes),
        restBend(nodes),
        restBend_W(nodes, Eigen::Vector3d::Zero()),
        stiffer_W(nodes, Eigen::Vector3d::Zero()),
        twist(nodes),
        twistRate_W(nodes, Eigen::Vector3d::Zero()),
        curlAcross_W(nodes, Eigen::Vector3d::Zero()),
        perSum(nodes),
        turn(nodes),
        turnStiffness(nodes),
        turnBeside(nodes),
        lengthBefore(nodes),
        bendBefore_W(nodes, Eigen::Vector3d::Zero()),
        reach(nodes),
        isAsked(nodes),
        isKnown(nodes),
        seenFrom_W(nodes, Eigen::Vector3d::Zero()),
        walked(nodes),
        hold(nodes),
        goal_W(nodes, Eigen::Vector3d::Zero()),
        wall(nodes),
        section(nodes),
        pressedBefore(nodes),
        normalBefore_W(nodes, Eigen::Vector3d::Zero()),
        touching(nodes),
        wallStiffness(nodes),
        frictionSpring_W(nodes),
        slip(nodes),
        isSliding(nodes)
  {
  }

  BandMatrix matrix;
  std::vector<Eigen::Vector3d> right;     ///< Unbalanced force on each block [N].
  std::vector<Eigen::Vector3d> force_W;   ///< On each node, rod and wall [N].
  std::vector<Eigen::Vector3d> before_W;  ///< Positions at the start of the step [m].
  double timeStep = 0.0;                  ///< Of this step, or of the part of it that is taken [s].
  std::vector<Eigen::Vector3d> curlBefore_W;     ///< At the start of the step.
  std::vector<anatomy::LumenTrack> trackBefore;  ///< At the start of the step.
  std::vector<Eigen::Vector3d> start_W;          ///< Where this Newton step starts from [m].
  std::vector<Eigen::Vector3d> trial_W;          ///< The Newton step itself, per block [m].
  std::vector<RodEdge> edge;                     ///< Edge i, between nodes i and i + 1.
  std::vector<double> bending;                   ///< EI at each node, the lesser [N.m^2].
  std::vector<double> bendingMore;               ///< By which the greater exceeds it [N.m^2].
  std::vector<double> restBend;                  ///< Spacing times rest curvature at each node.
  std::vector<Eigen::Vector3d> restBend_W;       ///< The same, with its direction.
  std::vector<Eigen::Vector3d> stiffer_W;  ///< At each node: the way an oval section resists more.
  std::vector<double> twist;               ///< Of the edge after each node against the last [rad].
  /// At each node: by the motion of the next against that of the last [1/m].
  std::vector<Eigen::Vector3d> twistRate_W;
  std::vector<Eigen::Vector3d> curlAcross_W;    ///< Of each edge: its tangent cross its curl.
  std::vector<double> perSum;                   ///< 1 / (1 + cosine of the angle) at each node.
  std::vector<double> turn;                     ///< Torque on each edge [N.m].
  std::vector<double> turnStiffness;            ///< Of each edge [N.m].
  std::vector<double> turnBeside;               ///< Between each edge and the one before [N.m].
  double twistTorque = 0.0;                     ///< Of the array on the hand about its axis [N.m].
  std::vector<double> lengthBefore;             ///< Of each edge at the start of the step [m].
  std::vector<Eigen::Vector3d> bendBefore_W;    ///< At each node at the start of the step.
  std::vector<double> reach;                    ///< Of the lumen query at each node [m].
  std::vector<unsigned char> isAsked;           ///< Whether the lumen was asked for each node.
  std::vector<unsigned char> isKnown;           ///< Whether `wall` is of this step.
  std::vector<Eigen::Vector3d> seenFrom_W;      ///< Where each node sees its `wall` from [m].
  std::vector<double> walked;                   ///< By each node since the lumen was asked [m].
  std::vector<double> hold;                     ///< Inertia and drag of each node [N/m] ...
  std::vector<Eigen::Vector3d> goal_W;          ///< ... and where they hold it [m].
  std::vector<anatomy::WallPoint> wall;         ///< As each node sees it.
  std::vector<SectionReach> section;            ///< Of each node, if it is oval.
  std::vector<double> pressedBefore;            ///< Normal force that bounds friction [N].
  std::vector<Eigen::Vector3d> normalBefore_W;  ///< That friction lies across.
  double rimPressedBefore = 0.0;                ///< The same at the rim [N].
  Eigen::Vector3d rimNormalBefore_W = Eigen::Vector3d::Zero();
  std::size_t touches = 0;                            ///< How many nodes touch the wall.
  std::vector<std::size_t> touching;                  ///< Which ones, from the base on.
  std::vector<SymmetricBlock<double>> wallStiffness;  ///< Of the wall at each of them [N/m].
  std::vector<Eigen::Vector3d> frictionSpring_W;      ///< As this iteration would leave it [m].
  std::vector<double> slip;                           ///< Of each node in this step [m].
  std::vector<unsigned char> isSliding;               ///< As this iteration would leave it.
  RimContact rim;                                     ///< As this iteration would leave it.
  RimStiffness rimStiffness;                          ///< Of the rim where it touches.
};

}  // namespace perilymph::mechanics

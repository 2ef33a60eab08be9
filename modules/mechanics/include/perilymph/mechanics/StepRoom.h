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

struct StepRoom {
  explicit StepRoom(std::size_t nodes = 0)
      : matrix(nodes > 0 ? nodes - 1 : 0),
        right(matrix.blocks()),
        force_W(nodes),
        before_W(nodes),
        start_W(nodes),
        trial_W(matrix.blocks()),
        edge(nodes),
        bending(nodes),
        restBend(nodes),
        restBend_W(nodes, Eigen::Vector3d::Zero()),
        lengthBefore(nodes),
        bendBefore_W(nodes, Eigen::Vector3d::Zero()),
        reach(nodes),
        isAsked(nodes),
        wall(nodes),
        touching(nodes),
        wallStiffness(nodes),
        frictionSpring_W(nodes),
        slip(nodes),
        isSliding(nodes)
  {
  }

  BandMatrix matrix;
  std::vector<Eigen::Vector3d> right;         ///< Unbalanced force on each block [N].
  std::vector<Eigen::Vector3d> force_W;       ///< On each node, rod and wall [N].
  std::vector<Eigen::Vector3d> before_W;      ///< Positions at the start of the step [m].
  std::vector<Eigen::Vector3d> start_W;       ///< Where this Newton step starts from [m].
  std::vector<Eigen::Vector3d> trial_W;       ///< The Newton step itself, per block [m].
  std::vector<RodEdge> edge;                  ///< Edge i, between nodes i and i + 1.
  std::vector<double> bending;                ///< EI at each node [N.m^2].
  std::vector<double> restBend;               ///< Spacing times rest curvature at each node.
  std::vector<Eigen::Vector3d> restBend_W;    ///< The same, with its direction.
  std::vector<double> lengthBefore;           ///< Of each edge at the start of the step [m].
  std::vector<Eigen::Vector3d> bendBefore_W;  ///< At each node at the start of the step.
  std::vector<double> reach;                  ///< Of the lumen query at each node [m].
  std::vector<unsigned char> isAsked;         ///< Whether the lumen was asked for each node.
  std::vector<anatomy::WallPoint> wall;       ///< As each node sees it.
  std::size_t touches = 0;                    ///< How many nodes touch the wall.
  std::vector<std::size_t> touching;          ///< Which ones, from the base on.
  std::vector<SymmetricBlock<double>> wallStiffness;  ///< Of the wall at each of them [N/m].
  std::vector<Eigen::Vector3d> frictionSpring_W;      ///< As this iteration would leave it [m].
  std::vector<double> slip;                           ///< Of each node in this step [m].
  std::vector<unsigned char> isSliding;               ///< As this iteration would leave it.
  RimContact rim;                                     ///< As this iteration would leave it.
  RimStiffness rimStiffness;                          ///< Of the rim where it touches.
};

}  // namespace perilymph::mechanics

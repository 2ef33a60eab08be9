// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The contacts of the array with the wall and the rim.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "lanes/Flags.h"
#include "lanes/Lanes.h"
#include "perilymph/anatomy/Lumen.h"
#include "perilymph/mechanics/InsertionState.h"
#include "perilymph/mechanics/PassageModel.h"
#include "perilymph/mechanics/RimContact.h"
#include "solver/Blocks.h"

namespace perilymph::mechanics {

/// Derivative of the rim's force, distributed to the nodes near it.
struct RimStiffness {
  std::size_t first = 0;             ///< First of those nodes.
  std::size_t count = 0;             ///< Number of nodes: 0 without contact, at most 3.
  double weight[3] = {};             ///< Weight of each node; they add up to 1.
  SymmetricBlock<double> stiffness;  ///< [N/m]
};

/// The wall near each node where the lumen was last queried, kept over many steps: while a node stays
/// in the trust radius, the distance and its gradient follow from the second derivatives.
struct SeenWalls {
  explicit SeenWalls(std::size_t nodes = 0)
      : from_W(nodes),
        distance(nodes),
        normal_W(nodes),
        hessian_W{Axes(nodes), Axes(nodes), Axes(nodes)},
        trustRadius(nodes)
  {
  }

  Axes from_W;                      ///< Position of each node at the query [m].
  std::vector<double> distance;     ///< There [m].
  Axes normal_W;                    ///< Gradient of the distance there.
  std::array<Axes, 3> hessian_W;    ///< Rows of its second derivatives [1/m].
  std::vector<double> trustRadius;  ///< [m]; 0: none is kept.
};

/// Force of a compliant wall at a penetration depth, and its slope.
struct NormalForce {
  double force = 0.0;  ///< [N]
  double slope = 0.0;  ///< [N/m]
};

/// A node in an open part of the cochlear partition or above the partition, in one step.
struct OpenNode {
  bool isOpen = false;               ///< Whether the node is one.
  SectionReach both;                 ///< Reach of an oval section toward the wall of both scalae.
  double onPartition = 0.0;          ///< Its force on what is left of the partition [N].
  SymmetricBlock<double> stiffness;  ///< Stiffness of its contact [N/m].
};

/// The contacts of the current iteration. `seen` and `wall` are kept between steps.
struct ContactSet {
  explicit ContactSet(std::size_t nodes = 0)
      : reach(nodes),
        height(nodes),
        squaredMotion(nodes),
        isBeside(nodes),
        isKnown(nodes),
        isNear(nodes),
        isFollowed(nodes),
        isDistant(nodes),
        isNearPlane(nodes),
        mayPress(nodes),
        isPressed(nodes),
        seen(nodes),
        wall(nodes),
        distance(nodes),
        normal_W(nodes),
        section(nodes),
        onPartition(nodes),
        half(nodes),
        slope(nodes),
        touching(nodes)
  {
  }

  std::vector<double> reach;          ///< Reach of the lumen query at each node [m].
  std::vector<double> height;         ///< Height of each node above the opening [m].
  std::vector<double> squaredMotion;  ///< Squared motion of each node in this step [m^2].
  Flags isBeside;                     ///< InsertionState::isBeside.
  Flags isKnown;                      ///< Whether the wall was found in this step.
  Flags isNear;                       ///< Whether the wall is within reach of each node.
  Flags isFollowed;                   ///< Whether `seen` or the clearance told that.
  Flags isDistant;                    ///< Whether the lumen told how far the wall is.
  Flags isNearPlane;                  ///< Whether each node is near the plane of the opening.
  Flags mayPress;                     ///< Whether each section, if it is oval, must tell its reach.
  Flags isPressed;                    ///< Whether the wall presses each node.
  SeenWalls seen;                     ///< What the lumen was found to be.
  std::vector<anatomy::WallPoint> wall;  ///< The last answer of the lumen for each node.
  std::vector<double> distance;          ///< That of the wall, if it is near [m] ...
  Axes normal_W;                         ///< ... and its gradient.
  std::vector<SectionReach> section;     ///< Section of each node, if it is oval.
  std::vector<double> onPartition;       ///< Force of each node on the cochlear partition [N].
  std::vector<OpenNode> open;            ///< Empty if the partition cannot rupture.
  std::vector<double> half;              ///< Reach of each oval section toward the wall [m].
  std::vector<double> slope;  ///< Slope of the normal force on each node that is pressed [N/m].
  std::size_t touches = 0;    ///< Number of nodes that touch the wall, or ...
  std::vector<std::size_t>
      touching;               ///< ... are held by friction where they did, from the base on.
  RimContact rim;             ///< State of the rim contact after this iteration.
  RimStiffness rimStiffness;  ///< Stiffness of the rim contact.
  std::array<RimStiffness, maxPassageRings - 1>
      innerRings;  ///< The same at the rings of a passage behind it.
};

/// The wall at a node.
inline anatomy::WallPoint wallAt(const ContactSet& contacts, std::size_t i) noexcept
{
  anatomy::WallPoint wall = contacts.wall[i];
  wall.isNear = contacts.isNear[i] == yes;
  wall.distance = contacts.distance[i];
  wall.normal_W = contacts.normal_W[i];
  return wall;
}

}  // namespace perilymph::mechanics

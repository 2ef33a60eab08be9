#pragma once

// Which nodes touch the wall or the rim, and how it pushes back.

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "perilymph/anatomy/Lumen.h"
#include "perilymph/mechanics/RimContact.h"
#include "solver/Blocks.h"

namespace perilymph::mechanics {

/// How far an oval section reaches toward the wall, where it first was near it in this step.
struct SectionReach {
  bool isKnown = false;
  double length = 0.0;  ///< [m]
  double rate = 0.0;    ///< Derivative by a turn of the section [m].
};

/// The derivative of the rim's force, distributed over the nodes that carry it.
struct RimStiffness {
  std::size_t first = 0;             ///< First of those nodes.
  std::size_t count = 0;             ///< How many: 0 where it does not touch, at most 3.
  double weight[3] = {};             ///< Weight of each; they add up to 1.
  SymmetricBlock<double> stiffness;  ///< [N/m]
};

/// The contacts of the current iteration.
struct ContactSet {
  explicit ContactSet(std::size_t nodes = 0)
      : reach(nodes),
        isAsked(nodes),
        isKnown(nodes),
        seenFrom_W(nodes, Eigen::Vector3d::Zero()),
        walked(nodes),
        wall(nodes),
        section(nodes),
        touching(nodes),
        wallStiffness(nodes)
  {
  }

  std::vector<double> reach;                ///< Reach of the lumen query at each node [m].
  std::vector<unsigned char> isAsked;       ///< Whether the lumen was asked for each node.
  std::vector<unsigned char> isKnown;       ///< Whether `wall` is of this step.
  std::vector<Eigen::Vector3d> seenFrom_W;  ///< Position from which each node sees its `wall` [m].
  std::vector<double> walked;               ///< By each node since the lumen was asked [m].
  std::vector<anatomy::WallPoint> wall;     ///< As each node sees it.
  std::vector<SectionReach> section;        ///< Section of each node, if it is oval.
  std::size_t touches = 0;                  ///< Number of nodes that touch the wall.
  std::vector<std::size_t> touching;        ///< Those nodes, from the base on.
  std::vector<SymmetricBlock<double>>
      wallStiffness;          ///< Stiffness of the wall at each of them [N/m].
  RimContact rim;             ///< As this iteration would leave it.
  RimStiffness rimStiffness;  ///< Stiffness of the rim where it touches.
};

}  // namespace perilymph::mechanics

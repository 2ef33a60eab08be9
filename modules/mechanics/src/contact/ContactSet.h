// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The contacts of the array with the wall and the rim.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

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
  std::vector<unsigned char> isAsked;       ///< Whether the lumen was queried for each node.
  std::vector<unsigned char> isKnown;       ///< Whether `wall` is from this step.
  std::vector<Eigen::Vector3d> seenFrom_W;  ///< Position for which `wall` is valid at each node
                                            ///< [m].
  std::vector<double> walked;               ///< Displacement of each node since the last query [m].
  std::vector<anatomy::WallPoint> wall;     ///< Wall at each node.
  std::vector<SectionReach> section;        ///< Section of each node, if it is oval.
  std::size_t touches = 0;                  ///< Number of nodes that touch the wall.
  std::vector<std::size_t> touching;        ///< Indices of those nodes, from the base on.
  std::vector<SymmetricBlock<double>>
      wallStiffness;          ///< Stiffness of the wall at each of them [N/m].
  RimContact rim;             ///< State of the rim contact after this iteration.
  RimStiffness rimStiffness;  ///< Stiffness of the rim contact.
  std::array<RimStiffness, maxPassageRings - 1>
      innerRings;  ///< The same at the rings of a passage behind it.
};

}  // namespace perilymph::mechanics

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The linear system of a Newton step.

#include <Eigen/Core>
#include <vector>

#include "solver/BandFactors.h"
#include "solver/BandMatrix.h"

namespace perilymph::mechanics {

/// Stiffness, unbalanced forces and the resulting step, per block of the matrix.
struct LinearSystem {
  explicit LinearSystem(std::size_t nodes = 0)
      : matrix(nodes > 0 ? nodes - 1 : 0),
        right(matrix.blocks()),
        trial_W(matrix.blocks()),
        start_W(nodes),
        edge_W(nodes, Eigen::Vector3d::Zero()),
        factors(matrix.blocks())
  {
  }

  BandMatrix matrix;
  std::vector<Eigen::Vector3d> right;    ///< Unbalanced force on each block [N].
  std::vector<Eigen::Vector3d> trial_W;  ///< The Newton step, per block [m].
  /// The step was too short to be worth another evaluation: the next prediction makes it. Then
  /// trial_W is part of the state.
  bool stepRemains = false;
  std::vector<Eigen::Vector3d> start_W;  ///< Positions of the nodes at its start [m].
  std::vector<Eigen::Vector3d> edge_W;   ///< Each edge after the step, or its rate [m].
  /// Factors of the last factorized stiffness, from this time step or an earlier one: part of the
  /// state's value.
  BandFactors factors;
};

}  // namespace perilymph::mechanics

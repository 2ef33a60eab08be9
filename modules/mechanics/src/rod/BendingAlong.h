// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Bending stiffness of a joint in one direction.

#include <Eigen/Core>

#include "rod/RodKinematics.h"
#include "solver/BandMatrix.h"

namespace perilymph::mechanics {

/// Adds k a a^T for the component of the bend at node i along the unit vector `way_W`, whose
/// derivative by the positions is a.
void addBendingAlong(BandMatrix& matrix, const RodKinematics& rod, std::size_t i,
                     const Eigen::Vector3d& way_W, double k) noexcept;

}  // namespace perilymph::mechanics

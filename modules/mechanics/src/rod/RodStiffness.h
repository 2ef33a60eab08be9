// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The rod's stiffness: the second derivatives of its energy.

#include "perilymph/mechanics/InsertionModel.h"
#include "rod/RodKinematics.h"
#include "solver/BandMatrix.h"

namespace perilymph::mechanics {

/// Whether the geometric stiffness under compression enters the matrix: exact with it, always
/// positive definite without it.
enum class Compression { included, leftOut };

/// Sets all blocks of the matrix to the stiffness of stretching, bending and twist, at the edges that
/// setRodForces() stored. Bending is to first order in the angle between two links: w changes by
/// a P_t dx_next at the far end of one link and by b P_p dx_last at that of the other, where P_t is the
/// projection perpendicular to t.
void setRodStiffness(const InsertionModel& model, Compression compression,
                     const SectionStiffness& section, const RodKinematics& rod,
                     JointStiffness& joints, BandMatrix& matrix) noexcept;

}  // namespace perilymph::mechanics

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Where and when the cochlear partition ruptures.

#include "contact/ContactSet.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"
#include "rod/RodKinematics.h"

namespace perilymph::mechanics {

/// Ruptures the partition at the end of a balanced step where the force on it, within one contact,
/// reaches its strength. A contact is as long as the array is wide there (choice, low).
void rupturePartition(const InsertionModel& model, InsertionState& state, const RodKinematics& rod,
                      ContactSet& contacts) noexcept;

/// Opens the partition around an angle, over a width and its edges, or moves the nearer edge of an
/// opening there by PartitionModel::growth. False if it cannot open there.
bool openPartition(const PartitionModel& partition, double angle, double width,
                   PartitionState& state) noexcept;

}  // namespace perilymph::mechanics

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The force on the cochlear partition, and where and when it ruptures.

#include "contact/ContactSet.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"

namespace perilymph::mechanics {

/// The contact that loads the partition most.
struct PartitionContact {
  double force = 0.0;  ///< Within one width of the array [N].
  double angle = 0.0;  ///< Mean over the contact, weighted by force [rad].
  double width = 0.0;  ///< Width of the array there [m].
};

/// That contact at the end of a step; no force where the partition is not loaded, or is not. Each
/// node's force is spread over the spacing of nodes.
PartitionContact contactWithPartition(const InsertionModel& model, const InsertionState& state,
                                      ContactSet& contacts) noexcept;

/// Ruptures the partition at the end of a balanced step where the force on it, within one contact,
/// reaches its strength.
void rupturePartition(const PartitionModel& partition, const PartitionContact& contact,
                      InsertionState& state) noexcept;

/// Opens the partition around an angle, over a width and its edges, or moves the nearer edge of an
/// opening there by PartitionModel::growth. False if it cannot open there.
bool openPartition(const PartitionModel& partition, double angle, double width,
                   PartitionState& state) noexcept;

}  // namespace perilymph::mechanics

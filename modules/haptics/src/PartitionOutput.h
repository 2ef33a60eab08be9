// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The cochlear partition in the output of a tick.

#include "perilymph/haptics/Snapshot.h"
#include "perilymph/mechanics/InsertionModel.h"
#include "perilymph/mechanics/InsertionState.h"

namespace perilymph::haptics {

/// Sets the translocation and its status bits. Real-time safe.
void notePartition(const mechanics::InsertionModel& model,
                   const mechanics::PartitionState& partition, TickOutput& output) noexcept;

/// Sets the ranges in which the partition is open. Real-time safe.
void noteRuptures(const mechanics::PartitionState& partition, Snapshot& snapshot) noexcept;

}  // namespace perilymph::haptics

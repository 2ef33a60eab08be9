// SPDX-License-Identifier: BSD-3-Clause
#include "PartitionOutput.h"

#include <algorithm>

namespace perilymph::haptics {

void notePartition(const mechanics::InsertionModel& model,
                   const mechanics::PartitionState& partition, TickOutput& output) noexcept
{
  output.translocation = {};
  if (!partition.isRuptured()) return;
  output.status |= partitionRuptured;
  output.translocation = {partition.first.angle, partition.first.force, partition.first.depth,
                          partition.lengthAbove(model.spacing)};
  if (output.translocation.lengthAbove > 0.0) output.status |= translocated;
}

void noteRuptures(const mechanics::PartitionState& partition, Snapshot& snapshot) noexcept
{
  snapshot.ruptures = static_cast<std::uint32_t>(partition.count);
  for (std::size_t k = 0; k < partition.count; ++k)
    snapshot.ruptured[k] = {partition.ranges[k].begin, partition.ranges[k].end};
  snapshot.isAbove.reset();
  if (!partition.isRuptured()) return;
  const std::size_t nodes = std::min<std::size_t>(partition.isAbove.size(), snapshot.nodes);
  for (std::size_t i = 0; i < nodes; ++i) snapshot.isAbove[i] = partition.isAbove[i] != 0;
}

}  // namespace perilymph::haptics

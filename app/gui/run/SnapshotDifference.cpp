// SPDX-License-Identifier: BSD-3-Clause
#include "gui/run/SnapshotDifference.h"

#include <cstring>

namespace perilymph::gui {

bool lookAlike(const haptics::Snapshot& one, const haptics::Snapshot& other)
{
  const std::size_t nodes = one.nodes;
  return nodes == other.nodes && one.isAbove == other.isAbove && one.ruptures == other.ruptures &&
         one.ruptured == other.ruptured &&
         one.output.styletWithdrawal == other.output.styletWithdrawal &&
         std::memcmp(one.node_W.data(), other.node_W.data(), nodes * sizeof one.node_W[0]) == 0 &&
         std::memcmp(one.normalForce.data(), other.normalForce.data(),
                     nodes * sizeof one.normalForce[0]) == 0;
}

}  // namespace perilymph::gui

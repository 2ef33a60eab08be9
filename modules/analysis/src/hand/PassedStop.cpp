// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/PassedStop.h"

#include <algorithm>

#include "perilymph/analysis/ContactPositions.h"

namespace perilymph::analysis {

std::optional<Force> stopToPass(const session::InsertionParameters& parameters,
                                const HandDistribution& hand)
{
  const double own = parameters.engine.stopForce;
  if (own > 0.0 && own <= hand.stopHigh.si()) return std::nullopt;
  return hand.stopHigh;
}

PassedStop passedStop(const anatomy::ScalaTympani& scala, const electrode::ArrayDesign& array,
                      Force stop, const haptics::Snapshot& at)
{
  const std::vector<ContactPosition> contacts = contactPositions(scala, array, at);
  const auto inside = std::ranges::count_if(contacts, &ContactPosition::isInserted);
  return {stop, meters(at.output.depth), angularInsertionDepth(contacts),
          static_cast<std::size_t>(inside), contacts.size()};
}

}  // namespace perilymph::analysis

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Default frequency allocations: which frequencies a sound processor gives each contact.

#include <string>
#include <vector>

#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::planning {

/// A maker's default for arrays with a number of contacts.
struct FrequencyAllocation {
  std::string maker;
  std::vector<double> center_Hz;  ///< Centers of the filters, the most apical contact's first.
  std::string source, confidence;
};

/// The shipped ones: resources/planning/frequency-allocation.toml.
Result<std::vector<FrequencyAllocation>> shippedAllocations();

/// Center frequencies [Hz] of an array's contacts from the tip; empty if its maker states none for
/// its number of contacts.
std::vector<double> filtersOf(const electrode::ArrayDesign& array,
                              const std::vector<FrequencyAllocation>& allocations);

}  // namespace perilymph::planning

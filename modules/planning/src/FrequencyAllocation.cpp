// SPDX-License-Identifier: BSD-3-Clause
#include "FrequencyAllocation.h"

#include <algorithm>

#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlReader.h"

#include "perilymph/planning/DefaultFilters.h"

namespace perilymph::planning {

Result<std::vector<FrequencyAllocation>> shippedAllocations()
{
  auto reader = TomlReader::open(resource("resources/planning/frequency-allocation.toml"));
  if (!reader) return reader.error();
  reader->text("label");
  std::vector<FrequencyAllocation> allocations;
  for (TomlReader& table : reader->tables("allocation")) {
    FrequencyAllocation one;
    one.maker = table.text("maker");
    one.center_Hz = table.numbers("center_Hz", {20.0, 20000.0}, 2);
    one.source = table.text("source");
    one.confidence = table.choice("confidence", {"high", "medium", "low"});
    if (const auto done = table.finish(); !done) return done.error();
    allocations.push_back(std::move(one));
  }
  if (const auto done = reader->finish(); !done) return done.error();
  return allocations;
}

std::vector<double> filtersOf(const electrode::ArrayDesign& array,
                              const std::vector<FrequencyAllocation>& allocations)
{
  const auto found =
      std::find_if(allocations.begin(), allocations.end(), [&](const FrequencyAllocation& each) {
        return each.maker == array.maker && each.center_Hz.size() == array.contactsFromTip.size();
      });
  return found == allocations.end() ? std::vector<double>{} : found->center_Hz;
}

Result<std::vector<double>> defaultFiltersOf(const electrode::ArrayDesign& array)
{
  const auto allocations = shippedAllocations();
  if (!allocations) return allocations.error();
  return filtersOf(array, *allocations);
}

}  // namespace perilymph::planning

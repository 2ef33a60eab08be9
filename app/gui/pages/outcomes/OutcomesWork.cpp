// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/outcomes/OutcomesWork.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace perilymph::gui {

Result<AllOutcomes> allOutcomes(const std::stop_token& stop)
{
  auto library = outcome::readOutcomes(planning::ownRegistryFolders(), {}, stop,
                                       outcome::StopLengths::leftOut);
  if (!library) return library.error();
  AllOutcomes all;
  all.notes = std::move(library->notes);
  all.clinic.leftOut = library->leftOut;
  if (library->outcomes.empty()) return all;
  // the ears of a clinic are in the order of surgery
  std::vector<std::size_t> order(library->outcomes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {},
                           [&](std::size_t each) { return library->outcomes[each].surgeryUtc; });
  for (const std::size_t each : order) all.patients.push_back(library->patients[each]);
  auto clinic = outcome::compareOutcomes(std::move(library->outcomes), library->leftOut);
  if (!clinic) return clinic.error();
  all.clinic = *std::move(clinic);
  return all;
}

}  // namespace perilymph::gui

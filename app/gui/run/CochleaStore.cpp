// SPDX-License-Identifier: BSD-3-Clause
#include "gui/run/CochleaStore.h"

#include <algorithm>
#include <utility>

#include "gui/run/ScenarioDifference.h"

namespace perilymph::gui {

Result<std::shared_ptr<const anatomy::ScalaTympani>> CochleaStore::cochleaOf(
    const session::Scenario& scenario)
{
  const auto find = [&] {
    return std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
      return haveSameCochlea(entry.scenario, scenario);
    });
  };
  {
    const std::lock_guard lock(mutex_);
    if (const auto kept = find(); kept != entries_.end()) {
      std::rotate(kept, kept + 1, entries_.end());
      return entries_.back().anatomy;
    }
  }
  // Without the lock: two threads may build the same one, but neither waits for the other's.
  auto built = session::buildAnatomy(scenario);
  if (!built) return built;
  const std::lock_guard lock(mutex_);
  if (find() == entries_.end()) entries_.push_back({scenario, *built});
  if (entries_.size() > capacity) entries_.erase(entries_.begin());
  return built;
}

}  // namespace perilymph::gui

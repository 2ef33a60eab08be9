// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The rows of the table `event`. They follow from the ticks, so that a reader can check them.

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "perilymph/haptics/Snapshot.h"

namespace perilymph::session {

/// One row: an event in a tick.
struct Event {
  std::uint64_t tick = 0;
  double time = 0.0;  ///< [s]
  std::string kind;   ///< A command, "workflow", "status", "partition_ruptured_deg",
                      ///< "partition_force_N", "translocated_at_mm", "end", or "lost".
  std::variant<std::int64_t, double, std::string> value;
};

/// Derives the events from a sequence of ticks: commands, changes of workflow, new status bits, an
/// early end, and missing ticks.
class EventDetector {
public:
  /// The events of the next tick, in the order of their rows.
  std::vector<Event> add(const haptics::TickRecord& record);

  /// Ticks missing so far between the added ones.
  std::uint64_t missingTicks() const noexcept { return missingTicks_; }

private:
  std::optional<std::uint64_t> lastTick_;
  haptics::Workflow workflow_ = haptics::Workflow::idle;
  std::uint32_t status_ = haptics::allWell;
  bool isTranslocated_ = false;
  std::uint64_t missingTicks_ = 0;
};

}  // namespace perilymph::session

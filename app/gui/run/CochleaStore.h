// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The cochleae built last.

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "gui/run/CochleaMeasures.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

/// Builds cochleae and keeps the last ones with their wall tables, because a table takes some tenths of a
/// second: an undone change, a second patient and back, or a new window need no other. Any thread.
class CochleaStore {
public:
  static constexpr std::size_t capacity = 4;

  /// The cochlea of a scenario, built if none of its numbers is kept.
  Result<std::shared_ptr<const anatomy::ScalaTympani>> cochleaOf(const session::Scenario& scenario);

  /// The measures of cochleae, kept as well.
  MeasureStore& measures() { return measures_; }

private:
  struct Entry {
    session::Scenario scenario;
    std::shared_ptr<const anatomy::ScalaTympani> anatomy;
  };

  std::mutex mutex_;
  MeasureStore measures_;
  std::vector<Entry> entries_;  ///< The one used last is last.
};

}  // namespace perilymph::gui

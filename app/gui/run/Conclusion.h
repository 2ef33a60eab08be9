// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The end of an insertion in the window, and what is known before its beginning.

#include <chrono>
#include <optional>

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::gui {

/// Decides when the recording of an insertion that has ended is closed: whenever it begins to rest,
/// three seconds after the last motion; for the first end a hand that does not rest is not waited for.
class Conclusion {
public:
  static constexpr std::chrono::seconds longestWait{6};

  /// Whether to close the recording now; true once for each rest. To be asked in every frame.
  bool isDue(const haptics::TickOutput& now);
  /// It was due, and the insertion has not gone on.
  bool isRequested() const noexcept { return isRequested_; }

private:
  std::optional<std::chrono::steady_clock::time_point> ended_;  ///< When its end was seen.
  bool isRequested_ = false;
  bool isResting_ = false;
};

/// The angle of the tip from the round window before the first tick, which computes it [rad].
double angleOfTip(const anatomy::ScalaTympani& anatomy, const haptics::Snapshot& now);

}  // namespace perilymph::gui

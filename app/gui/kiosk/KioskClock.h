// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The clocks of the booth, replaceable in tests.

#include <QDateTime>
#include <chrono>
#include <functional>

namespace perilymph::gui {

/// Time source of the booth.
struct KioskClock {
  /// Monotonic time [s].
  std::function<double()> seconds = [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
  };
  /// Date and time of day, for the list.
  std::function<QDateTime()> today = [] { return QDateTime::currentDateTime(); };
};

}  // namespace perilymph::gui

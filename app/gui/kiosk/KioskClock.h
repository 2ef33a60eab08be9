#pragma once

// The two clocks of the booth, as functions, so that an afternoon passes in a moment where it must.

#include <QDateTime>
#include <chrono>
#include <functional>

namespace perilymph::gui {

/// Where the booth takes its time from.
struct KioskClock {
  /// Seconds that only ever grow.
  std::function<double()> seconds = [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
  };
  /// Day and time of day, for the board.
  std::function<QDateTime()> today = [] { return QDateTime::currentDateTime(); };
};

}  // namespace perilymph::gui

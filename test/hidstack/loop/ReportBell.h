#pragma once

// Wakes a thread when a HID device has sent a report.

#include <string>

#include "perilymph/foundation/Result.h"

namespace perilymph::hidstack {

/// A handle of its own on a hidraw node, kept for its wake-ups alone: every open handle gets every
/// report, so nobody loses one to the bell.
class ReportBell {
public:
  ReportBell() = default;
  ~ReportBell() { close(); }
  ReportBell(const ReportBell&) = delete;
  ReportBell& operator=(const ReportBell&) = delete;

  Result<Done> open(const std::string& node);
  void close() noexcept;

  enum class Ring { report, none, gone };
  /// Waits for the next report, at most so many milliseconds.
  Ring wait(int milliseconds) noexcept;

private:
  int file_ = -1;
};

}  // namespace perilymph::hidstack

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A simulated force-feedback handle: its mass, its script and its reports.

#include <cstdint>
#include <string>
#include <vector>

#include "HandleReports.h"
#include "HandleScript.h"
#include "SlidingHandle.h"
#include "TickLog.h"

namespace perilymph::hidstack {

/// The device without its connection: given the time and received reports, returns the reports to
/// send.
class VirtualHandle {
public:
  VirtualHandle(HandleScript script, const HandleBody& body);

  /// One tick of the device's clock. @return false at the end of the script.
  bool tick(std::int64_t due);
  /// Current activity of the connection.
  Wire wire() const;
  /// The reports to send in this tick: one; none or two for some flaws.
  int reportsDue() const;
  std::array<std::uint8_t, inputSize> report() const;
  /// The next report, for a device that answers.
  std::array<std::uint8_t, inputSize> answer();
  /// A report was sent.
  void noteSent(std::int64_t now);
  /// An output report arrived.
  void take(const OutputReport& report, std::int64_t now);

  const std::vector<HandleTick>& ticks() const { return ticks_; }
  const SlidingHandle& slider() const { return slider_; }

private:
  const Passage& passage() const { return script_.passages[passage_]; }
  void begin(std::size_t index, std::int64_t now);

  HandleScript script_;
  SlidingHandle slider_;
  std::vector<HandleTick> ticks_;
  std::size_t passage_ = 0;
  std::int64_t started_ = 0;  // the passage [ns]
  std::uint16_t sequence_ = 0;
  bool hasBegun_ = false;
  bool isHeard_ = false;  // an output report arrived since connection
};

}  // namespace perilymph::hidstack

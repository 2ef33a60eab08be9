// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Sends a simulated insertion to programs that speak OpenIGTLink, at the speed of real time.

#include <cstdint>
#include <memory>
#include <string>

#include "perilymph/broadcast/Broadcast.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/session/Insertion.h"

namespace perilymph::cli {

class LiveBroadcast {
public:
  /// @param endpoint   "[ADDRESS:]PORT".
  /// @param insertion  Must outlive the broadcast.
  static Result<std::unique_ptr<LiveBroadcast>> start(const std::string& endpoint,
                                                      session::Insertion& insertion);

  /// Waits until a tick is due, and sends its frame if it is 20 ms after the last one.
  void show(const haptics::TickRecord& record);

private:
  LiveBroadcast(std::unique_ptr<broadcast::Broadcast> server, session::Insertion& insertion);

  std::unique_ptr<broadcast::Broadcast> server_;
  session::Insertion& insertion_;
  std::int64_t began_;  // [ns]
  double next_ = 0.0;   // time of the next frame, since the first motion [s]
};

}  // namespace perilymph::cli

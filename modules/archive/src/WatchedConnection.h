// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The connections of DCMTK, each of whose waits ends at a cancellation, at a stall and beyond a number
// of bytes. DCMTK itself cannot be canceled while it waits.

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmnet/dcmlayer.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <stop_token>

#include "perilymph/archive/Servers.h"

namespace perilymph::archive {

/// Why the connections of one request were ended here.
enum class Ending { none, canceled, stalled, tooLarge };

/// What the connections of one request share. Used by one thread.
struct Watch {
  std::stop_token stop;
  std::function<void()> onWait;
  std::chrono::milliseconds stall{};
  std::uint64_t bytesLeft = std::numeric_limits<std::uint64_t>::max();
  Ending ending = Ending::none;
  int socket = -1;  ///< The connection that was opened first, to the server.
  int latest = -1;  ///< The one that was opened last, while it is open.

  /// Whether nothing more is to be read.
  bool isOver();
  /// Waits until one of both has data, at most so long.
  void waitForData(std::chrono::milliseconds longest) const;
};

/// A layer that opens watched connections, with TLS if the server asks for it. `watch` outlives it.
/// The error names the file that cannot be used.
Result<std::unique_ptr<DcmTransportLayer>> watchedLayer(const Server& server, Watch& watch);

}  // namespace perilymph::archive

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How long a server is waited for, and how a request to it reports and is canceled.

#include <chrono>
#include <functional>
#include <stop_token>

namespace perilymph::archive {

/// Times after which a server is given up.
struct TimeLimits {
  std::chrono::seconds connection{10};  ///< To open the connection and agree on an association.
  std::chrono::seconds answer{60};      ///< For the next answer; archives fetch from slow storage.
  std::chrono::seconds stall{30};       ///< For the next 64 KiB of an answer that has begun.
};

/// The calling thread's side of a request. All functions of this module block until they end.
struct Exchange {
  std::function<void(double)> onProgress = {};  ///< Told the fraction done, 0 to 1.
  std::stop_token stop = {};  ///< Ends the request with an error within a tenth of a second.
  /// Called about twenty times a second while the server is waited for.
  std::function<void()> onWait = {};
  /// Called before an object is given to the server: from then on, it may have it.
  std::function<void()> onStore = {};
  TimeLimits limits = {};
};

}  // namespace perilymph::archive

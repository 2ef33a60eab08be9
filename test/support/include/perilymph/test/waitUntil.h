// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Waits for another thread or program, with a time limit.

#include <chrono>
#include <thread>

namespace perilymph::test {

/// Yields until the condition holds. False if it does not hold within the timeout, which is far
/// longer than a busy machine needs.
template <typename Condition>
[[nodiscard]] bool waitUntil(Condition holds,
                             std::chrono::milliseconds timeout = std::chrono::minutes(2))
{
  const auto end = std::chrono::steady_clock::now() + timeout;
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::yield();
  }
  return true;
}

}  // namespace perilymph::test

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A clock that only moves when a test moves it, and a wait for the work of another thread.

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>

#include "perilymph/test/waitUntil.h"

namespace perilymph::device {

inline constexpr std::int64_t millisecond = 1'000'000;  ///< [ns]

inline std::atomic<std::int64_t> virtualNow{0};  ///< Time of virtualClock() [ns].
inline std::int64_t virtualClock() noexcept { return virtualNow; }

/// Expects the condition to become true without moving the clock.
template <class Condition>
void expectSoon(Condition holds)
{
  EXPECT_TRUE(test::waitUntil(holds));
}

}  // namespace perilymph::device

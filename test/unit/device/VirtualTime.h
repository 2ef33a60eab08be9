// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A clock that stands still unless a test moves it, and a wait for what another thread does.

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>

#include "perilymph/test/waitUntil.h"

namespace perilymph::device {

inline constexpr std::int64_t millisecond = 1'000'000;  ///< [ns]

inline std::atomic<std::int64_t> virtualNow{0};  ///< Time of virtualClock() [ns].
inline std::int64_t virtualClock() noexcept { return virtualNow; }

/// Expects that the condition will hold, without moving the clock.
template <class Condition>
void expectSoon(Condition holds)
{
  EXPECT_TRUE(test::waitUntil(holds));
}

}  // namespace perilymph::device

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Times in nanoseconds, as clocks count them.

#include <cmath>
#include <cstdint>

namespace perilymph::device {

/// Interval between two publications of a device's statistics [ns].
inline constexpr std::int64_t statisticsInterval = 100'000'000;

/// Seconds as nanoseconds, rounded.
inline std::int64_t nanoseconds(double seconds) noexcept { return std::llround(seconds * 1e9); }

}  // namespace perilymph::device

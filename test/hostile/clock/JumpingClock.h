// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The system's time of day, which somebody sets while a program runs. What counts time by itself
// (CLOCK_MONOTONIC) goes on, as it does on a real machine.

namespace perilymph::test {

/// From now on the time of day is this much later than it is [s]; earlier, where below 0.
void setTimeOfDay(long later);

/// How often the time of day was asked for.
long timeOfDayAsked();

}  // namespace perilymph::test

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Simulates changes of the system's time of day while a program runs. The monotonic clock is not
// affected, as on a real machine.

namespace perilymph::test {

/// Sets the offset of the time of day [s]; may be negative.
void setTimeOfDay(long later);

/// Number of requests of the time of day.
long timeOfDayRequested();

}  // namespace perilymph::test

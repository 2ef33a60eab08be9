// SPDX-License-Identifier: BSD-3-Clause
#include "JumpingClock.h"

#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <ctime>

namespace {

std::atomic<long> jump{0};
std::atomic<long> asked{0};

}  // namespace

namespace perilymph::test {

void setTimeOfDay(long later) { jump = later; }

long timeOfDayRequested() { return asked; }

}  // namespace perilymph::test

// These replace the C library's functions for all callers.

// NOLINTBEGIN(readability-identifier-naming): the names are the C library's
extern "C" int clock_gettime(clockid_t clock, timespec* time) noexcept
{
  const long outcome = ::syscall(SYS_clock_gettime, clock, time);
  if (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE) {
    time->tv_sec += jump;
    ++asked;
  }
  return static_cast<int>(outcome);
}

extern "C" time_t time(time_t* seconds) noexcept
{
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  if (seconds != nullptr) *seconds = now.tv_sec;
  return now.tv_sec;
}

extern "C" int gettimeofday(timeval* time, void*) noexcept
{
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  *time = {now.tv_sec, now.tv_nsec / 1000};
  return 0;
}
// NOLINTEND(readability-identifier-naming)

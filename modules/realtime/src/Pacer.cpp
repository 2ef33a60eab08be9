// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/realtime/Pacer.h"

#include <time.h>

#include <cerrno>
#include <cmath>
#include <stdexcept>
#include <string>

namespace perilymph::realtime {

namespace {

constexpr std::int64_t nanosecondsPerSecond = 1'000'000'000;

std::int64_t periodInNanoseconds(Duration period)
{
  if (!(period.si() >= 1e-5 && period.si() <= 1.0))  // also catches NaN
    throw std::invalid_argument("The period of a loop is " + std::to_string(period.si()) +
                                " s; it must be between 0.00001 and 1 s.");
  return std::llround(period.si() * 1e9);
}

}  // namespace

std::int64_t monotonicNanoseconds() noexcept
{
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * nanosecondsPerSecond + now.tv_nsec;
}

Pacer::Pacer(Duration period) : period_(periodInNanoseconds(period)) {}

void Pacer::start(std::int64_t now) noexcept { due_ = now + period_; }

void Pacer::begin(std::int64_t now) noexcept
{
  const std::int64_t late = now - due_;
  if (late > period_) ++lateTicks_;
  if (late <= patience * period_) {
    due_ += period_;
    return;
  }
  missedTicks_ += static_cast<std::uint64_t>(late / period_);
  due_ = now + period_;
}

void Pacer::follow(std::int64_t now) noexcept
{
  begin(now);
  due_ = now + period_;
}

std::int64_t Pacer::wait() noexcept
{
  timespec until{};
  until.tv_sec = static_cast<time_t>(due_ / nanosecondsPerSecond);
  until.tv_nsec = static_cast<long>(due_ % nanosecondsPerSecond);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
  const std::int64_t now = monotonicNanoseconds();
  begin(now);
  return now;
}

}  // namespace perilymph::realtime

// SPDX-License-Identifier: BSD-3-Clause
#include "HeldUpLoop.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <algorithm>
#include <cstdio>

#include "perilymph/realtime/Pacer.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::test {

namespace {

constexpr std::int64_t millisecond = 1'000'000;  // [ns]
constexpr std::chrono::seconds patience{30};
constexpr std::int64_t longestWait = 10'000 * millisecond;  // [ns]

/// Processor time that a thread has used [ns].
std::int64_t processorTime(clockid_t clock)
{
  timespec time{};
  clock_gettime(clock, &time);
  return std::int64_t{time.tv_sec} * 1000 * millisecond + time.tv_nsec;
}

}  // namespace

HeldUpLoop::HeldUpLoop(std::shared_ptr<ForceLog> log) : log_(std::move(log))
{
  pthread_getcpuclockid(pthread_self(), &windowClock_);
}

HeldUpLoop::~HeldUpLoop()
{
  if (release_.joinable()) release_.join();
  log_->holdUp(false);
}

bool HeldUpLoop::begin()
{
  log_->holdUp(true);
  return waitUntil([this] { return log_->isHeldUp.load(); }, patience);
}

void HeldUpLoop::setTone()
{
  if (heardAt_ != 0) return;
  heardAt_ = realtime::monotonicNanoseconds();
  entriesBefore_ = log_->size();
  release_ = std::thread([this, used = processorTime(windowClock_)] {
    realtime::Pacer poll(perilymph::milliseconds(0.05));
    poll.start(heardAt_);
    while (!isHandled_ && processorTime(windowClock_) - used < millisecond &&
           realtime::monotonicNanoseconds() - heardAt_ < longestWait)
      poll.wait();
    log_->holdUp(false);
  });
}

bool HeldUpLoop::block(std::int64_t due)
{
  isHandled_ = true;
  return waitUntil([&] { return log_->size() >= log_->firstAfter(due) + 50; }, patience);
}

void HeldUpLoop::expectStop(const char* way, std::int64_t due) const
{
  const std::size_t first = std::max(log_->firstAfter(due), entriesBefore_);
  ASSERT_GT(first, 0u);
  std::size_t zero = first;
  while (zero < log_->size() && (*log_)[zero].magnitude > 0.0) ++zero;
  ASSERT_LT(zero, log_->size()) << "The force never ended.";
  for (std::size_t i = zero; i < log_->size(); ++i) ASSERT_EQ((*log_)[i].magnitude, 0.0) << i;

  const double before = (*log_)[first - 1].magnitude;
  const std::size_t ticks = zero - first + 1;
  std::printf("%-28s %.2f N before; zero after %zu ticks, %.2f ms\n", way, before, ticks,
              double((*log_)[zero].time - due) * 1e-6);
  EXPECT_GT(before, 0.99 * PushedDevice::maxForce);
  EXPECT_LE(ticks, maxTicks);
}

}  // namespace perilymph::test

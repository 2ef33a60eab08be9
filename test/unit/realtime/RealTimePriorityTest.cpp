// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/realtime/RealTimePriority.h"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>

#include <thread>

namespace perilymph::realtime {
namespace {

TEST(RealTimePriority, SaysTheTruthAboutTheThreadThatAsked)
{
  RealTimePriority answer = RealTimePriority::refused;
  int policy = -1;
  std::thread asking([&] {
    answer = requestRealTimePriority();
    sched_param parameters{};
    pthread_getschedparam(pthread_self(), &policy, &parameters);
  });
  asking.join();
  EXPECT_EQ(answer == RealTimePriority::granted, policy == SCHED_FIFO);
}

}  // namespace
}  // namespace perilymph::realtime

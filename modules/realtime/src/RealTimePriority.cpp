// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/realtime/RealTimePriority.h"

#include <pthread.h>
#include <sched.h>

namespace perilymph::realtime {

RealTimePriority requestRealTimePriority(Rank rank) noexcept
{
  // Interrupt threads of a preemptible kernel run at 50; USB interrupts must precede this thread.
  const int priority = rank == Rank::tick ? 45 : 44;
  sched_param wanted{};
  wanted.sched_priority = priority;
  const bool granted = pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted) == 0;
  return granted ? RealTimePriority::granted : RealTimePriority::refused;
}

}  // namespace perilymph::realtime

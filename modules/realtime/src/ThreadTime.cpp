// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/realtime/ThreadTime.h"

#include <ctime>

namespace perilymph::realtime {

std::int64_t threadNanoseconds() noexcept
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

}  // namespace perilymph::realtime

// SPDX-License-Identifier: BSD-3-Clause
#include "UntrustedRead.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <new>
#include <stop_token>
#include <thread>

#include "SharedMemory.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::imaging {
namespace {

using namespace std::chrono_literals;

constexpr int answer = 7;

class RunInChild : public testing::Test {
protected:
  RunInChild() : children_(*new (memory_.start()) std::atomic<int>(0)) {}

  /// The first child waits as for a lock that nobody opens; each further one answers.
  int waitOnce()
  {
    if (++children_ > 1) return answer;
    for (;;) ::pause();
  }

  SharedMemory memory_{sizeof(std::atomic<int>)};
  std::atomic<int>& children_;
};

TEST_F(RunInChild, ReplacesAChildThatTakesTooLongOnce)
{
  EXPECT_EQ(runInChild([this] { return waitOnce(); }, {{}, {}, 2s}), answer);
  EXPECT_EQ(children_, 2);
}

TEST_F(RunInChild, DoesNotReplaceOneThatWasCanceled)
{
  std::stop_source stop;
  const std::jthread canceling([this, &stop] {
    EXPECT_TRUE(test::waitUntil([this] { return children_ > 0; }));
    stop.request_stop();
  });
  EXPECT_EQ(runInChild([this] { return waitOnce(); }, {{}, stop.get_token(), 60s}), childFailed);
  EXPECT_EQ(children_, 1);
}

TEST_F(RunInChild, DoesNotReplaceOneThatCrashed)
{
  const auto crash = [this]() -> int {
    ++children_;
    std::abort();
  };
  EXPECT_EQ(runInChild(crash, {{}, {}, 60s}), childFailed);
  EXPECT_EQ(children_, 1);
}

}  // namespace
}  // namespace perilymph::imaging

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <thread>

#include "perilymph/foundation/RealTime.h"

namespace perilymph {
namespace {

TEST(ThreadRole, IsNoneUntilTheThreadSaysSo)
{
  ThreadRole before = ThreadRole::ui;
  ThreadRole after = ThreadRole::ui;
  std::thread thread([&] {
    before = threadRole();
    registerThreadRole(ThreadRole::recorder);
    after = threadRole();
  });
  thread.join();
  EXPECT_EQ(before, ThreadRole::none);
  EXPECT_EQ(after, ThreadRole::recorder);
}

TEST(ThreadRole, BelongsToOneThreadAlone)
{
  const ThreadRole here = threadRole();
  std::thread([] { registerThreadRole(ThreadRole::worker); }).join();
  EXPECT_EQ(threadRole(), here);
}

}  // namespace
}  // namespace perilymph

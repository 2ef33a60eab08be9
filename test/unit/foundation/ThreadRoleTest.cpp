// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <pthread.h>

#include <cstring>
#include <set>
#include <string>
#include <thread>

#include "perilymph/foundation/RealTime.h"

namespace perilymph {
namespace {

std::string nameOfThisThread()
{
  char name[16] = {};
  ::pthread_getname_np(::pthread_self(), name, sizeof name);
  return name;
}

constexpr ThreadRole roles[] = {
    ThreadRole::window,     ThreadRole::haptic,      ThreadRole::recorder,
    ThreadRole::worker,     ThreadRole::calculation, ThreadRole::deviceWriter,
    ThreadRole::tapeWriter, ThreadRole::sound,       ThreadRole::deviceSupervisor};

TEST(ThreadRole, IsNoneUntilTheThreadDeclaresIt)
{
  ThreadRole before = ThreadRole::window;
  ThreadRole after = ThreadRole::window;
  std::thread thread([&] {
    before = threadRole();
    declareThread(ThreadRole::recorder);
    after = threadRole();
  });
  thread.join();
  EXPECT_EQ(before, ThreadRole::none);
  EXPECT_EQ(after, ThreadRole::recorder);
}

TEST(ThreadRole, BelongsToOneThreadAlone)
{
  const ThreadRole here = threadRole();
  std::thread([] { declareThread(ThreadRole::worker); }).join();
  EXPECT_EQ(threadRole(), here);
}

TEST(ThreadRole, NamesTheThreadForTheSystem)
{
  std::string name;
  std::thread([&name] {
    declareThread(ThreadRole::deviceWriter);
    name = nameOfThisThread();
  }).join();
  EXPECT_EQ(name, "device-writer");
}

TEST(ThreadRole, HasANameOfItsOwnThatTheSystemCanKeep)
{
  std::set<std::string> names;
  for (const ThreadRole role : roles) {
    EXPECT_LE(std::strlen(threadName(role)), 15u) << threadName(role);
    EXPECT_TRUE(names.insert(threadName(role)).second) << threadName(role);
  }
}

TEST(ThreadRole, OfTheHapticThreadIsPlayedInVirtualTimeButByNoOtherThread)
{
  for (const ThreadRole role : roles) {
    bool mayTick = false;
    std::thread([&mayTick, role] {
      declareThread(role);
      mayTick = mayActAs(ThreadRole::haptic);
    }).join();
    EXPECT_EQ(mayTick, role == ThreadRole::haptic || role == ThreadRole::calculation)
        << threadName(role);
  }
  EXPECT_TRUE(mayActAs(ThreadRole::haptic)) << "a test has no role and runs ticks";
}

}  // namespace
}  // namespace perilymph

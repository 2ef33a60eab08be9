// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/realtime/LockedMemory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <string>
#include <vector>

namespace perilymph::realtime {
namespace {

/// Memory of this process that the kernel counts as locked [kB].
long lockedByTheKernel_kB()
{
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word)
    if (word == "VmLck:") {
      long amount = 0;
      status >> amount;
      return amount;
    }
  return -1;
}

/// Runs in a child, because locks and limits stay until a process ends.
template <class Body>
int inAChild(const Body& body)
{
  const pid_t child = ::fork();
  if (child == 0) ::_exit(body());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Without the rights of root, and with this limit.
void becomeAUser(rlim_t limit)
{
  const rlimit allowed{limit, limit};
  ::setrlimit(RLIMIT_MEMLOCK, &allowed);
  if (::geteuid() == 0) static_cast<void>(::setuid(65534));
}

constexpr std::size_t size = 64 * 4096;

TEST(LockedMemory, IsWhatTheKernelCounts)
{
  EXPECT_EQ(inAChild([] {
              const std::vector<std::byte> buffer(size);
              const std::array<std::span<const std::byte>, 1> buffers{std::span(buffer)};
              const LockedMemory locked = lockMemory(buffers);
              if (locked.requested != size) return 1;
              if (locked.isComplete() != noteOn(locked).empty()) return 2;
              if (!locked.isComplete()) return 0;  // the system of this test allows nothing
              return lockedByTheKernel_kB() >= static_cast<long>(size / 1024) ? 0 : 3;
            }),
            0);
}

TEST(LockedMemory, OfAUserIsTheBuffersUpToTheLimit)
{
  EXPECT_EQ(
      inAChild([] {
        const std::vector<std::byte> first(size), second(size);
        const std::array<std::span<const std::byte>, 2> buffers{std::span(first),
                                                                std::span(second)};
        becomeAUser(size + 2 * 4096);  // the first, at any place in its pages
        const LockedMemory locked = lockMemory(buffers);
        if (locked.isWhole || locked.isComplete()) return 1;
        if (locked.bytes != size || locked.requested != 2 * size) return 2;
        const long kB = lockedByTheKernel_kB();
        return kB >= static_cast<long>(size / 1024) && kB <= static_cast<long>(size / 1024) + 8 ? 0
                                                                                                : 3;
      }),
      0);
}

TEST(LockedMemory, ThatIsRefusedIsExplained)
{
  EXPECT_EQ(inAChild([] {
              const std::vector<std::byte> buffer(size);
              const std::array<std::span<const std::byte>, 1> buffers{std::span(buffer)};
              becomeAUser(0);
              const LockedMemory locked = lockMemory(buffers);
              if (locked.bytes != 0 || locked.isComplete() || lockStack()) return 1;
              return noteOn(locked).find("the system allows 0.0 MB") != std::string::npos ? 0 : 2;
            }),
            0);
}

}  // namespace
}  // namespace perilymph::realtime

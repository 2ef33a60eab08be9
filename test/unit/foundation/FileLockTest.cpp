// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/FileLock.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <optional>

#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;

TEST(FileLock, IsHeldByOneAndLeavesNothing)
{
  const TemporaryFolder folder;
  const fs::path file = folder / "study.sqlite.lock";
  {
    const auto one = FileLock::take(file, "study.sqlite");
    ASSERT_TRUE(one) << one.error().message;
    const auto other = FileLock::take(file, "study.sqlite");
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().message,
              "study.sqlite is in use: another program works on it. Wait until it has ended.");
  }
  EXPECT_FALSE(fs::exists(file));
  EXPECT_TRUE(FileLock::take(file, "study.sqlite"));
}

TEST(FileLock, OfAKilledProgramIsFree)
{
  const TemporaryFolder folder;
  const fs::path file = folder / "lock";
  const pid_t child = ::fork();
  if (child == 0) {
    const auto lock = FileLock::take(file, "it");
    ::raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(fs::exists(file));  // it could not remove it
  EXPECT_TRUE(FileLock::take(file, "it"));
  EXPECT_FALSE(fs::exists(file));
}

TEST(FileLock, FollowsNoLink)
{
  const TemporaryFolder folder;
  std::ofstream(folder / "mine") << "kept";
  fs::create_symlink(folder / "mine", folder / "lock");
  EXPECT_FALSE(FileLock::take(folder / "lock", "it"));
  std::string text;
  std::ifstream(folder / "mine") >> text;
  EXPECT_EQ(text, "kept");
}

TEST(FileLock, KeepsOneProgramFromUndoingAnothers)
{
  // Each of four programs adds one to a number two hundred times.
  const TemporaryFolder folder;
  constexpr int programs = 4, times = 200;
  std::ofstream(folder / "number") << 0;
  for (int i = 0; i < programs; ++i)
    if (::fork() == 0) {
      for (int k = 0; k < times; ++k) {
        // on a busy machine one may come too late again and again, and is told so
        std::optional<Result<FileLock>> lock;
        for (int attempt = 0; attempt < 30 && !(lock && *lock); ++attempt)
          lock.emplace(FileLock::take(folder / "lock", "number"));
        if (!*lock) ::_exit(1);
        int number = 0;
        std::ifstream(folder / "number") >> number;
        std::ofstream(folder / "number") << number + 1;
      }
      ::_exit(0);
    }
  for (int i = 0; i < programs; ++i) {
    int status = 0;
    ::wait(&status);
    EXPECT_EQ(status, 0);
  }
  int number = 0;
  std::ifstream(folder / "number") >> number;
  EXPECT_EQ(number, programs * times);
}

}  // namespace
}  // namespace perilymph::test

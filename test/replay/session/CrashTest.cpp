// SPDX-License-Identifier: BSD-3-Clause

// The content of a recording after its program was killed.

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <new>
#include <vector>

#include "ShortRun.h"
#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/Replay.h"
#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::session {
namespace {

/// A number shared by two processes.
class SharedCount {
public:
  SharedCount()
  {
    void* page = ::mmap(nullptr, sizeof(std::atomic<std::uint64_t>), PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (page == MAP_FAILED) throw std::bad_alloc();
    count_ = new (page) std::atomic<std::uint64_t>(0);
  }
  ~SharedCount() { ::munmap(count_, sizeof *count_); }
  SharedCount(const SharedCount&) = delete;
  SharedCount& operator=(const SharedCount&) = delete;

  std::atomic<std::uint64_t>& operator*() { return *count_; }

private:
  std::atomic<std::uint64_t>* count_;
};

/// Within the first block, at the drain that fills it, and after two blocks.
class KilledInVirtualTime : public testing::TestWithParam<std::uint64_t> {};

TEST_P(KilledInVirtualTime, LosesLessThanOneDrain)
{
  const test::TemporaryFolder folder;
  const auto file = folder / "run.insertion";
  const std::uint64_t lastTick = GetParam();
  const pid_t child = ::fork();
  if (child == 0) {
    const auto insertion = test::shortRun(file, {{"stop_travel_mm", "6"}});
    static_cast<void>(insertion->runToEnd([lastTick](const haptics::TickRecord& record) {
      if (record.tick == lastTick) ::raise(SIGKILL);
      return true;
    }));
    ::_exit(1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));

  const auto recorded = RecordedInsertion::open(file);
  ASSERT_TRUE(recorded) << recorded.error().message;
  constexpr std::uint64_t drain = 20;  // ms, ticks of 1 ms
  EXPECT_GT(recorded->ticks() + drain, lastTick);
  EXPECT_FALSE(recorded->wasClosed());
  const auto verification = verify(file);
  ASSERT_TRUE(verification) << verification.error().message;
  EXPECT_TRUE(verification->isIdentical);
  EXPECT_EQ(verification->ticksCompared, recorded->ticks());
}

INSTANTIATE_TEST_SUITE_P(At, KilledInVirtualTime, testing::Values(333, 1025, 2600));

/// Result of a process that was killed during an insertion in real time.
struct Killed {
  std::uint64_t ran = 0;         ///< Ticks that had run.
  std::uint64_t seenInFile = 0;  ///< Ticks that another program had read from the file before.
  std::uint64_t kept = 0;        ///< Ticks in the file afterward.
  bool isIdentical = false;      ///< Those replay to the same bits.

  std::uint64_t lost() const { return ran > kept ? ran - kept : 0; }
};

Killed killInsertion(const std::filesystem::path& file, std::uint64_t atTick)
{
  SharedCount ticks;
  const pid_t child = ::fork();
  if (child == 0) {
    const auto insertion = test::shortRun(file, {{"stop_travel_mm", "10"}});
    if (!insertion->start()) ::_exit(1);
    haptics::Command arm;
    arm.kind = haptics::Command::Kind::arm;
    insertion->send(arm);
    insertion->device().move(device::ScriptedMotion::insert);
    while (true)
      if (insertion->refresh()) *ticks = insertion->latest().tick;
  }
  int status = 0;
  EXPECT_TRUE(
      test::waitUntil([&] { return *ticks >= atTick || ::waitpid(child, &status, WNOHANG) != 0; }));
  Killed killed;
  // A reader may see nothing during a drain; the ticks that it sees must be in the file later.
  if (const auto seen = RecordedInsertion::open(file)) killed.seenInFile = seen->ticks();
  ::kill(child, SIGKILL);
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
  killed.ran = *ticks + 1;

  const auto recorded = RecordedInsertion::open(file);
  EXPECT_TRUE(recorded) << recorded.error().message;
  killed.kept = recorded->ticks();
  const auto verification = verify(file);
  EXPECT_TRUE(verification) << verification.error().message;
  killed.isIdentical = verification->isIdentical;
  return killed;
}

TEST(KilledByTheClock, KeepsWhatHadBeenDrainedAndSaysWhatItLost)
{
  const test::TemporaryFolder folder;
  std::vector<std::uint64_t> lost;
  for (std::uint64_t attempt = 0; attempt < 9; ++attempt) {
    const Killed killed =
        killInsertion(folder / ("run" + std::to_string(attempt) + ".insertion"), 300 + 7 * attempt);
    EXPECT_GE(killed.kept, killed.seenInFile);
    EXPECT_GT(killed.kept, 0u);
    EXPECT_TRUE(killed.isIdentical);
    lost.push_back(killed.lost());
  }
  // The number depends on the scheduling of the recorder: measured, not bounded.
  std::sort(lost.begin(), lost.end());
  RecordProperty("median_lost_ms", static_cast<int>(lost[lost.size() / 2]));
  RecordProperty("max_lost_ms", static_cast<int>(lost.back()));
  std::printf("Killed %zu times at 1 kHz: median %llu ms lost, at most %llu ms.\n", lost.size(),
              static_cast<unsigned long long>(lost[lost.size() / 2]),
              static_cast<unsigned long long>(lost.back()));
}

}  // namespace
}  // namespace perilymph::session

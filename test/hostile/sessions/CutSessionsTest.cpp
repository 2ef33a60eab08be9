// SPDX-License-Identifier: BSD-3-Clause

// Recordings truncated at every 4 KiB, as by an interrupted copy or a damaged disk.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string>

#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/test/OddRecords.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t step = 4096;
constexpr std::uint64_t ticksPerDrain = 20;

/// Result of opening and reading a whole recording.
struct Reading {
  std::string refusal;  ///< Empty if every row was read.
  std::uint64_t ticks = 0;
  bool wasClosed = false;
};

Reading readAll(const fs::path& file)
{
  const auto opened = RecordedInsertion::open(file);
  if (!opened) return {opened.error().message, 0, false};
  Reading reading;
  reading.wasClosed = opened->wasClosed();
  const auto read = opened->forEach([&](const haptics::TickRecord& record) {
    EXPECT_EQ(record.tick, reading.ticks);
    ++reading.ticks;
    return true;
  });
  if (!read) reading.refusal = read.error().message;
  return reading;
}

fs::path closedRecording(const test::TemporaryFolder& folder)
{
  const fs::path file = folder / "whole.insertion";
  auto recording = Recording::create(file, test::someFacts());
  EXPECT_TRUE(recording);
  for (std::uint64_t drain = 0; drain < 20; ++drain) {
    std::vector<haptics::TickRecord> records;  // random: they cannot be packed small
    for (std::uint64_t i = 0; i < ticksPerDrain; ++i)
      records.push_back(test::oddRecord(ticksPerDrain * drain + i));
    EXPECT_TRUE((*recording)->append(records));
  }
  EXPECT_TRUE((*recording)->close());
  return file;
}

/// A recording whose program was killed after a number of drains.
fs::path crashedRecording(const test::TemporaryFolder& folder, std::uint64_t drains)
{
  const fs::path file = folder / "crashed.insertion";
  const pid_t child = ::fork();
  if (child == 0) {
    auto recording = Recording::create(file, test::someFacts());
    for (std::uint64_t i = 0; recording && i < drains; ++i)
      if (!(*recording)->append(test::quietRecords(ticksPerDrain * i, ticksPerDrain))) ::_exit(1);
    ::raise(SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
  return file;
}

/// A copy of a crashed recording in a separate folder, both files truncated to these sizes.
Reading readCut(const fs::path& crashed, std::uintmax_t bytes, std::uintmax_t logBytes)
{
  const test::TemporaryFolder folder;
  const fs::path copy = folder / "copy.insertion";
  fs::copy_file(crashed, copy);
  fs::copy_file(crashed.string() + "-wal", copy.string() + "-wal");
  fs::resize_file(copy, bytes);
  fs::resize_file(copy.string() + "-wal", logBytes);
  return readAll(copy);
}

TEST(ClosedRecordingCutAtEvery4KiB, IsRefusedInASentenceThatNamesIt)
{
  const test::TemporaryFolder folder;
  const fs::path file = closedRecording(folder);
  const auto size = fs::file_size(file);
  ASSERT_EQ(readAll(file).refusal, "");
  ASSERT_GT(size, 20 * step);
  for (std::uintmax_t bytes = (size - 1) / step * step; bytes > 0; bytes -= step) {
    fs::resize_file(file, bytes);
    const Reading reading = readAll(file);
    EXPECT_THAT(reading.refusal, testing::HasSubstr("whole.insertion is damaged (it is cut short)"))
        << bytes;
  }
  fs::resize_file(file, 0);
  EXPECT_THAT(readAll(file).refusal, testing::HasSubstr("not a recording"));
}

TEST(CrashedRecordingWithItsLogCutAtEvery4KiB, KeepsTheDrainsBeforeTheCut)
{
  const test::TemporaryFolder folder;
  constexpr std::uint64_t drains = 12;
  const fs::path file = crashedRecording(folder, drains);
  const auto size = fs::file_size(file);
  const auto logSize = fs::file_size(file.string() + "-wal");
  ASSERT_EQ(readCut(file, size, logSize).ticks, drains * ticksPerDrain);

  std::uint64_t before = 0;
  for (std::uintmax_t bytes = 0; bytes <= logSize; bytes += step) {
    const Reading reading = readCut(file, size, bytes);
    EXPECT_EQ(reading.refusal, "") << bytes;
    EXPECT_FALSE(reading.wasClosed) << bytes;
    EXPECT_EQ(reading.ticks % ticksPerDrain, 0u) << bytes;  // whole drains only
    EXPECT_GE(reading.ticks, before) << bytes;
    before = reading.ticks;
  }
  // Less than one drain is cut off: all other drains are kept.
  EXPECT_GE(before, (drains - 1) * ticksPerDrain);
}

TEST(CrashedRecordingCutAtEvery4KiB, IsRecoveredFromItsLogOrRefusedInASentence)
{
  const test::TemporaryFolder folder;
  const fs::path file = crashedRecording(folder, 12);
  const auto logSize = fs::file_size(file.string() + "-wal");
  for (std::uintmax_t bytes = 0; bytes < fs::file_size(file); bytes += step) {
    const Reading reading = readCut(file, bytes, logSize);
    if (reading.refusal.empty()) {
      EXPECT_EQ(reading.ticks % ticksPerDrain, 0u) << bytes;
    } else {
      EXPECT_THAT(reading.refusal, testing::HasSubstr("copy.insertion")) << bytes;
    }
  }
}

}  // namespace
}  // namespace perilymph::session

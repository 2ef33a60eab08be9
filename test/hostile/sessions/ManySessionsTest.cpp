// SPDX-License-Identifier: BSD-3-Clause

// A library after years of use: ten thousand recordings in one folder.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "perilymph/session/SessionLibrary.h"
#include "perilymph/test/OddRecords.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {
namespace {

namespace fs = std::filesystem;

constexpr int days = 100, recordingsOfADay = 100;
constexpr std::size_t all = days * recordingsOfADay;

/// Successive days; all months have 28.
std::string startOf(int day)
{
  const auto two = [](int number) { return std::to_string(100 + number).substr(1); };
  return "2010-" + two(1 + day / 28) + "-" + two(1 + day % 28) + "T09:30:00Z";
}

class TenThousandSessions : public testing::Test {
protected:
  /// One recording per day is real, the others are copies.
  void SetUp() override
  {
    for (int day = 0; day < days; ++day) {
      RecordingFacts facts = test::someFacts();
      facts.startedUtc = startOf(day);
      const fs::path first = folder / (std::to_string(day) + "-0.insertion");
      auto recording = Recording::create(first, facts);
      ASSERT_TRUE(recording) << recording.error().message;
      auto records = test::quietRecords(0, 20);
      for (haptics::TickRecord& each : records)  // an insertion, not a recording without one
        each.output.workflow = haptics::Workflow::inserting;
      ASSERT_TRUE((*recording)->append(records));
      ASSERT_TRUE((*recording)->close());
      for (int copy = 1; copy < recordingsOfADay; ++copy)
        fs::copy_file(first,
                      folder / (std::to_string(day) + "-" + std::to_string(copy) + ".insertion"));
    }
  }

  const test::TemporaryFolder folder;
};

TEST_F(TenThousandSessions, AreAllListedNewestFirstAndReadOnce)
{
  std::size_t told = 0;
  const auto listed = listSessions(folder.path(), {}, [&told](std::size_t, std::size_t of) {
    EXPECT_EQ(of, all);
    ++told;
  });
  ASSERT_TRUE(listed) << listed.error().message;
  ASSERT_EQ(listed->size(), all);
  EXPECT_EQ(told, all);
  EXPECT_TRUE(std::is_sorted(
      listed->begin(), listed->end(),
      [](const auto& one, const auto& other) { return one.startedUtc > other.startedUtc; }));
  for (const SessionSummary& session : *listed) {
    ASSERT_EQ(session.error, "") << session.file;
    ASSERT_EQ(session.highlights.ticks, 20u) << session.file;
  }

  // Opening one again would fail.
  for (const SessionSummary& session : *listed) {
    const auto time = fs::last_write_time(session.file);
    std::ofstream(session.file, std::ios::binary | std::ios::in) << std::string(100, 'x');
    fs::last_write_time(session.file, time);
  }
  const auto again = listSessions(folder.path());
  ASSERT_TRUE(again) << again.error().message;
  ASSERT_EQ(again->size(), all);
  EXPECT_THAT(*again, testing::Each(testing::Field(&SessionSummary::error, testing::IsEmpty())));
}

}  // namespace
}  // namespace perilymph::session

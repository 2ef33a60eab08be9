// SPDX-License-Identifier: BSD-3-Clause

// Recordings with cyclic or excessive page trees.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <cstdint>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stop_token>
#include <string>

#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/Replay.h"
#include "perilymph/session/SessionLibrary.h"
#include "perilymph/test/Forgery.h"
#include "perilymph/test/OddRecords.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t pageSize = 4096;

void put(std::string& bytes, std::size_t place, std::uint64_t number, int count)
{
  for (int i = 0; i < count; ++i)
    bytes[place + static_cast<std::size_t>(i)] = static_cast<char>(number >> (8 * (count - 1 - i)));
}

/// An inner page of a table's tree, all of whose children are the same page (SQLite file format,
/// section 1.6: type 5, then the cell pointers, the cells at the end).
std::string innerPage(std::uint32_t child)
{
  constexpr std::size_t cells = 500;
  std::string page(pageSize, '\0');
  page[0] = 5;
  put(page, 3, cells, 2);
  put(page, 5, pageSize - 5 * cells, 2);
  put(page, 8, child, 4);  // the rightmost
  for (std::size_t i = 0; i < cells; ++i) {
    const std::size_t place = pageSize - 5 * (i + 1);
    put(page, 12 + 2 * i, place, 2);
    put(page, place, child, 4);
    page[place + 4] = 100;  // greatest key below it (invalid)
  }
  return page;
}

std::uint32_t rootOf(const fs::path& file, const std::string& table)
{
  sqlite3* database = nullptr;
  sqlite3_open(file.c_str(), &database);
  sqlite3_stmt* row = nullptr;
  sqlite3_prepare_v2(database,
                     ("SELECT rootpage FROM sqlite_master WHERE name = '" + table + "'").c_str(),
                     -1, &row, nullptr);
  sqlite3_step(row);
  const auto root = static_cast<std::uint32_t>(sqlite3_column_int(row, 0));
  sqlite3_finalize(row);
  sqlite3_close(database);
  return root;
}

/// Puts six levels of 501 equal children above a table's page: 10^16 times its rows.
void multiply(const fs::path& file, const std::string& table)
{
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(std::istreambuf_iterator<char>(stream), {});
  const std::uint32_t root = rootOf(file, table);
  std::string leaf = bytes.substr((root - 1) * pageSize, pageSize);
  bytes += leaf;
  for (int level = 0; level < 5; ++level)
    bytes += innerPage(static_cast<std::uint32_t>(bytes.size() / pageSize));
  bytes.replace((root - 1) * pageSize, pageSize,
                innerPage(static_cast<std::uint32_t>(bytes.size() / pageSize)));
  put(bytes, 28, bytes.size() / pageSize, 4);
  std::ofstream(file, std::ios::binary) << bytes;
}

fs::path record(const fs::path& file)
{
  auto records = test::quietRecords(0, 3);
  for (haptics::TickRecord& each : records)  // an insertion, not a recording without one
    each.output.workflow = haptics::Workflow::inserting;
  records[1].commands.count = 1;
  records[1].commands.items[0].kind = haptics::Command::Kind::arm;
  auto recording = Recording::create(file, test::someFacts());
  EXPECT_TRUE(recording);
  EXPECT_TRUE((*recording)->append(records));
  EXPECT_TRUE((*recording)->close());
  return file;
}

/// Processor time of a call [s].
template <class Call>
double processorTime(const Call& call)
{
  const std::clock_t begin = std::clock();
  call();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

TEST(TreesWithoutEnd, AreRefusedSoon)
{
  for (const std::string table : {"block", "meta", "event"}) {
    const test::TemporaryFolder folder;
    const fs::path file = record(folder / "some.insertion");
    multiply(file, table);
    EXPECT_LT(
        processorTime([&] {
          const auto verified = verify(file);
          ASSERT_FALSE(verified) << table;
          EXPECT_THAT(verified.error().message, testing::HasSubstr("some.insertion is damaged"))
              << table;
          static_cast<void>(summarize(file));
        }),
        2.0)
        << table;
  }
}

TEST(TreesWithoutEnd, DoNotHideTheGoodRecordingsBesideThem)
{
  const test::TemporaryFolder folder;
  record(folder / "b.insertion");
  for (const std::string table : {"block", "meta", "event"})
    multiply(record(folder / ("a-" + table + ".insertion")), table);
  test::runSql(record(folder / "c.insertion"), "DROP TABLE block");
  record(folder / "z.insertion");
  const auto listed = listSessions(folder.path());
  ASSERT_TRUE(listed) << listed.error().message;
  std::size_t good = 0;
  for (const SessionSummary& session : *listed)
    if (session.error.empty()) ++good;
  EXPECT_EQ(listed->size(), 6u);
  // Ticks of a closed recording are not read for a list, so their tree is not checked there.
  EXPECT_EQ(good, 3u);
}

TEST(AStoppedReading, EndsAtOnceAndSaysSo)
{
  const test::TemporaryFolder folder;
  const fs::path file = folder / "some.insertion";
  auto recording = Recording::create(file, test::someFacts());
  ASSERT_TRUE(recording);
  ASSERT_TRUE((*recording)->append(test::quietRecords(0, 2000)));
  ASSERT_TRUE((*recording)->close());
  std::stop_source stop;
  const auto recorded = RecordedInsertion::open(file, stop.get_token());
  ASSERT_TRUE(recorded) << recorded.error().message;
  stop.request_stop();
  const auto read = recorded->forEach([](const haptics::TickRecord&) { return true; });
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, testing::HasSubstr("was stopped"));
}

}  // namespace
}  // namespace perilymph::session

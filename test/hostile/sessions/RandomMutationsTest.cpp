// SPDX-License-Identifier: BSD-3-Clause

// Ten thousand random mutations of a valid recording: none crashes the reader, blocks it or
// exhausts memory, and none with other content passes the check.

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/test/OddRecords.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {
namespace {

namespace fs = std::filesystem;

constexpr int mutations = 10'000;
constexpr std::size_t pageSize = 4096;

std::string contentOf(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Every value of every row with its type, read by SQLite itself, for comparison with recordings
/// that pass the check.
std::string dump(const fs::path& file)
{
  sqlite3* database = nullptr;
  sqlite3_open_v2(file.c_str(), &database, SQLITE_OPEN_READONLY, nullptr);
  std::string text;
  for (const char* sql :
       {"SELECT key, value FROM meta ORDER BY key", "SELECT * FROM block ORDER BY tick",
        "SELECT * FROM event ORDER BY rowid"}) {
    sqlite3_stmt* rows = nullptr;
    if (sqlite3_prepare_v2(database, sql, -1, &rows, nullptr) != SQLITE_OK) text += "unreadable";
    while (rows != nullptr && sqlite3_step(rows) == SQLITE_ROW)
      for (int column = 0; column < sqlite3_column_count(rows); ++column) {
        text += std::to_string(sqlite3_column_type(rows, column)) + ':';
        const void* bytes = sqlite3_column_blob(rows, column);
        text.append(static_cast<const char*>(bytes),
                    static_cast<std::size_t>(sqlite3_column_bytes(rows, column)));
      }
    sqlite3_finalize(rows);
  }
  sqlite3_close(database);
  return text;
}

using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t limit) { return random() % limit; }

void mutate(std::string& bytes, Random& random)
{
  const std::size_t pages = bytes.size() / pageSize;
  const auto page = [&] { return below(random, pages) * pageSize; };
  const std::size_t at = below(random, bytes.size());
  switch (random() % 9) {
    case 0:  // a bit
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << (random() % 8)));
      break;
    case 1:  // a byte
      bytes[at] = static_cast<char>(random());
      break;
    case 2:  // a number in the header of a page or the file
      bytes[page() + below(random, 12)] = static_cast<char>(random());
      break;
    case 3: {  // a page in place of another
      const std::size_t from = page();
      std::memmove(&bytes[page()], &bytes[from], pageSize);
      break;
    }
    case 4: {  // two pages exchanged
      const std::size_t one = page(), other = page();
      std::swap_ranges(bytes.begin() + static_cast<std::ptrdiff_t>(one),
                       bytes.begin() + static_cast<std::ptrdiff_t>(one + pageSize),
                       bytes.begin() + static_cast<std::ptrdiff_t>(other));
      break;
    }
    case 5:  // zeros, as after a disk error
      std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                  std::min<std::size_t>(1 + below(random, 600), bytes.size() - at), '\0');
      break;
    case 6: {  // noise
      const std::size_t length = std::min<std::size_t>(1 + below(random, 40), bytes.size() - at);
      for (std::size_t i = 0; i < length; ++i) bytes[at + i] = static_cast<char>(random());
      break;
    }
    case 7:  // truncated
      bytes.resize(std::max<std::size_t>(at, 1));
      break;
    default:  // a block is moved up or down
      bytes.insert(at, std::string(1 + below(random, 8), static_cast<char>(random())));
      bytes.resize(pages * pageSize);
      break;
  }
}

/// Opens, checks and reads a file completely; true if there is no error.
bool passesForWhole(const fs::path& file)
{
  const auto recorded = RecordedInsertion::open(file);
  if (!recorded) {
    EXPECT_FALSE(recorded.error().message.empty());
    return false;
  }
  const bool isRead = bool(recorded->forEach([](const haptics::TickRecord&) { return true; }));
  const auto check = recorded->check();
  return isRead && check && check->damage.empty() && recorded->wasClosed();
}

TEST(TenThousandMutations, NeitherHarmTheReaderNorPassForWhole)
{
  const test::TemporaryFolder folder;
  const fs::path good = folder / "good.insertion";
  {
    auto records = test::quietRecords(0, 150);
    for (std::size_t i = 0; i < records.size(); i += 10) {
      records[i].commands.count = 1;
      records[i].commands.items[0].kind = haptics::Command::Kind::arm;
      records[i].output.axialForce = 1e-3 * static_cast<double>(i);
    }
    auto recording = Recording::create(good, test::someFacts());
    ASSERT_TRUE(recording);
    ASSERT_TRUE((*recording)->append(records));
    ASSERT_TRUE((*recording)->close());
  }
  ASSERT_TRUE(passesForWhole(good));
  const std::string bytes = contentOf(good);
  const std::string content = dump(good);

  const fs::path file = folder / "mutated.insertion";
  int whole = 0;
  double longest_s = 0.0;
  for (int number = 0; number < mutations; ++number) {
    Random random(0x9e3779b97f4a7c15ull * (static_cast<unsigned long long>(number) + 1));
    std::string mutated = bytes;
    const int changes = random() % 4 == 0 ? 1 + static_cast<int>(random() % 8) : 1;
    for (int i = 0; i < changes && mutated.size() >= pageSize; ++i) mutate(mutated, random);
    std::ofstream(file, std::ios::binary) << mutated;

    const std::clock_t begin = std::clock();
    const bool passes = passesForWhole(file);
    longest_s = std::max(longest_s, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    if (!passes) continue;
    ++whole;
    ASSERT_TRUE(dump(file) == content) << "mutation " << number << " passes for whole";
  }
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  std::printf(
      "%d mutations: %d changed nothing that is read; at most %.3f s of processor time, "
      "%ld MB of memory.\n",
      mutations, whole, longest_s, usage.ru_maxrss / 1024);
  EXPECT_GT(whole, 0);  // unused bytes between rows
  EXPECT_LT(whole, mutations / 2);
#ifndef __SANITIZE_ADDRESS__
  EXPECT_LT(longest_s, 2.0);
  EXPECT_LT(usage.ru_maxrss, 500 * 1024);  // kB
#endif
}

}  // namespace
}  // namespace perilymph::session

// SPDX-License-Identifier: BSD-3-Clause
#include <sqlite3.h>

#include "Cli.h"

namespace perilymph::test {
namespace {

using testing::HasSubstr;

TEST(ReplayCommand, VerifiesAndWritesTheRowsOfTheRun)
{
  const TemporaryFolder folder;
  ASSERT_EQ(
      cli(shortSimulation({"--csv", folder / "run.csv", "--record", folder / "run.insertion"}))
          .status,
      0);
  const auto verified = cli({"replay", folder / "run.insertion", "--verify"});
  EXPECT_EQ(verified.status, 0) << verified.err;
  EXPECT_THAT(verified.out, HasSubstr("Replay verified"));

  const auto shown = cli({"replay", folder / "run.insertion", "--csv", folder / "again.csv"});
  EXPECT_EQ(shown.status, 0) << shown.err;
  EXPECT_THAT(shown.out, HasSubstr("contour-published"));
  EXPECT_EQ(contentOf(folder / "run.csv"), contentOf(folder / "again.csv"));
}

TEST(ReplayCommand, SaysWhatIsWrongWithTheFile)
{
  const TemporaryFolder folder;
  expectRefusal(cli({"replay", folder / "none.insertion"}), "does not exist");
  expectRefusal(cli({"replay", folder.path()}), "is a folder");
  std::ofstream(folder / "text.insertion") << "not a database";
  expectRefusal(cli({"replay", folder / "text.insertion", "--verify"}), "not a recording");

  ASSERT_EQ(cli(shortSimulation({"--record", folder / "cut.insertion"})).status, 0);
  std::filesystem::resize_file(folder / "cut.insertion",
                               std::filesystem::file_size(folder / "cut.insertion") / 2);
  expectRefusal(cli({"replay", folder / "cut.insertion", "--csv", folder / "cut.csv"}), "damaged");
  EXPECT_FALSE(std::filesystem::exists(folder / "cut.csv"));
}

TEST(ReplayCommand, EscapesControlSequences)
{
  const TemporaryFolder folder;
  const std::string file = folder / "foreign.insertion";
  ASSERT_EQ(cli(shortSimulation({"--record", file})).status, 0);
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  // clears the screen, rings the bell, starts a new line, and contains Greek letters
  const char* sql =
      "UPDATE meta SET value = char(27) || '[2J' || char(7, 10, 155) || 'Δοκιμή' WHERE key = "
      "'scenario_name'";
  EXPECT_EQ(sqlite3_exec(database, sql, nullptr, nullptr, nullptr), SQLITE_OK);
  EXPECT_EQ(sqlite3_changes(database), 1);
  sqlite3_close(database);

  const auto shown = cli({"replay", file});
  EXPECT_EQ(shown.status, 0) << shown.err;
  EXPECT_THAT(shown.out, HasSubstr("\\x1b[2J\\x07\\x0a\\xc2\\x9bΔοκιμή, recorded"));
  for (const char byte : shown.out)
    EXPECT_TRUE(byte == '\n' || static_cast<unsigned char>(byte) >= 0x20);
}

}  // namespace
}  // namespace perilymph::test

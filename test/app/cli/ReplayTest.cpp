// SPDX-License-Identifier: BSD-3-Clause
#include <sqlite3.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "perilymph/test/Cli.h"

namespace perilymph::test {
namespace {

using testing::HasSubstr;
using testing::Not;

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

TEST(ReplayCommand, WritesTheSameRowsForSql)
{
  const TemporaryFolder folder;
  const std::string file = folder / "run.insertion", table = folder / "run.sqlite";
  ASSERT_EQ(cli(shortSimulation({"--csv", folder / "run.csv", "--record", file})).status, 0);
  const auto written = cli({"replay", file, "--sqlite", table});
  ASSERT_EQ(written.status, 0) << written.err;
  const auto lines = linesOf(folder / "run.csv");

  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open_v2(table.c_str(), &database, SQLITE_OPEN_READONLY, nullptr), SQLITE_OK);
  sqlite3_stmt* rows = nullptr;
  ASSERT_EQ(sqlite3_prepare_v2(database, "SELECT * FROM tick ORDER BY tick", -1, &rows, nullptr),
            SQLITE_OK);
  std::string names;
  for (int column = 1; column < sqlite3_column_count(rows); ++column)
    names += (names.empty() ? "" : ",") + std::string(sqlite3_column_name(rows, column));
  EXPECT_EQ(names, lines.at(0));
  std::size_t count = 0;
  while (sqlite3_step(rows) == SQLITE_ROW) {
    ASSERT_LT(++count, lines.size());
    std::istringstream cells(lines[count]);
    for (int column = 1; column < sqlite3_column_count(rows); ++column) {
      std::string cell;
      std::getline(cells, cell, ',');
      if (cell.empty())
        EXPECT_EQ(sqlite3_column_type(rows, column), SQLITE_NULL) << count << ' ' << column;
      else
        EXPECT_EQ(sqlite3_column_double(rows, column), std::stod(cell)) << count << ' ' << column;
    }
  }
  EXPECT_EQ(count + 1, lines.size());
  sqlite3_finalize(rows);
  sqlite3_close(database);
}

TEST(ReplayCommand, WritesTheContactsAtTheMaximumDepth)
{
  const TemporaryFolder folder;
  const auto simulated =
      cli(shortSimulation({"--set", "stop_travel_mm=8", "--record", folder / "run.insertion",
                           "--json", folder / "run.json"}));
  ASSERT_EQ(simulated.status, 0) << simulated.err;
  const auto written =
      cli({"replay", folder / "run.insertion", "--contacts", folder / "contacts.csv"});
  ASSERT_EQ(written.status, 0) << written.err;
  const auto rows = linesOf(folder / "contacts.csv");
  ASSERT_EQ(rows.size(), 23u);  // 22 contacts
  EXPECT_EQ(rows[0].substr(0, 29), "array,contact,draws,angle_deg");
  EXPECT_EQ(rows[1].substr(0, 12), "contour,1,1,");
  // the angle of the most apical contact, which the simulation states, too
  const auto json = nlohmann::json::parse(contentOf(folder / "run.json"));
  EXPECT_NEAR(std::stod(rows[1].substr(12)), json["angular_insertion_depth_deg"].get<double>(),
              0.05);
}

TEST(ReplayCommand, DrawsAThumbnailOfItsSizeAndWithoutThePatient)
{
  const TemporaryFolder folder;
  ASSERT_EQ(
      cli(shortSimulation({"--set", "stop_travel_mm=8", "--record", folder / "run.insertion"}))
          .status,
      0);
  // file managers ask for a name without an extension
  const auto drawn =
      cli({"replay", folder / "run.insertion", "--thumbnail", folder / "thumb", "--size", "128"});
  ASSERT_EQ(drawn.status, 0) << drawn.err;
  const std::string picture = contentOf(folder / "thumb");
  ASSERT_GT(picture.size(), 33u);
  EXPECT_EQ(picture.substr(1, 3), "PNG");
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value = value << 8 | static_cast<std::uint8_t>(picture[at + i]);
    return value;
  };
  EXPECT_EQ(number(16), 128u);
  EXPECT_EQ(number(20), 128u);
  expectUsageError(cli({"replay", folder / "run.insertion", "--size", "128"}), "--thumbnail");
  expectUsageError(
      cli({"replay", folder / "run.insertion", "--thumbnail", folder / "t", "--size", "5"}),
      "size");
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

/// A peak of ten times the force, as anybody who can write SQL makes it.
TEST(ReplayCommand, AndCompareSayThatARecordingWasChanged)
{
  const TemporaryFolder folder;
  const std::string whole = folder / "whole.insertion", changed = folder / "changed.insertion";
  ASSERT_EQ(cli(shortSimulation({"--record", whole})).status, 0);
  EXPECT_EQ(cli({"replay", whole}).err, "");
  for (const char* sql :
       {"UPDATE block SET ticks = ticks - 1", "UPDATE event SET tick = 5 WHERE rowid = 1",
        "UPDATE meta SET value = 'Contour' WHERE key = 'scenario_name'"}) {
    SCOPED_TRACE(sql);
    std::filesystem::copy_file(whole, changed, std::filesystem::copy_options::overwrite_existing);
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(changed.c_str(), &database), SQLITE_OK);
    ASSERT_EQ(sqlite3_exec(database, sql, nullptr, nullptr, nullptr), SQLITE_OK);
    sqlite3_close(database);
    const std::string csv = folder / "changed.csv";
    const auto shown = cli({"replay", changed, "--csv", csv});
    EXPECT_EQ(shown.status, 1);
    if (shown.err.find("is damaged") != std::string::npos) continue;  // a row that cannot be read
    EXPECT_THAT(shown.err, HasSubstr("changed.insertion was changed after it was recorded: "));
    EXPECT_THAT(shown.out, HasSubstr("peak force"));
    EXPECT_GT(contentOf(csv).size(), 1000u);
    EXPECT_EQ(std::count(shown.err.begin(), shown.err.end(), '\n'), 1);
    const auto compared = cli({"compare", whole, changed, "--out", folder / "out"});
    EXPECT_EQ(compared.status, 0);
    EXPECT_THAT(compared.err, HasSubstr("changed.insertion was changed after it was recorded: "));
    EXPECT_THAT(compared.err, Not(HasSubstr("whole.insertion")));
    EXPECT_THAT(compared.out, HasSubstr("changed (changed by hand)"));
    const std::string table = contentOf(folder / "out/comparison.csv");
    EXPECT_THAT(table, HasSubstr("changed (changed by hand),"));
    EXPECT_THAT(table, HasSubstr("whole,"));
  }
}

/// Every output of a recording whose second block is damaged holds the ticks of the first.
TEST(ReplayCommand, ExportsWhatIsBeforeADamagedBlock)
{
  const TemporaryFolder folder;
  const std::string file = folder / "damaged.insertion";
  // 4 mm at 2 mm/s: 2000 time steps, in two blocks
  ASSERT_EQ(cli({"simulate", "--scenario", "contour-published", "--nodes", "30", "--set",
                 "stop_travel_mm=4.0", "--record", file})
                .status,
            0);
  const std::string all = folder / "all.csv";
  ASSERT_EQ(cli({"replay", file, "--csv", all}).status, 0);
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  const char* sql =
      "UPDATE block SET packed = zeroblob(length(packed)) WHERE tick = (SELECT tick FROM block "
      "ORDER "
      "BY tick LIMIT 1 OFFSET 1)";
  ASSERT_EQ(sqlite3_exec(database, sql, nullptr, nullptr, nullptr), SQLITE_OK);
  ASSERT_EQ(sqlite3_changes(database), 1) << "the recording has one block";
  sqlite3_close(database);

  const std::string csv = folder / "part.csv", table = folder / "part.sqlite";
  const auto outcome = cli({"replay", file, "--csv", csv, "--sqlite", table});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("damaged.insertion is damaged (the block of tick 1024"));
  EXPECT_THAT(outcome.err, HasSubstr("The 1024 samples up to tick 1023 can be read and were used; "
                                     "those after it are lost."));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
  const std::string part = contentOf(csv);
  EXPECT_EQ(std::count(part.begin(), part.end(), '\n'), 1 + 1024);
  EXPECT_TRUE(contentOf(all).starts_with(part));
  ASSERT_EQ(sqlite3_open(table.c_str(), &database), SQLITE_OK);
  std::string count;
  const auto keep = [](void* to, int, char** values, char**) {
    return *static_cast<std::string*>(to) = values[0], 0;
  };
  sqlite3_exec(database, "SELECT COUNT(*) FROM tick", keep, &count, nullptr);
  EXPECT_EQ(count, "1024");
  sqlite3_close(database);
  EXPECT_EQ(cli({"replay", file, "--verify"}).status, 1);
}

TEST(ReplayCommand, WritesATableIntoNothingButAFile)
{
  const TemporaryFolder folder;
  const std::string file = folder / "run.insertion", pipe = folder / "pipe";
  ASSERT_EQ(cli(shortSimulation({"--record", file})).status, 0);
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);  // without a reader: opening it would wait for ever
  expectRefusal(cli({"replay", file, "--sqlite", pipe}), "is not a file");
  expectRefusal(cli({"replay", file, "--sqlite", "/dev/full"}), "is not a file");
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
  EXPECT_EQ(shown.status, 1) << "it was changed";
  EXPECT_THAT(shown.out, HasSubstr("\\x1b[2J\\x07\\x0a\\xc2\\x9bΔοκιμή, recorded"));
  for (const char byte : shown.out)
    EXPECT_TRUE(byte == '\n' || static_cast<unsigned char>(byte) >= 0x20);
}

}  // namespace
}  // namespace perilymph::test

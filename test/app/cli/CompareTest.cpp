// SPDX-License-Identifier: BSD-3-Clause
#include <iomanip>
#include <sstream>

#include "perilymph/test/Cli.h"

namespace perilymph::test {
namespace {

TEST(Compare, SetsRecordingsSideBySide)
{
  const TemporaryFolder folder;
  ASSERT_EQ(cli(shortSimulation({"--record", folder / "a.insertion"})).status, 0);
  ASSERT_EQ(
      cli(shortSimulation({"--set", "stop_travel_mm=0.8", "--record", folder / "b.insertion"}))
          .status,
      0);
  const auto outcome =
      cli({"compare", folder / "a.insertion", folder / "b.insertion", "--out", folder / "out"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto table = linesOf(folder / "out" / "comparison.csv");
  ASSERT_EQ(table.size(), 3u);
  EXPECT_EQ(table[0].substr(0, 28), "name,scenario,peak_N,peak_tr");
  EXPECT_EQ(table[1].substr(0, 2), "a,");
  // the text in millinewtons, the table in newtons
  std::istringstream firstRow(table[1]);
  std::string name, scenario, peak_N;
  std::getline(std::getline(std::getline(firstRow, name, ','), scenario, ','), peak_N, ',');
  EXPECT_THAT(outcome.out, testing::HasSubstr("peak, mN"));
  std::ostringstream peak_mN;
  peak_mN << std::fixed << std::setprecision(1) << 1e3 * std::stod(peak_N);
  EXPECT_THAT(outcome.out, testing::HasSubstr(" " + peak_mN.str() + " "));
  const auto curves = linesOf(folder / "out" / "curves.csv");
  EXPECT_EQ(curves[0], "travel_mm,a_N,b_N");
  EXPECT_EQ(curves.size(),
            10u);  // 0 to 0.8 mm; the column of the shorter one ends with empty fields
  EXPECT_EQ(curves[9].substr(0, 5), "0.8,,");
  EXPECT_TRUE(std::filesystem::exists(folder / "out" / "curves.svg"));
}

TEST(Compare, GroupsByFrictionAndSpeedAndWarnsOfOneThatMixesThem)
{
  const TemporaryFolder folder;
  std::vector<std::string> call = {"compare"};
  int number = 0;
  for (const char* speed : {"speed_mm_s=1.0", "speed_mm_s=2.0"}) {
    const std::string file = folder / (std::to_string(++number) + ".insertion");
    ASSERT_EQ(cli(shortSimulation({"--set", speed, "friction=tissue", "--record", file})).status,
              0);
    call.push_back(file);
  }
  const auto grouped = [&](std::vector<std::string> more) {
    auto arguments = call;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return cli(arguments);
  };
  const auto mixed = grouped({"--group", "friction", "--out", folder / "mixed"});
  ASSERT_EQ(mixed.status, 0) << mixed.err;
  EXPECT_THAT(mixed.out, testing::HasSubstr("mixes insertions that differ in set speed"));
  const auto divided = grouped({"--group", "friction", "speed", "--out", folder / "divided"});
  ASSERT_EQ(divided.status, 0) << divided.err;
  EXPECT_THAT(divided.out, testing::Not(testing::HasSubstr("mixes")));
  EXPECT_THAT(divided.out, testing::HasSubstr("(tissue) · 1 mm/s: n = 1"));
  EXPECT_TRUE(std::filesystem::exists(folder / "divided" / "comparison-dictionary.csv"));
}

TEST(Compare, SaysWhatCannotBeRead)
{
  const TemporaryFolder folder;
  expectRefusal(cli({"compare", folder / "no.insertion", "--out", folder / "out"}), "no.insertion");
  expectUsageError(cli({"compare", folder / "no.insertion"}), "--out");
  expectUsageError(cli({"compare", "--out", folder / "out"}), "files");
  EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{});
}

TEST(Predict, SaysWhatIsWrongWithTheCall)
{
  const TemporaryFolder folder;
  expectRefusal(cli({"predict", "--array", "spaghetti", "--out", folder / "out"}), "flex28");
  expectUsageError(cli({"predict", "--out", folder / "out"}), "--array");
  expectUsageError(cli({"predict", "--array", "flex28"}), "--out");
  expectUsageError(cli({"predict", "--array", "flex28", "--all", "--out", folder / "out"}),
                   "--all");
  expectUsageError(
      cli({"predict", "--array", "flex28", "--seed", "1", "2", "--out", folder / "out"}), "--seed");
  expectUsageError(
      cli({"predict", "--array", "flex28", "--friction", "paper", "--out", folder / "out"}),
      "--all");
  expectRefusal(cli({"predict", "--all", "--friction", "ice", "--out", folder / "out"}), "tissue");
  EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{});
}

}  // namespace
}  // namespace perilymph::test

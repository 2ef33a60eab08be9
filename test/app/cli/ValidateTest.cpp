// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <regex>

#include "perilymph/test/Cli.h"

namespace perilymph::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A short validation.
std::vector<std::string> shortValidation(const std::string& out, std::vector<std::string> more = {})
{
  std::vector<std::string> arguments = {"validate", "--runs", "2",     "--set", "nodes=20",
                                        "--jobs",   "2",      "--out", out};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(Validate, WritesTablesNumbersAndThreeFigures)
{
  const TemporaryFolder folder;
  const auto outcome = cli(shortValidation(folder / "deep" / "out"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("force at 10.6 mm"));
  EXPECT_THAT(outcome.out, HasSubstr("of the variance"));
  // as reported for 10.6 mm: 18.6 mN in 11 insertions, of the mean 5.6, and that of two simulated ones
  std::smatch reported;
  ASSERT_TRUE(std::regex_search(outcome.out, reported, std::regex("[(]88[.]0 ± ([0-9.]+) mN[)]")));
  EXPECT_GE(std::stod(reported[1]), 1.96 * 18.6 / std::sqrt(11.0));
  EXPECT_LT(std::stod(reported[1]), 18.6);
  for (const char* newtons : {" N ", " N,", " N;", " N)", " N\n"})
    EXPECT_THAT(outcome.out, Not(HasSubstr(newtons)));
  for (const char* name : {"profile.csv", "difference.csv", "summary.json", "experiment.svg",
                           "simulation.svg", "difference.svg"})
    EXPECT_TRUE(std::filesystem::exists(folder / "deep" / "out" / name)) << name;

  const auto profile = linesOf(folder / "deep" / "out" / "profile.csv");
  EXPECT_EQ(profile.size(), 167u);
  EXPECT_EQ(profile[0], "travel_mm,mean_N,sd_N,sem_N,ci95_low_N,ci95_high_N");
  EXPECT_EQ(profile[1].substr(0, 2), "0,");
  EXPECT_EQ(profile[166].substr(0, 5), "16.5,");
  const auto difference = linesOf(folder / "deep" / "out" / "difference.csv");
  EXPECT_EQ(difference.size(), 5u);  // where the experiment is known
  EXPECT_EQ(difference[0], profile[0]);
  const auto summary = nlohmann::json::parse(contentOf(folder / "deep" / "out" / "summary.json"));
  EXPECT_EQ(summary["runs"], 2);
  EXPECT_EQ(summary["seed"], 1);
  EXPECT_EQ(summary["anchors"].size(), 4u);
}

TEST(Validate, SaysWhatIsWrongWithTheCall)
{
  const TemporaryFolder folder;
  expectUsageError(cli({"validate"}), "--out");
  expectUsageError(cli({"validate", "--runs", "1", "--out", folder / "a"}), "--runs");
  expectUsageError(cli({"validate", "--jobs", "0", "--out", folder / "a"}), "--jobs");
  expectUsageError(cli({"validate", "--seed", "-1", "--out", folder / "a"}), "--seed");
  for (const char* other : {"--seed", "--runs", "--jobs"})
    expectUsageError(
        cli({"validate", "--bench", "slim-straight", other, "2", "--out", folder / "a"}), other);
  expectRefusal(cli({"validate", "--bench", folder / "none", "--out", folder / "a"}),
                "There are no bench curves in");
  expectRefusal(cli(shortValidation(folder / "a", {"--variability", "nowhere"})),
                "published-experiment");
  expectRefusal(cli(shortValidation(folder / "a", {"--set", "nodes=3"})), "between 8 and 1024");
  EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{});
}

TEST(Validate, SaysWhereItCannotWriteBeforeItRuns)
{
  const TemporaryFolder folder;
  std::ofstream(folder / "file") << "there";
  expectRefusal(cli(shortValidation(folder / "file")), "is a file");
  expectRefusal(cli(shortValidation("/proc/validation")), "/proc");
}

TEST(InterruptedValidation, LeavesNothing)
{
  const TemporaryFolder folder;
  ChildProcess child(cliCall({"validate", "--runs", "100000", "--out", folder / "out"}));
  ASSERT_TRUE(child.waitForOutput("Simulating", std::chrono::minutes(1)));
  child.send(SIGINT);
  const auto outcome = child.wait(std::chrono::minutes(1));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("Interrupted; nothing was written."));
  EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{});
}

}  // namespace
}  // namespace perilymph::test

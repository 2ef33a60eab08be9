// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/Cli.h"

namespace perilymph::test {
namespace {

TEST(CommandLine, ExplainsItself)
{
  const auto help = cli({"--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* command :
       {"simulate", "anatomy", "replay", "render", "devices", "ct", "archive"}) {
    EXPECT_THAT(help.out, testing::HasSubstr(command));
    EXPECT_EQ(cli({command, "--help"}).status, 0) << command;
  }
  EXPECT_EQ(cli({"--version"}).status, 0);
}

TEST(CommandLine, PrintsTheDefaultOfEveryOptionThatHasOne)
{
  const auto help = [](const char* command) { return cli({command, "--help"}).out; };
  // CLI11 2.3 prints "=200", 2.4 "[200]".
  const auto hasDefault = [](const std::string& value) {
    return testing::AnyOf(testing::HasSubstr("=" + value), testing::HasSubstr("[" + value + "]"));
  };
  EXPECT_THAT(help("validate"), hasDefault("200"));
  EXPECT_THAT(help("validate"), hasDefault("number of cores"));
  EXPECT_THAT(help("validate"), hasDefault("published-experiment"));
  EXPECT_THAT(help("calibrate"), hasDefault("24"));
  EXPECT_THAT(help("predict"), hasDefault("50, with --all 12"));
  EXPECT_THAT(help("simulate"), hasDefault("0"));
  EXPECT_THAT(help("render"), hasDefault("surgeon"));
  EXPECT_THAT(help("anatomy"), hasDefault("scala"));
}

TEST(CommandLine, KnowsItsCommands)
{
  expectUsageError(cli({}), "subcommand");
  expectUsageError(cli({"banana"}), "no command 'banana'");
  expectUsageError(cli({"simulate"}), "--scenario");
  expectUsageError(cli({"simulate", "--scenario"}), "--scenario");
  expectUsageError(cli({"replay"}), "file");
  expectUsageError(cli({"anatomy"}), "--preset");
  expectUsageError(cli({"render", "--out", "x.png"}), "--scenario");
  expectUsageError(cli(shortSimulation({"--banana"})), "--banana");
  expectUsageError(cli(shortSimulation({"--every-ms", "5"})), "--csv");
  expectUsageError(cli(shortSimulation({"--set", "speed_mm_s"})), "key=value");
  expectUsageError(cli({"anatomy", "--preset", "banana"}), "banana");
  expectUsageError(cli({"anatomy", "--preset", "published", "--patient", "small"}), "1 option");
  expectUsageError(cli({"anatomy", "--st-length-mm", "33"}), "--rw-");
  expectUsageError(
      cli({"anatomy", "--st-length-mm", "long", "--rw-width-mm", "2", "--rw-height-mm", "2"}),
      "long");
}

/// The message begins with the option and describes the error.
void expectEmpty(const ProgramOutcome& outcome, const std::string& option)
{
  EXPECT_EQ(outcome.status, 2) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, testing::StartsWith(option + " is empty"));
}

TEST(EmptyValue, OfEveryOptionIsRefusedAndTheOptionNamed)
{
  const std::vector<std::string> simulate = {"simulate", "--scenario", "contour-published"};
  const auto with = [](std::vector<std::string> call, const std::string& option) {
    call.push_back(option);
    call.emplace_back("");
    return call;
  };
  for (const char* option : {"--patient", "--array", "--model", "--nodes", "--seed", "--csv",
                             "--every-ms", "--json", "--record", "--set"})
    expectEmpty(cli(with(simulate, option)), std::string(option));
  expectEmpty(cli({"simulate", "--scenario", ""}), "--scenario");
  for (const char* option : {"--preset", "--patient", "--import", "--sample", "--st-length-mm"})
    expectEmpty(cli({"anatomy", option, ""}), std::string(option));
  for (const char* option : {"--json", "--sections", "--surface", "--haptic-surface", "--h-mm"})
    expectEmpty(cli(with({"anatomy", "--preset", "published"}, option)), std::string(option));
  for (const char* option : {"--json", "--test", "--replay", "--plugin", "--capture"})
    expectEmpty(cli({"devices", option, ""}), std::string(option));
  for (const char* option : {"--scenario", "--patient", "--preset", "--array", "--out", "--view"})
    expectEmpty(cli({"render", option, ""}), std::string(option));
  for (const char* command : {"validate", "calibrate"})
    for (const char* option : {"--variability", "--out", "--runs", "--jobs", "--set"})
      expectEmpty(cli({command, option, ""}), std::string(option));
  for (const char* option :
       {"--series", "--at", "--landmarks", "--side", "--json", "--patient", "--surface"})
    expectEmpty(cli({"ct", "measure", "x", option, ""}), std::string(option));
  expectEmpty(cli({"ct", "info", ""}), "path");
  expectEmpty(cli({"predict", "--array", "flex28", "", "--out", "x"}), "--array");
  expectEmpty(cli({"replay", ""}), "file");
  expectEmpty(cli({"replay", "x.insertion", "--csv", ""}), "--csv");
  expectEmpty(cli({"compare", "a.insertion", "", "--out", "x"}), "files");
}

TEST(EmptyValue, BehindAnEqualsSignDoesNotTakeTheNextWord)
{
  expectEmpty(cli(shortSimulation({"--patient=", "--json", "x.json"})), "--patient");
  expectEmpty(cli({"replay", "--csv=", "x.insertion"}), "--csv");
}

TEST(EmptyValue, OfASettingIsRefused)
{
  for (const char* setting : {"patient=", "array=", "friction=", "anatomy=", "calibration="})
    expectEmpty(cli(shortSimulation({"--set", setting})), std::string("--set ") + setting);
  // two quotation marks are an empty text
  EXPECT_EQ(cli(shortSimulation({"--set", "calibration=\"\""})).status, 0);
}

}  // namespace
}  // namespace perilymph::test

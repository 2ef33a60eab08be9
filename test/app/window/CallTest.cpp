// SPDX-License-Identifier: BSD-3-Clause

// Command line of the workstation: exit status and error messages.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QImage>
#include <algorithm>
#include <fstream>
#include <iterator>

#include "perilymph/test/ChildProcess.h"
#include "perilymph/test/Places.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

using ::testing::HasSubstr;

using Environment = std::vector<std::pair<std::string, std::optional<std::string>>>;

ProgramOutcome perilymph(std::vector<std::string> arguments, const Environment& environment = {})
{
  ProgramCall call;
  call.program = programFolder() / "perilymph";
  call.arguments = std::move(arguments);
  call.environment = environment;
  return run(call);
}

/// The call fails with status 1 and one line on standard error.
void expectRefused(const ProgramOutcome& outcome, const std::string& because)
{
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr(because));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

std::string readAll(const std::filesystem::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(PerilymphCall, AScreenshotHasTheSizeOfTheWindow)
{
  const TemporaryFolder folder;
  const auto file = folder / "window.png";
  const auto outcome = perilymph({"--demo", "--screenshot", file.string(), "--after", "0.5"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("first frame after "));
  const QImage picture(QString::fromStdString(file.string()));
  EXPECT_EQ(picture.size(), QSize(1280, 800));
}

TEST(PerilymphCall, AScreenshotIntoAMissingFolderIsRefused)
{
  const auto outcome = perilymph({"--screenshot", "/no/such/folder/window.png", "--after", "0"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("/no/such/folder"));
}

TEST(PerilymphCall, MeasuredFramesAreReportedAtTheEndOfTheDemonstration)
{
  const TemporaryFolder folder;
  const auto scenario = folder / "short.toml";
  std::ofstream(scenario) << "anatomy = \"published\"\narray = \"contour\"\n"
                             "stop_travel_mm = 1.0\nspeed_mm_s = 2.0\n";
  const auto outcome = perilymph({"--scenario", scenario.string(), "--measure-frames"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, ::testing::ContainsRegex(
                               "frame time median [0-9.]+ ms, p95 [0-9.]+ ms, [0-9.]+ frames/s"));
}

TEST(PerilymphCall, TheLastInsertionIsComparedWithTheFirstAfterTheGivenTicks)
{
  const TemporaryFolder folder;
  const auto scenario = folder / "short.toml";
  std::ofstream(scenario) << "anatomy = \"published\"\narray = \"contour\"\n"
                             "stop_travel_mm = 12.0\nspeed_mm_s = 2\n";
  const auto outcome =
      perilymph({"--scenario", scenario.string(), "--measure-frames", "--ticks", "2000"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, ::testing::ContainsRegex("after [0-9]+ ticks: frame time median"));
  EXPECT_THAT(outcome.out,
              ::testing::ContainsRegex("median frame time [+-][0-9.]+ % against the first"));
  EXPECT_THAT(outcome.out, ::testing::ContainsRegex("ticks [0-9]+, late by more than a period "
                                                    "[0-9]+ .* real-time priority"));
}

TEST(PerilymphCall, AMissingScenarioIsNamed)
{
  expectRefused(perilymph({"--scenario", "no-such-scenario"}), "no-such-scenario");
}

TEST(PerilymphCall, AMissingFileToOpenIsNamed)
{
  const ProgramOutcome outcome = perilymph({"/no/such/P-017.insertion"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err,
              HasSubstr("/no/such/P-017.insertion does not exist, so it cannot be opened"));
}

TEST(PerilymphCall, WithoutADisplayItSaysWhatToDo)
{
  expectRefused(perilymph({"--demo"}, {{"DISPLAY", std::nullopt}}), "DISPLAY is not set");
}

TEST(PerilymphCall, ADisplayThatDoesNotAnswerIsNamed)
{
  expectRefused(perilymph({"--demo"}, {{"DISPLAY", ":987"}}), "The display :987 cannot be reached");
}

TEST(PerilymphCall, APlatformThatCannotDrawIsNamed)
{
  expectRefused(perilymph({"--demo"}, {{"QT_QPA_PLATFORM", "minimal"}}),
                "QT_QPA_PLATFORM is minimal");
}

TEST(PerilymphCall, AnOldOpenGlIsRefusedBeforeAnythingIsDrawn)
{
  expectRefused(perilymph({"--demo"}, {{"MESA_GL_VERSION_OVERRIDE", "2.1"}}), "OpenGL");
}

TEST(PerilymphCall, ADisplayWithoutOpenGlIsRefusedBeforeAnythingIsDrawn)
{
  ProgramCall call;
  call.program = withDisplay();
  call.arguments = {programFolder() / "perilymph", "--demo"};
  call.environment = {{"PERILYMPH_DISPLAY_OPTIONS", "-extension GLX"}};
  expectRefused(run(call), "GLX extension is missing");
}

TEST(PerilymphCall, AnExistingRecordingIsNotOverwritten)
{
  const TemporaryFolder folder;
  const auto file = folder / "kept.insertion";
  std::ofstream(file) << "precious";
  const auto outcome = perilymph({"--demo", "--record", file.string()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("kept.insertion"));
  EXPECT_EQ(readAll(file), "precious");
}

TEST(PerilymphCall, HelpAndVersionNeedNoDisplay)
{
  const auto help = perilymph({"--help"}, {{"DISPLAY", std::nullopt}});
  EXPECT_EQ(help.status, 0);
  for (const char* word : {"--scenario", "--demo", "--record", "--screenshot", "--after",
                           "--measure-frames", "--version"})
    EXPECT_THAT(help.out, HasSubstr(word));
  const auto version = perilymph({"--version"}, {{"DISPLAY", std::nullopt}});
  EXPECT_EQ(version.status, 0);
  EXPECT_THAT(version.out, HasSubstr("perilymph "));
}

class UsageErrors : public ::testing::TestWithParam<std::vector<std::string>> {};

TEST_P(UsageErrors, EndWithStatusTwo)
{
  const auto outcome = perilymph(GetParam());
  EXPECT_EQ(outcome.status, 2) << outcome.err;
  EXPECT_FALSE(outcome.err.empty());
}
INSTANTIATE_TEST_SUITE_P(
    OfTheWorkstation, UsageErrors,
    ::testing::Values(std::vector<std::string>{"--no-such-word"},
                      std::vector<std::string>{"--after", "3"},
                      std::vector<std::string>{"--screenshot", "window.jpg"},
                      std::vector<std::string>{"--screenshot", "w.png", "--after", "-1"},
                      std::vector<std::string>{"--screenshot", "w.png", "--after", "nan"},
                      std::vector<std::string>{"--screenshot", "w.png", "--after", "soon"},
                      std::vector<std::string>{"--scenario"},
                      std::vector<std::string>{"a-word-of-its-own"}));

TEST(PerilymphCall, WithAnEmptyValueIsRefusedAndTheOptionNamed)
{
  for (const std::string option : {"--scenario", "--record", "--device-plugin", "--screenshot",
                                   "--quality", "--language", "--ticks", "--after"}) {
    const auto outcome = perilymph({option, ""});
    EXPECT_EQ(outcome.status, 2) << option;
    EXPECT_THAT(outcome.err, ::testing::StartsWith(option + " is empty"));
    const auto assigned = perilymph({option + "=", "contour-published"});
    EXPECT_EQ(assigned.status, 2) << option;
    EXPECT_THAT(assigned.err, ::testing::StartsWith(option + " is empty"));
  }
}

}  // namespace
}  // namespace perilymph::test
